// The folder that a job writes to, and who may write there.
#ifndef TILEMEND_COORDINATOR_STORE_OUTPUT_FOLDER_H_
#define TILEMEND_COORDINATOR_STORE_OUTPUT_FOLDER_H_

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/grid/scene.h"
#include "coordinator/store/attempt_folder.h"
#include "coordinator/store/job_marker.h"
#include "coordinator/store/output_files.h"

namespace tilemend {

// Claims a folder for one job. While the job lives, its marker there (job_marker.h) is held. Until the output is
// complete it holds the job's key, so that the same job, run again, goes on there, and no other. (The key of a job that
// overwrites is there from its first tile on.) The files that workers write get their names from `files` alone.
//
// What is refused:
//  - a folder that holds anything but an unfinished output of the same job, unless it may be overwritten. Overwriting
//    replaces the files that this job writes; other files stay as they are.
//  - a folder that another living job writes to (kAborted), whatever it may overwrite.
//  - what is no regular file, or no folder, where the job would write one: it is the user's to take away.
//  - always: the scene's own folder, its folders of tiles and those that hold them (`Data`) with all below, and folders
//    whose `tiles` lead there over a link. Of tiles that were found by their names all that is below the scene's
//    folder.
class OutputFolder {
 public:
  // `key` says what makes two jobs the same (scene and options). kAlreadyExists, kInvalidArgument, kPermissionDenied,
  // kAborted, ...
  static absl::StatusOr<OutputFolder> Claim(const std::string& path, const Scene& scene, bool overwrite,
                                            const std::string& key);
  OutputFolder(OutputFolder&& other) noexcept;
  OutputFolder& operator=(OutputFolder&&) = delete;
  // Takes away what Claim made, unless there is output. What attempts wrote for an unfinished output stays then: the
  // same job, run again, may know them as done.
  ~OutputFolder();

  const std::string& path() const { return path_; }
  // Where workers write, from Claim to Finish.
  const AttemptFolder& attempts() const { return *attempts_; }
  OutputFiles& files() { return files_; }
  // Whether nothing is in the way of these files, relative. kInvalidArgument says what to remove.
  absl::Status CheckRoomFor(const std::set<std::string>& files) const;
  // From now on there is output in the folder: the marker stays until Finish. Takes away the report of an older output
  // and what goes with it, which would not be true any more. kResourceExhausted, kPermissionDenied.
  absl::Status BeginWriting();
  // Whether a complete output lies there.
  bool has_report() const;
  // Where results are kept for the jobs that come after (ResultLog). Stays when the job ends, however it ends.
  std::string result_log() const;
  // The output is complete.
  void Finish();

 private:
  OutputFolder(std::string path, std::string key) : path_(path), key_(std::move(key)), files_(std::move(path)) {}

  std::string path_;
  std::string key_;
  OutputFiles files_;
  std::vector<std::string> made_;          // folders, the outermost first
  std::unique_ptr<JobMarker> marker_;      // while the folder is claimed
  bool keep_ = false;                      // the marker is to stay
  bool wrote_ = false;                     // this process
  std::optional<AttemptFolder> attempts_;  // while the folder is claimed
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_STORE_OUTPUT_FOLDER_H_
