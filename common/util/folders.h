// Folders and what lies in them: looked at, listed, made and removed. In a process that is confined to some folders
// (roots.h) all of that is relative to them. What a path or a link leads out to is treated as missing, and stays as it
// is.
#ifndef TILEMEND_COMMON_UTIL_FOLDERS_H_
#define TILEMEND_COMMON_UTIL_FOLDERS_H_

#include <cstdint>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"

namespace tilemend {

enum class PathKind { kNothing, kFile, kFolder, kOther };  // kOther: a device, or a link that is not followed

struct PathLook {
  PathKind kind = PathKind::kNothing;
  int64_t size = 0;  // bytes, of a file
};

enum class Links { kFollow, kKeep };

// What is at `path`. kNotFound, kPermissionDenied; the message names the path.
absl::StatusOr<PathLook> LookAt(const std::string& path, Links links = Links::kFollow);
// What a path is, with kNothing where there is nothing. Other errors of LookAt: what cannot be looked at, as on a mount
// or in a store that fails, may be there.
absl::StatusOr<PathKind> FindKind(const std::string& path, Links links = Links::kFollow);
// The same, with kNothing for all errors: for what does no harm if it is wrong.
PathKind KindOf(const std::string& path);

// The names in a folder, sorted: all of them, or an error. kNotFound, kPermissionDenied, kUnavailable.
absl::StatusOr<std::vector<std::string>> ListFolder(const std::string& path);

// The same with what each name is, in one request where objects are listed.
struct FolderEntry {
  std::string name;
  PathKind kind = PathKind::kNothing;
};
absl::StatusOr<std::vector<FolderEntry>> ListKinds(const std::string& path);

// Makes one folder, whose parent must be there; one that is there already is no error. Errors as WriteFileAtomically.
absl::Status MakeFolder(const std::string& path);
// Whether files may be made in a folder.
bool CanWriteIn(const std::string& folder);

// What is not there is no error, here and below. A link is removed itself.
absl::Status RemoveFile(const std::string& path);
absl::Status RemoveEmptyFolder(const std::string& path);
// A folder with everything in it.
absl::Status RemoveTree(const std::string& path);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_UTIL_FOLDERS_H_
