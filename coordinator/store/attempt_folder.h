// Where workers write the files of an output before they get their names.
#ifndef TILEMEND_COORDINATOR_STORE_ATTEMPT_FOLDER_H_
#define TILEMEND_COORDINATOR_STORE_ATTEMPT_FOLDER_H_

#include <cstdint>
#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"

namespace tilemend {

// A file that an attempt wrote.
struct AttemptFile {
  std::string attempt;  // its name among the attempts
  std::string path;     // where it is to go, relative to the output's folder
  int64_t bytes = 0;
  std::string digest = {};  // FileDigest, "" where it is not known
};

inline constexpr char kAttemptFolder[] = ".tilemend-attempts";

// A hidden folder in the output's folder, with a file `key` that holds a random number: who can tell it sees this
// folder, and no other of the same name. Attempts write there under names of their own and never make a folder, so that
// one that wakes after the output is complete can write nowhere.
class AttemptFolder {
 public:
  // Makes the folder, or goes on with the one that an unfinished job has left, its key and what was written there.
  // kPermissionDenied, kResourceExhausted, ...
  static absl::StatusOr<AttemptFolder> Make(const std::string& output);

  const std::string& path() const { return path_; }
  std::string key_file() const { return path_ + "/key"; }

  // OK if the file is there with its size. kInvalidArgument for a name that no attempt has, kDataLoss if it is not
  // there or has another size, kUnavailable if this machine does not see the folder itself.
  static absl::Status Check(const std::string& attempts, const AttemptFile& file);

  // Removes a file that nobody needs. Nothing for a name that no attempt has.
  static void Discard(const std::string& attempts, const std::string& name);

  // Gives the file its final name in `output`. One that is gone from a folder that still has its key, while a file of
  // its size has its final name, was placed by an earlier process. Else kUnavailable.
  absl::Status Place(const AttemptFile& file, const std::string& output) const;

  // Takes the folder away with all that is in it.
  void Remove() const;

 private:
  explicit AttemptFolder(std::string path) : path_(std::move(path)) {}
  std::string path_;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_STORE_ATTEMPT_FOLDER_H_
