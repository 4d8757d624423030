// How a worker shows that it sees the folders of a job.
#ifndef TILEMEND_COORDINATOR_JOBS_JOB_FOLDERS_H_
#define TILEMEND_COORDINATOR_JOBS_JOB_FOLDERS_H_

#include <string>
#include <vector>

#include "absl/status/status.h"

namespace tilemend {

struct KnownFile {
  std::string path;         // absolute
  std::string fingerprint;  // as the coordinator sees it (common/store/fingerprint.h)
};

struct JobFolders {
  std::vector<KnownFile> files;  // of the scene and of the output
  std::string attempts;          // a folder in which a worker must be able to make a file; empty: none
};

// Whether this machine still sees the files, whatever is in them, and can make a file among the attempts. Returns
// kAborted for a file that is gone, else errors of WriteFileAtomically. What it makes it removes. Any thread.
absl::Status TryFolders(const JobFolders& folders);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_JOB_FOLDERS_H_
