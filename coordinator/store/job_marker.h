// The file `.tilemend-job` in the folder of an output: who writes there.
#ifndef TILEMEND_COORDINATOR_STORE_JOB_MARKER_H_
#define TILEMEND_COORDINATOR_STORE_JOB_MARKER_H_

#include <memory>
#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"

namespace tilemend {

// Held by one job at a time. In a folder the file is locked, against every process on every machine that the file
// system has locks for. An object has no lock: there it is held against other jobs of this process alone.
class JobMarker {
 public:
  virtual ~JobMarker() = default;

  // Makes the marker in `folder`, which must be there, or takes the one that an unfinished output has left. kAborted
  // (OUTPUT_IN_USE) if another job has it, kPermissionDenied, kResourceExhausted, ...
  static absl::StatusOr<std::unique_ptr<JobMarker>> Take(const std::string& folder);

  // Whether it held a key when it was taken: that of an unfinished output.
  bool had_key() const { return had_key_; }
  // Never empty in between: a job that is interrupted here and run again would not know its output.
  virtual absl::Status Write(const std::string& key) = 0;
  // Takes the marker away; who waits for it may have it then.
  virtual void Remove() = 0;

 protected:
  bool had_key_ = false;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_STORE_JOB_MARKER_H_
