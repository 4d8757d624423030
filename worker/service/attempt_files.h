// The files that one attempt at a task writes.
#ifndef TILEMEND_WORKER_SERVICE_ATTEMPT_FILES_H_
#define TILEMEND_WORKER_SERVICE_ATTEMPT_FILES_H_

#include <string>
#include <string_view>
#include <vector>

#include "absl/status/status.h"
#include "common/util/files.h"
#include "common/util/stage.h"
#include "tilemend/v1/stages.pb.h"

namespace tilemend {

// Writes files under names that no other attempt has, into a folder that the coordinator made and takes away when
// the output is complete. Only the coordinator gives them their final names, so that an attempt that was given up,
// however late it wakes, changes nothing of the output. Makes no folder: once the output is complete every write fails.
// Not thread-safe.
//
// Errors: kUnavailable (FOLDER_NOT_SEEN) if this machine cannot write there; kResourceExhausted; and those of the file
// that is read.
class AttemptFiles {
 public:
  // `attempts` is the folder, `output` that of the final names.
  AttemptFiles(std::string attempts, std::string output);
  // Removes what it wrote, unless it was kept.
  ~AttemptFiles();
  AttemptFiles(const AttemptFiles&) = delete;
  AttemptFiles& operator=(const AttemptFiles&) = delete;

  // A file with these bytes, that is to go to `path` of the output.
  absl::Status Write(const std::string& path, std::string_view bytes);
  // A file as `from`. kInvalidArgument if `path` of the output is that file itself. `digest` is its FileDigest if that
  // is known.
  absl::Status Carry(const std::string& from, const std::string& path, ::tilemend::Carry how,
                     const std::string& digest = "");

  // Whether the file that was carried last has this FileDigest. Cost: reads it.
  bool LastHas(const std::string& digest) const;

  // What was written, the last first; each with its receipt, and with its digest unless it is a hard link. The
  // coordinator sees to the files from now on.
  std::vector<v1::WrittenFile> Keep();

 private:
  // A file that is on the disk, with what the store says of it.
  absl::Status Add(v1::WrittenFile file);
  v1::WrittenFile NewFile(const std::string& path) const;
  std::string PathOf(const v1::WrittenFile& file) const;

  const std::string attempts_;
  const std::string output_;
  const std::string name_;  // of the attempt
  std::vector<v1::WrittenFile> files_;
};

// Removes the files that were kept for an output of a stage (OutputDiscarder). Other stages than kAssemble keep none.
void RemoveKept(Stage stage, const std::string& input, const std::string& output);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_SERVICE_ATTEMPT_FILES_H_
