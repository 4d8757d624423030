#include "worker/service/look_at_folders.h"

#include <string>

#include "common/store/fingerprint.h"
#include "worker/service/attempt_files.h"

namespace tilemend {

v1::FoldersSeen LookAtFolders(const v1::JobFolders& folders) {
  v1::FoldersSeen seen;
  seen.set_job(folders.job());
  for (const std::string& path : folders.files()) {
    v1::FileSeen& file = *seen.add_files();
    const auto fingerprint = FingerprintOf(path);
    if (fingerprint.ok()) {
      file.set_fingerprint(*fingerprint);
    } else {
      file.set_error(std::string(fingerprint.status().message()));
    }
  }
  if (!folders.attempts().empty()) {
    AttemptFiles probe(folders.attempts(), "");  // takes it back
    if (const absl::Status status = probe.Write("probe", "x"); !status.ok()) {
      seen.set_write_error(std::string(status.message()));
    }
  }
  return seen;
}

}  // namespace tilemend
