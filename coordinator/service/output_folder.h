// The folder that a job writes to, and who may write there.
#ifndef TILEMEND_COORDINATOR_SERVICE_OUTPUT_FOLDER_H_
#define TILEMEND_COORDINATOR_SERVICE_OUTPUT_FOLDER_H_

#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"

namespace tilemend {

// Claims a folder for one job. A folder that holds anything but an unfinished output of the same job is refused unless
// it may be overwritten; the scene's own folder is refused always. An unfinished output is marked by a file
// `.tilemend-job` with the job's key, so that the same job, run again, goes on there.
class OutputFolder {
 public:
  // `key` says what makes two jobs the same (scene and options). kAlreadyExists, kInvalidArgument, kPermissionDenied,
  // ...
  static absl::StatusOr<OutputFolder> Claim(const std::string& path, const std::string& scene_root, bool overwrite,
                                            const std::string& key);
  OutputFolder(OutputFolder&& other) noexcept;
  OutputFolder& operator=(OutputFolder&&) = delete;
  // Takes the marker away again, and the folder if Claim made it, unless KeepUnfinished or Finish was called.
  ~OutputFolder();

  const std::string& path() const { return path_; }
  // From now on there is output in the folder: the marker stays until Finish.
  void KeepUnfinished() { keep_ = true; }
  // The output is complete.
  void Finish();

 private:
  OutputFolder(std::string path, bool made) : path_(std::move(path)), made_(made) {}
  std::string Marker() const;

  std::string path_;
  bool made_ = false;
  bool keep_ = false;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_SERVICE_OUTPUT_FOLDER_H_
