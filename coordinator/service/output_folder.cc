#include "coordinator/service/output_folder.h"

#include <filesystem>
#include <system_error>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/util/files.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

namespace fs = std::filesystem;

constexpr char kMarker[] = ".tilemend-job";

// Whether the folder holds nothing, or an unfinished output of the job `key`.
absl::Status CheckVacant(const std::string& path, const std::string& key) {
  std::error_code error;
  const auto status = fs::status(path, error);
  if (!fs::exists(status)) return absl::OkStatus();
  if (!fs::is_directory(status)) return absl::InvalidArgumentError(absl::StrCat(path, ": the output is no folder"));
  const bool empty = fs::is_empty(path, error);
  if (error) return absl::PermissionDeniedError(absl::StrCat(path, ": ", error.message()));
  if (empty) return absl::OkStatus();
  const auto marker = ReadFile(absl::StrCat(path, "/", kMarker));
  if (marker.ok() && *marker == key) return absl::OkStatus();
  return absl::AlreadyExistsError(absl::StrCat(
      path, ": is there already", marker.ok() ? ", unfinished, of a job with another scene or other options" : "",
      "; choose another --out, or give --overwrite to replace it"));
}

bool SameFolder(const std::string& a, const std::string& b) {
  std::error_code error;
  const bool same = fs::equivalent(a, b, error);
  return (!error && same) || fs::weakly_canonical(a, error) == fs::weakly_canonical(b, error);
}

}  // namespace

absl::StatusOr<OutputFolder> OutputFolder::Claim(const std::string& path, const std::string& scene_root, bool overwrite,
                                                 const std::string& key) {
  if (SameFolder(path, scene_root)) {
    return absl::InvalidArgumentError(
        absl::StrCat(path, ": the output would be written over the scene; choose another --out"));
  }
  if (!overwrite) TILEMEND_RETURN_IF_ERROR(CheckVacant(path, key));
  std::error_code error;
  const bool existed = fs::exists(path, error);
  OutputFolder folder(path, !existed);
  TILEMEND_RETURN_IF_ERROR(WriteFileAtomically(folder.Marker(), key));
  return folder;
}

OutputFolder::OutputFolder(OutputFolder&& other) noexcept
    : path_(std::exchange(other.path_, "")), made_(other.made_), keep_(other.keep_) {}

OutputFolder::~OutputFolder() {
  if (path_.empty() || keep_) return;
  std::error_code error;
  fs::remove(Marker(), error);
  if (made_) fs::remove(path_, error);  // only if it is empty
}

std::string OutputFolder::Marker() const { return absl::StrCat(path_, "/", kMarker); }

void OutputFolder::Finish() {
  std::error_code error;
  fs::remove(Marker(), error);
  keep_ = true;
}

}  // namespace tilemend
