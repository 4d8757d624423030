// Opening files and the folders that hold them, below the roots of the process (roots.h) if it has any. For files.h and
// folders.h, which are what others use.
#ifndef TILEMEND_COMMON_UTIL_PLACE_H_
#define TILEMEND_COMMON_UTIL_PLACE_H_

#include <sys/types.h>

#include <string>
#include <string_view>

#include "absl/status/status.h"

namespace tilemend {

// The status for an errno; its text is "PATH: WHAT: why".
absl::Status ErrnoStatus(int error, std::string_view what, const std::string& path);
// Of a file that is to be made: what is missing there is not a file of the user's, but a place to write to.
absl::Status WriteErrnoStatus(int error, std::string_view what, const std::string& path);

// Closes a descriptor at the end of its scope.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  ~Descriptor();
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return fd_; }
  // Closes now, so that a late write error is seen.
  int Close();

 private:
  int fd_;
};

// As open(2), below the roots. -1 with errno, which is EXDEV for what is not below them.
int OpenKept(const std::string& path, int flags, mode_t mode = 0);

// The folder that holds a path, opened, and the path's name in it. It is for the calls that end in -at, which follow no
// link in a name. Where nothing is confined, the path as it is.
struct Place {
  explicit Place(const std::string& path);
  bool ok() const { return !confined || folder.get() >= 0; }
  int at() const;

  const bool confined;
  const Descriptor folder;
  const int error;  // why it is not ok
  const std::string name;
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_UTIL_PLACE_H_
