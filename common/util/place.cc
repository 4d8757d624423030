#include "common/util/place.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "absl/strings/str_cat.h"
#include "common/util/object_store.h"
#include "common/util/roots.h"

namespace tilemend {

absl::Status ErrnoStatus(int error, std::string_view what, const std::string& path) {
  const std::string text = absl::StrCat(path, ": ", std::string(what), ": ", std::strerror(error));
  switch (error) {
    case ENOENT:
    case ENOTDIR:
      return absl::NotFoundError(text);
    case EACCES:
    case EPERM:
    case EROFS:
      return absl::PermissionDeniedError(text);
    case EXDEV:
      return absl::PermissionDeniedError(
          absl::StrCat(path, ": not below a folder that may be used (--root), or led out of it by a link"));
    case ENOTSUP:
      return absl::UnimplementedError(IsObjectPath(path) ? absl::StrCat(text, " of objects") : text);
    case ENAMETOOLONG:
    case ELOOP:
    case EISDIR:
      return absl::InvalidArgumentError(text);
    case ENOSPC:
    case EDQUOT:
      return absl::ResourceExhaustedError(absl::StrCat(text, "; make room there"));
    case EMFILE:
    case ENFILE:
    case ENOMEM:
    case EFBIG:  // a limit of file sizes (ulimit -f), or of the file system
      return absl::ResourceExhaustedError(text);
    case EIO:
    case ESTALE:  // the disk's or the mount's failure: it may be another one's turn, or work later
      return absl::UnavailableError(text);
    default:
      return absl::InternalError(text);
  }
}

absl::Status WriteErrnoStatus(int error, std::string_view what, const std::string& path) {
  const absl::Status status = ErrnoStatus(error, what, path);
  if (error == ENOTDIR || error == EEXIST) return absl::InvalidArgumentError(status.message());
  return absl::IsNotFound(status) ? absl::PermissionDeniedError(status.message()) : status;
}

Descriptor::~Descriptor() {
  if (fd_ >= 0) ::close(fd_);
}

int Descriptor::Close() {
  const int result = ::close(fd_);
  fd_ = -1;
  return result;
}

int OpenKept(const std::string& path, int flags, mode_t mode) {
  if (IsObjectPath(path)) {
    errno = ENOTSUP;
    return -1;
  }
  const Roots* const roots = FilesRoots();
  return roots == nullptr ? ::open(path.c_str(), flags, mode) : roots->OpenFile(path, flags, mode);
}

Place::Place(const std::string& path)
    : confined(FilesRoots() != nullptr),
      folder(confined ? OpenKept(std::filesystem::path(path).parent_path(), O_PATH | O_DIRECTORY | O_CLOEXEC) : -1),
      error(errno),
      name(confined ? std::filesystem::path(path).filename().string() : path) {}

int Place::at() const { return confined ? folder.get() : AT_FDCWD; }

}  // namespace tilemend
