#include "coordinator/journal/work_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"
#include "common/util/error_info.h"

namespace tilemend {
namespace {

absl::Status CannotLock(const std::string& folder, const std::string& what, int error) {
  return absl::PermissionDeniedError(
      absl::StrCat(folder, ": ", what, ": ", std::strerror(error), "; choose another --work"));
}

absl::Status InUse(const std::string& folder, int fd) {
  std::array<char, 32> text{};
  const ssize_t size = ::pread(fd, text.data(), text.size() - 1, 0);
  const std::string process(absl::StripAsciiWhitespace({text.data(), size > 0 ? static_cast<size_t>(size) : 0}));
  const std::string who =
      process.empty() ? "another coordinator" : absl::StrCat("the coordinator of process ", process);
  return WithErrorInfo(
      absl::AbortedError(absl::StrCat(folder, ": ", who, " works in this folder; end it, or choose another --work")),
      {"WORK_IN_USE", {{"folder", folder}, {"process", process}}});
}

}  // namespace

absl::StatusOr<WorkLock> WorkLock::Take(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return CannotLock(folder, "cannot make the folder", error.value());
  const std::string path = absl::StrCat(folder, "/lock");
  const int fd = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0644);
  if (fd < 0) return CannotLock(folder, "cannot make a file in it", errno);
  WorkLock lock(fd);
  if (::flock(fd, LOCK_EX | LOCK_NB) != 0) {
    // Without a lock two coordinators could write one journal: a file system that has none will not do.
    return errno == EWOULDBLOCK ? InUse(folder, fd) : CannotLock(folder, "cannot lock it", errno);
  }
  const std::string process = absl::StrCat(::getpid(), "\n");
  const auto size = static_cast<ssize_t>(process.size());
  if (::ftruncate(fd, 0) != 0 || ::pwrite(fd, process.data(), process.size(), 0) != size) {
    return CannotLock(folder, "cannot write to it", errno);
  }
  return lock;
}

WorkLock::~WorkLock() {
  if (fd_ >= 0) ::close(fd_);
}

}  // namespace tilemend
