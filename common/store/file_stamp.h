// Whether a file has changed, without reading it.
#ifndef TILEMEND_COMMON_STORE_FILE_STAMP_H_
#define TILEMEND_COMMON_STORE_FILE_STAMP_H_

#include <string>

#include "absl/time/time.h"

namespace tilemend {

// Size, number and times of a regular file as it is now. A caller that reads the file after that knows its content as
// long as the file has this stamp. The time of the last change of its entry is among them, which no program can set.
// Returns "" if there is no such file, or if that is less than two seconds ago. Times are coarse, so another change may
// then leave no trace.
std::string StampOf(const std::string& path, absl::Time now);

// The same of a file that has just been put there, however young. A change within the next tick of the file system's
// clock may leave no trace: some milliseconds, on few 2 s.
std::string YoungStampOf(const std::string& path);

// Whether the file still has a stamp that is not "". It has not after a hard link to it was made.
bool HasStamp(const std::string& path, const std::string& stamp);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_STORE_FILE_STAMP_H_
