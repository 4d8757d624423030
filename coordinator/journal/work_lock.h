// The lock on a coordinator's work folder.
#ifndef TILEMEND_COORDINATOR_JOURNAL_WORK_LOCK_H_
#define TILEMEND_COORDINATOR_JOURNAL_WORK_LOCK_H_

#include <string>
#include <utility>

#include "absl/status/statusor.h"

namespace tilemend {

// Holds a folder for this process; ends with it, however it ends.
class WorkLock {
 public:
  // Makes the folder if it is missing. Returns kAborted (WORK_IN_USE), naming the folder and the process, if another
  // holds it. Returns kPermissionDenied if there cannot be a folder, a file or a lock.
  static absl::StatusOr<WorkLock> Take(const std::string& folder);
  WorkLock(WorkLock&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  WorkLock& operator=(WorkLock&&) = delete;
  ~WorkLock();

 private:
  explicit WorkLock(int fd) : fd_(fd) {}
  int fd_;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOURNAL_WORK_LOCK_H_
