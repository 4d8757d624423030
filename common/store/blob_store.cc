#include "common/store/blob_store.h"

#include <filesystem>
#include <system_error>

#include "absl/strings/str_cat.h"
#include "common/store/digest.h"
#include "common/util/files.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

namespace fs = std::filesystem;

absl::Status FileError(const std::error_code& error, const std::string& path) {
  const std::string text = absl::StrCat(path, ": ", error.message());
  if (error == std::errc::permission_denied || error == std::errc::operation_not_permitted ||
      error == std::errc::read_only_file_system) {
    return absl::PermissionDeniedError(text);
  }
  return absl::InternalError(text);
}

}  // namespace

absl::StatusOr<BlobStore> BlobStore::Open(const std::string& folder) {
  std::error_code ignored;
  if (fs::exists(folder, ignored) && !fs::is_directory(folder, ignored)) {
    return absl::InvalidArgumentError(absl::StrCat(folder, ": not a folder"));
  }
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return FileError(error, folder);
  return BlobStore(folder);
}

absl::StatusOr<std::string> BlobStore::PathOf(const std::string& digest) const {
  if (!IsDigest(digest)) {
    return absl::InvalidArgumentError(
        absl::StrCat("not a digest (64 hexadecimal digits): \"", digest.substr(0, 80), "\""));
  }
  return absl::StrCat(folder_, "/", digest.substr(0, 2), "/", digest.substr(2));
}

absl::StatusOr<std::string> BlobStore::Put(std::string_view bytes) const {
  std::string digest = Sha256Hex(bytes);
  TILEMEND_ASSIGN_OR_RETURN(const std::string path, PathOf(digest));
  // Written even if it is there: the write repairs a torn blob, and equal puts are rare.
  TILEMEND_RETURN_IF_ERROR(WriteFileAtomically(path, bytes, Sync::kNo));
  return digest;
}

absl::StatusOr<std::string> BlobStore::Get(const std::string& digest) const {
  TILEMEND_ASSIGN_OR_RETURN(const std::string path, PathOf(digest));
  TILEMEND_ASSIGN_OR_RETURN(std::string bytes, ReadFile(path));
  if (Sha256Hex(bytes) != digest) {
    return absl::DataLossError(absl::StrCat(path, ": the ", bytes.size(), " bytes do not have this digest"));
  }
  return bytes;
}

absl::StatusOr<bool> BlobStore::Contains(const std::string& digest) const {
  TILEMEND_ASSIGN_OR_RETURN(const std::string path, PathOf(digest));
  std::error_code error;
  const bool found = fs::is_regular_file(path, error);
  if (error && error != std::errc::no_such_file_or_directory) return FileError(error, path);
  return found;
}

absl::Status BlobStore::Remove(const std::string& digest) const {
  TILEMEND_ASSIGN_OR_RETURN(const std::string path, PathOf(digest));
  std::error_code error;
  fs::remove(path, error);
  return error ? FileError(error, path) : absl::OkStatus();
}

}  // namespace tilemend
