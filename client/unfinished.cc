#include "client/unfinished.h"

#include <filesystem>
#include <system_error>

#include "absl/strings/str_cat.h"
#include "common/util/object_store.h"

namespace tilemend {

namespace {

bool HasFile(const std::string& folder, const char* name) {
  std::error_code error;
  return std::filesystem::exists(std::filesystem::path(folder) / name, error);
}

}  // namespace

// A job that overwrites a complete output has its marker there, and leaves the report until its first tile.
bool IsUnfinished(const std::string& output) {
  return (HasFile(output, ".tilemend-job") || IsOutput(output)) && !HasFile(output, "report.json");
}

bool IsOutput(const std::string& folder) { return HasFile(folder, ".tilemend-results"); }

absl::Status CheckFinished(const std::string& output) {
  if (!IsUnfinished(output)) return absl::OkStatus();
  return absl::NotFoundError(absl::StrCat(
      output, ": report.json is not there yet; the output is not complete. Run the same job again to complete it"));
}

absl::Status CheckHasReport(const std::string& output, const std::string& scene) {
  if (IsObjectPath(output) || HasFile(output, "report.json")) return absl::OkStatus();
  std::error_code error;
  if (!std::filesystem::exists(output, error)) return absl::NotFoundError(absl::StrCat(output, ": no such folder"));
  if (!std::filesystem::is_directory(output, error)) return absl::NotFoundError(absl::StrCat(output, ": not a folder"));
  if (absl::Status status = CheckFinished(output); !status.ok()) return status;
  std::string message = absl::StrCat(output, ": no output of `tilemend run` (it has no report.json)");
  if (!scene.empty() && (IsOutput(scene) || HasFile(scene, "report.json"))) {
    absl::StrAppend(&message, "; ", scene, " is one: give the scene first, then its output");
  }
  return absl::NotFoundError(message);
}

}  // namespace tilemend
