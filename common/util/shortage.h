// How a program ends that has no memory or no thread left where nothing can be done about it any more.
#ifndef TILEMEND_COMMON_UTIL_SHORTAGE_H_
#define TILEMEND_COMMON_UTIL_SHORTAGE_H_

#include <string>

namespace tilemend {

// For the start of main. An exception of a shortage that nobody catches (std::bad_alloc, std::system_error) ends the
// process with a line on stderr and kExitRetryable. So does an abort of a library while the system gives no memory or
// no threads. Every other abort stays one. A write beyond a limit of file sizes (`ulimit -f`) fails, in place of the
// process.
void EndOnShortage();

// A folder that goes away, with all that is in it, when the process ends so; "" for none. Of several calls the last one
// counts. A path of 4,096 bytes or more stays. Not for two threads at once.
void RemoveOnShortage(const std::string& folder);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_UTIL_SHORTAGE_H_
