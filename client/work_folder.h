// The folder of one process for what it needs while it runs.
#ifndef TILEMEND_CLIENT_WORK_FOLDER_H_
#define TILEMEND_CLIENT_WORK_FOLDER_H_

#include <string>

#include "absl/status/statusor.h"

namespace tilemend {

// Goes away with all that is in it when it is destroyed, and when the process ends for want of memory or threads
// (EndOnShortage). The next one that is made removes a folder beside it that a killed process left. That is one with
// a mark in it, of the same user, that nobody has locked. One at a time in a process.
class WorkFolder {
 public:
  // In `parent`, which is made if it is missing; empty: in the system's folder for such things. kPermissionDenied.
  static absl::StatusOr<WorkFolder> Make(const std::string& parent);
  WorkFolder(WorkFolder&& other) noexcept;
  WorkFolder& operator=(WorkFolder&&) = delete;
  ~WorkFolder();

  const std::string& path() const { return path_; }

 private:
  WorkFolder(std::string path, int lock);

  std::string path_;
  int lock_;  // descriptor of the folder
};

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_WORK_FOLDER_H_
