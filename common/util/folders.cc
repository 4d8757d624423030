#include "common/util/folders.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <memory>

#include "common/util/place.h"

namespace tilemend {
namespace {

PathKind KindOfMode(mode_t mode) {
  if (S_ISREG(mode)) return PathKind::kFile;
  return S_ISDIR(mode) ? PathKind::kFolder : PathKind::kOther;
}

// The names in an open folder, which it takes.
std::vector<std::string> NamesIn(int folder) {
  const std::unique_ptr<DIR, int (*)(DIR*)> entries(::fdopendir(folder), ::closedir);
  std::vector<std::string> names;
  if (entries == nullptr) return names;
  while (const dirent* const entry = ::readdir(entries.get())) {
    const std::string name = entry->d_name;
    if (name != "." && name != "..") names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

// Gives 0 or an errno.
int RemoveTreeAt(int at, const std::string& name) {
  if (::unlinkat(at, name.c_str(), 0) == 0 || errno == ENOENT) return 0;
  if (errno != EISDIR && errno != EPERM) return errno;
  const int folder = ::openat(at, name.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (folder < 0) return errno;
  const Descriptor kept(::dup(folder));
  for (const std::string& entry : NamesIn(folder)) {
    if (const int error = RemoveTreeAt(kept.get(), entry); error != 0) return error;
  }
  return ::unlinkat(at, name.c_str(), AT_REMOVEDIR) == 0 || errno == ENOENT ? 0 : errno;
}

absl::Status Unlink(const std::string& path, int flags) {
  const Place place(path);
  const bool done = place.ok() && ::unlinkat(place.at(), place.name.c_str(), flags) == 0;
  const int error = place.ok() ? errno : place.error;
  return done || error == ENOENT ? absl::OkStatus() : ErrnoStatus(error, "cannot remove", path);
}

}  // namespace

absl::StatusOr<PathLook> LookAt(const std::string& path, Links links) {
  const Descriptor file(OpenKept(path, O_PATH | O_CLOEXEC | (links == Links::kKeep ? O_NOFOLLOW : 0)));
  struct stat info {};
  if (file.get() < 0 || ::fstat(file.get(), &info) != 0) return ErrnoStatus(errno, "cannot look at it", path);
  return PathLook{KindOfMode(info.st_mode), info.st_size};
}

PathKind KindOf(const std::string& path) {
  const auto look = LookAt(path);
  return look.ok() ? look->kind : PathKind::kNothing;
}

absl::StatusOr<std::vector<std::string>> ListFolder(const std::string& path) {
  const int folder = OpenKept(path, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder < 0) return ErrnoStatus(errno, "cannot list", path);
  return NamesIn(folder);
}

absl::Status MakeFolder(const std::string& path) {
  const Place place(path);
  if (place.ok() && ::mkdirat(place.at(), place.name.c_str(), 0777) == 0) return absl::OkStatus();
  const int error = place.ok() ? errno : place.error;
  if (error == EEXIST && KindOf(path) == PathKind::kFolder) return absl::OkStatus();
  return WriteErrnoStatus(error, "cannot make the folder", path);
}

bool CanWriteIn(const std::string& folder) {
  const Descriptor opened(OpenKept(folder, O_PATH | O_DIRECTORY | O_CLOEXEC));
  return opened.get() >= 0 && ::faccessat(opened.get(), ".", W_OK, 0) == 0;
}

absl::Status RemoveFile(const std::string& path) { return Unlink(path, 0); }

absl::Status RemoveEmptyFolder(const std::string& path) { return Unlink(path, AT_REMOVEDIR); }

absl::Status RemoveTree(const std::string& path) {
  const Place place(path);
  const int error = place.ok() ? RemoveTreeAt(place.at(), place.name) : place.error;
  return error == 0 || error == ENOENT ? absl::OkStatus() : ErrnoStatus(error, "cannot remove", path);
}

}  // namespace tilemend
