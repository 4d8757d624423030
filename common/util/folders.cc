#include "common/util/folders.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <memory>

#include "absl/strings/str_cat.h"
#include "common/util/object_store.h"
#include "common/util/place.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

PathKind KindOfMode(mode_t mode) {
  if (S_ISREG(mode)) return PathKind::kFile;
  return S_ISDIR(mode) ? PathKind::kFolder : PathKind::kOther;
}

// The names in an open folder, which it takes. Gives 0 or an errno.
int NamesIn(int folder, std::vector<std::string>& names) {
  const std::unique_ptr<DIR, int (*)(DIR*)> entries(::fdopendir(folder), ::closedir);
  if (entries == nullptr) {
    const int error = errno;
    ::close(folder);
    return error;
  }
  errno = 0;
  while (const dirent* const entry = ::readdir(entries.get())) {
    const std::string name = entry->d_name;
    if (name != "." && name != "..") names.push_back(name);
    errno = 0;
  }
  std::sort(names.begin(), names.end());
  return errno;
}

// Gives 0 or an errno.
int RemoveTreeAt(int at, const std::string& name) {
  if (::unlinkat(at, name.c_str(), 0) == 0 || errno == ENOENT) return 0;
  if (errno != EISDIR && errno != EPERM) return errno;
  const int folder = ::openat(at, name.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (folder < 0) return errno;
  const Descriptor kept(::dup(folder));
  std::vector<std::string> names;
  if (const int error = NamesIn(folder, names); error != 0) return error;
  for (const std::string& entry : names) {
    if (const int error = RemoveTreeAt(kept.get(), entry); error != 0) return error;
  }
  return ::unlinkat(at, name.c_str(), AT_REMOVEDIR) == 0 || errno == ENOENT ? 0 : errno;
}

// An object, or a folder of objects.
absl::StatusOr<PathLook> LookAtObject(const std::string& path) {
  TILEMEND_ASSIGN_OR_RETURN(ObjectStore* const objects, ObjectsFor(path));
  const auto look = objects->Look(path);
  if (look.ok()) return PathLook{PathKind::kFile, look->size};
  if (!absl::IsNotFound(look.status())) return look.status();
  TILEMEND_RETURN_IF_ERROR(objects->List(path).status());
  return PathLook{PathKind::kFolder, 0};
}

absl::StatusOr<std::vector<ObjectEntry>> ListObjects(const std::string& path) {
  TILEMEND_ASSIGN_OR_RETURN(ObjectStore* const objects, ObjectsFor(path));
  return objects->List(path);
}

absl::Status RemoveObjects(const std::string& path) {
  TILEMEND_ASSIGN_OR_RETURN(ObjectStore* const objects, ObjectsFor(path));
  const auto entries = objects->List(path);
  if (absl::IsNotFound(entries.status())) return objects->Remove(path);
  TILEMEND_RETURN_IF_ERROR(entries.status());
  for (const ObjectEntry& entry : *entries) {
    const std::string below = absl::StrCat(path, "/", entry.name);
    TILEMEND_RETURN_IF_ERROR(entry.is_folder ? RemoveObjects(below) : objects->Remove(below));
  }
  return absl::OkStatus();
}

absl::Status Unlink(const std::string& path, int flags) {
  const Place place(path);
  const bool done = place.ok() && ::unlinkat(place.at(), place.name.c_str(), flags) == 0;
  const int error = place.ok() ? errno : place.error;
  return done || error == ENOENT ? absl::OkStatus() : ErrnoStatus(error, "cannot remove", path);
}

}  // namespace

absl::StatusOr<PathLook> LookAt(const std::string& path, Links links) {
  if (IsObjectPath(path)) return LookAtObject(path);
  const Descriptor file(OpenKept(path, O_PATH | O_CLOEXEC | (links == Links::kKeep ? O_NOFOLLOW : 0)));
  struct stat info {};
  if (file.get() < 0 || ::fstat(file.get(), &info) != 0) return ErrnoStatus(errno, "cannot look at it", path);
  return PathLook{KindOfMode(info.st_mode), info.st_size};
}

absl::StatusOr<PathKind> FindKind(const std::string& path, Links links) {
  const auto look = LookAt(path, links);
  if (look.ok()) return look->kind;
  if (absl::IsNotFound(look.status())) return PathKind::kNothing;
  return look.status();
}

PathKind KindOf(const std::string& path) {
  const auto look = LookAt(path);
  return look.ok() ? look->kind : PathKind::kNothing;
}

absl::StatusOr<std::vector<std::string>> ListFolder(const std::string& path) {
  if (IsObjectPath(path)) {
    TILEMEND_ASSIGN_OR_RETURN(const auto entries, ListObjects(path));
    std::vector<std::string> names;
    for (const ObjectEntry& entry : entries) names.push_back(entry.name);
    return names;
  }
  const int folder = OpenKept(path, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder < 0) return ErrnoStatus(errno, "cannot list", path);
  std::vector<std::string> names;
  if (const int error = NamesIn(folder, names); error != 0) return ErrnoStatus(error, "cannot list", path);
  return names;
}

absl::StatusOr<std::vector<FolderEntry>> ListKinds(const std::string& path) {
  std::vector<FolderEntry> kinds;
  if (IsObjectPath(path)) {
    TILEMEND_ASSIGN_OR_RETURN(const auto entries, ListObjects(path));
    for (const ObjectEntry& entry : entries) {
      kinds.push_back({entry.name, entry.is_folder ? PathKind::kFolder : PathKind::kFile});
    }
    return kinds;
  }
  TILEMEND_ASSIGN_OR_RETURN(const auto names, ListFolder(path));
  for (const std::string& name : names) {
    // A link out of the roots is nothing, as elsewhere.
    const auto kind = FindKind(absl::StrCat(path, "/", name));
    if (!kind.ok() && absl::IsUnavailable(kind.status())) return kind.status();
    kinds.push_back({name, kind.value_or(PathKind::kNothing)});
  }
  return kinds;
}

absl::Status MakeFolder(const std::string& path) {
  if (IsObjectPath(path)) return ObjectsFor(path).status();
  const Place place(path);
  if (place.ok() && ::mkdirat(place.at(), place.name.c_str(), 0777) == 0) return absl::OkStatus();
  const int error = place.ok() ? errno : place.error;
  if (error == EEXIST && KindOf(path) == PathKind::kFolder) return absl::OkStatus();
  return WriteErrnoStatus(error, "cannot make the folder", path);
}

bool CanWriteIn(const std::string& folder) {
  if (IsObjectPath(folder)) return KindOf(folder) == PathKind::kFolder;
  const Descriptor opened(OpenKept(folder, O_PATH | O_DIRECTORY | O_CLOEXEC));
  return opened.get() >= 0 && ::faccessat(opened.get(), ".", W_OK, 0) == 0;
}

absl::Status RemoveFile(const std::string& path) {
  if (!IsObjectPath(path)) return Unlink(path, 0);
  TILEMEND_ASSIGN_OR_RETURN(ObjectStore* const objects, ObjectsFor(path));
  return objects->Remove(path);
}

absl::Status RemoveEmptyFolder(const std::string& path) {
  return IsObjectPath(path) ? absl::OkStatus() : Unlink(path, AT_REMOVEDIR);
}

absl::Status RemoveTree(const std::string& path) {
  if (IsObjectPath(path)) return RemoveObjects(path);
  const Place place(path);
  const int error = place.ok() ? RemoveTreeAt(place.at(), place.name) : place.error;
  return error == 0 || error == ENOENT ? absl::OkStatus() : ErrnoStatus(error, "cannot remove", path);
}

}  // namespace tilemend
