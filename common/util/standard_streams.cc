#include "common/util/standard_streams.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>

#include "common/util/place.h"

namespace tilemend {
namespace {

bool ReaderHasGone() {
  pollfd output{STDOUT_FILENO, POLLOUT, 0};
  return poll(&output, 1, 0) == 1 && (output.revents & (POLLERR | POLLHUP)) != 0;
}

}  // namespace

void OpenStandardStreams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    // The lowest number that is free, which is this one.
    if (fcntl(stream, F_GETFD) < 0 && errno == EBADF) open("/dev/null", O_RDWR);  // NOLINT(android-cloexec-open)
  }
}

absl::Status FlushOutput() {
  const bool failed_before = std::ferror(stdout) != 0;
  errno = 0;
  if (std::fflush(stdout) == 0 && !failed_before) return absl::OkStatus();
  if (errno == EPIPE || ReaderHasGone()) return absl::OkStatus();
  if (errno != 0) return WriteErrnoStatus(errno, "cannot write", "standard output");
  return absl::InternalError("standard output: cannot write all of it");  // of an error before, no more is known
}

size_t ColumnsOfTerminal(int fd) {
  winsize size{};
  return ioctl(fd, TIOCGWINSZ, &size) == 0 ? size.ws_col : 0;
}

size_t ColumnsOfHelp(int fd) {
  constexpr size_t kMost = 120, kWithoutTerminal = 100;
  const size_t columns = ColumnsOfTerminal(fd);
  return columns == 0 ? kWithoutTerminal : std::min(columns, kMost);
}

}  // namespace tilemend
