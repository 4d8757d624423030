// The files of an output: which they are, how they get their names, and whether they are there.
#ifndef TILEMEND_COORDINATOR_STORE_OUTPUT_FILES_H_
#define TILEMEND_COORDINATOR_STORE_OUTPUT_FILES_H_

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "coordinator/store/attempt_folder.h"
#include "coordinator/store/job_notes.h"
#include "coordinator/store/own_files.h"

namespace tilemend {

inline constexpr char kResultLog[] = ".tilemend-results";  // in an output

// The folders below a root that hold `files`, relative, and the folders that hold these; "" if a file lies in the root.
std::set<std::string> FoldersOf(const std::set<std::string>& files);

class OutputFiles {
 public:
  explicit OutputFiles(std::string folder) : path_(std::move(folder)) {}

  // These files, relative, belong to this output as well.
  void Adopt(const std::set<std::string>& files);
  // From now on Place leaves a file that others put there as it is. kAlreadyExists (OUTPUT_EXISTS) if it is not the
  // same. A file that this job put there is replaced, also by another process of it that has the same notes.
  void LeaveFiles(std::shared_ptr<JobNotes> notes) { own_.emplace(std::move(notes)); }
  // Gives files of attempts their names. kInvalidArgument if one is none of this output's; errors of AttemptFolder.
  absl::Status Place(const std::vector<AttemptFile>& files, const AttemptFolder& attempts);
  // The files are there already, as they are to be. Errors as Place.
  absl::Status Keep(const std::vector<AttemptFile>& files);
  // Removes what lies where the job could not write a file of its own: it is of an earlier job. A file that the job
  // leaves to others stays.
  absl::Status RemoveUnwritten(const std::string& file) const;
  // Looks at every file that was placed, and has their names survive a power cut. Reads those with a digest that do not
  // look as they did then. kAborted if one is not there as it was placed, kCancelled if `ends`.
  absl::Status SeeAll(const std::function<bool()>& ends) const;
  // Removes what a killed coordinator left half-written (attempts go in Finish); gives the number of files and folders
  // there that are not of this output.
  int64_t TidyUp();

 private:
  struct Placed {
    int64_t bytes = -1;  // until it is placed
    std::string digest;
    std::string stamp;  // "" where it does not count
  };

  std::string path_;
  std::map<std::string, Placed> files_;  // relative
  std::optional<OwnFiles> own_;          // if it leaves those of others
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_STORE_OUTPUT_FILES_H_
