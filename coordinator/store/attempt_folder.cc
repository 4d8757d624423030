#include "coordinator/store/attempt_folder.h"

#include <algorithm>
#include <random>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "common/util/files.h"
#include "common/util/folders.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

constexpr int kTriesToRemove = 10;

std::string NewKey() {
  std::random_device random;
  return absl::StrFormat("%08x%08x%08x%08x", random(), random(), random(), random());
}

// Nothing that leads out of the folder, and not the key.
bool IsAttemptName(const std::string& name) {
  const auto is_fine = [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || c == '-'; };
  return name.size() >= 34 && name.size() <= 64 && std::all_of(name.begin(), name.end(), is_fine);
}

// The size of a regular file, -1 if there is none. kUnavailable if that cannot be seen.
absl::StatusOr<int64_t> SizeOf(const std::string& path) {
  const auto look = LookAt(path, Links::kKeep);
  if (look.ok()) return look->kind == PathKind::kFile ? look->size : -1;
  if (absl::IsNotFound(look.status())) return -1;
  return absl::UnavailableError(look.status().message());
}

}  // namespace

absl::StatusOr<AttemptFolder> AttemptFolder::Make(const std::string& output) {
  AttemptFolder folder(absl::StrCat(output, "/", kAttemptFolder));
  TILEMEND_ASSIGN_OR_RETURN(const int64_t key_size, SizeOf(folder.key_file()));
  if (key_size > 0) return folder;
  TILEMEND_RETURN_IF_ERROR(WriteFileAtomically(folder.key_file(), NewKey()));
  return folder;
}

absl::Status AttemptFolder::Check(const std::string& attempts, const AttemptFile& file) {
  if (!IsAttemptName(file.attempt)) return absl::InvalidArgumentError("a file under a name that no attempt has");
  const std::string path = absl::StrCat(attempts, "/", file.attempt);
  TILEMEND_ASSIGN_OR_RETURN(const int64_t size, SizeOf(path));
  if (size == file.bytes) return absl::OkStatus();
  TILEMEND_ASSIGN_OR_RETURN(const int64_t key_size, SizeOf(attempts + "/key"));
  if (key_size < 0) return absl::UnavailableError(absl::StrCat(attempts, ": the folder is gone"));
  if (size < 0) return absl::DataLossError(absl::StrCat("the file for ", file.path, " is not there"));
  return absl::DataLossError(
      absl::StrCat("the file for ", file.path, " has ", size, " bytes, and should have ", file.bytes));
}

void AttemptFolder::Discard(const std::string& attempts, const std::string& name) {
  if (IsAttemptName(name)) RemoveFile(absl::StrCat(attempts, "/", name)).IgnoreError();
}

absl::Status AttemptFolder::Place(const AttemptFile& file, const std::string& output) const {
  if (!IsAttemptName(file.attempt)) return absl::InvalidArgumentError("a file under a name that no attempt has");
  const std::string from = absl::StrCat(path_, "/", file.attempt), to = absl::StrCat(output, "/", file.path);
  const absl::Status status = MoveFile(from, to);
  if (!absl::IsNotFound(status)) return status;
  // Moved by an earlier process of the job; its content is for those that verify.
  TILEMEND_ASSIGN_OR_RETURN(const int64_t size, SizeOf(to));
  TILEMEND_ASSIGN_OR_RETURN(const int64_t key_size, SizeOf(key_file()));
  if (size == file.bytes && key_size > 0) return absl::OkStatus();
  return absl::UnavailableError(absl::StrCat(to, ": what was written for it is gone; run the job again"));
}

void AttemptFolder::Remove() const {
  // Once more where an attempt has just written there.
  for (int i = 0; i < kTriesToRemove && !RemoveTree(path_).ok(); ++i) {
  }
}

}  // namespace tilemend
