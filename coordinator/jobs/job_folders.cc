#include "coordinator/jobs/job_folders.h"

#include "absl/strings/str_cat.h"
#include "common/store/fingerprint.h"
#include "common/util/files.h"
#include "common/util/folders.h"

namespace tilemend {

absl::Status TryFolders(const JobFolders& folders) {
  absl::Status seen;
  for (const KnownFile& file : folders.files) seen.Update(FingerprintOf(file.path).status());
  if (!seen.ok()) {
    return absl::AbortedError(absl::StrCat(std::string(seen.message()), ": was it removed while the job ran?"));
  }
  if (folders.attempts.empty()) return absl::OkStatus();
  const std::string probe = folders.attempts + "/probe";
  absl::Status written = WriteFileAtomically(probe, "x");  // others may do so at the same time
  RemoveFile(probe).IgnoreError();
  return written;
}

}  // namespace tilemend
