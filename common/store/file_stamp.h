// Whether a file has changed, without reading it.
#ifndef TILEMEND_COMMON_STORE_FILE_STAMP_H_
#define TILEMEND_COMMON_STORE_FILE_STAMP_H_

#include <string>

#include "absl/time/time.h"

namespace tilemend {

// Size, number and times of a regular file as it is now: who reads the file after that knows what it held while it has
// this stamp. The time of the last change of its entry is among them, which no program can set. "" if that is less than
// two seconds ago (another change may then leave no trace, as times are coarse), or there is no such file.
std::string StampOf(const std::string& path, absl::Time now);

// The same of a file that has just been put there, however young: a change within the next tick of the file system's
// clock (some milliseconds, on few 2 s) may leave no trace.
std::string YoungStampOf(const std::string& path);

// Whether the file still has a stamp that is not "". It has not after a hard link to it was made.
bool HasStamp(const std::string& path, const std::string& stamp);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_STORE_FILE_STAMP_H_
