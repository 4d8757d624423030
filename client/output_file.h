// The one file that a command writes.
#ifndef TILEMEND_CLIENT_OUTPUT_FILE_H_
#define TILEMEND_CLIENT_OUTPUT_FILE_H_

#include <functional>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/util/signals.h"

namespace tilemend {

// Whether a command may write a file of that name, which `flag` gave. Returns kAlreadyExists if the file exists and
// `overwrite` is false. Returns kInvalidArgument if something that is no file has the name: a folder, a pipe, a device,
// a link to nothing.
absl::Status CheckOutputFile(const std::string& path, bool overwrite, const std::string& flag = "--out");

// Whether a file holds polygons, as those do that `inspect` writes: GeoJSON or a GeoPackage. So does an empty file, of
// which nothing is lost. Linear.
bool HoldsPolygons(const std::string& path);

// The same with what to do about it, where the place is what is wrong.
absl::Status WithOtherOut(const absl::Status& status);

// Holds the name of an output against other processes of this program, by a lock on a hidden file beside it. This
// object removes the file; one that a killed process left holds nothing. Makes missing folders, which go as well if
// nothing is in them. A file system without locks has to do without.
class OutputLock {
 public:
  // kAborted: another process has it. kPermissionDenied, kInvalidArgument, kResourceExhausted as WriteFileAtomically.
  static absl::StatusOr<OutputLock> Take(const std::string& path);
  ~OutputLock();
  // What the destructor does, before it.
  void Release();
  OutputLock(OutputLock&& other) noexcept;
  OutputLock& operator=(OutputLock&&) = delete;

 private:
  OutputLock() = default;

  std::vector<std::string> made_;  // folders, the outermost first
  std::string file_;
  int fd_ = -1;
};

// From now on the first SIGINT or SIGTERM ends the program: says so, calls `clean_up` on a thread of its own, and ends
// with kExitCancelled. Until `signals` is stopped, which is to be before the output is written: half of it would stay.
void CancelOnSignal(SignalWatcher& signals, const std::function<void()>& clean_up);

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_OUTPUT_FILE_H_
