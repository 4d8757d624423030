// Places in the code where a test ends the process or makes an operation fail, to see what is left behind.
//
// They are always compiled in and cost one relaxed load until one is armed, by the environment:
//
//   TILEMEND_FAILPOINT=journal.commit:3         the third time, the process kills itself there (SIGKILL)
//   TILEMEND_FAILPOINT=journal.commit:3:error   the third time and ever after, the operation fails there
//   TILEMEND_FAILPOINT=journal.commit:3:stop    the third time, the process stops there (SIGSTOP) until SIGCONT
#ifndef TILEMEND_COMMON_UTIL_FAILPOINT_H_
#define TILEMEND_COMMON_UTIL_FAILPOINT_H_

#include <string>
#include <string_view>

#include "absl/status/status.h"

namespace tilemend {

// Passes the place `name`. True: the operation that begins here is to fail as if its device had. Thread-safe.
bool FailPoint(std::string_view name);

// Arms what `spec` says (see above), or nothing if it is empty. kInvalidArgument if it says something else. Before the
// process has other threads.
absl::Status ArmFailPoint(const std::string& spec);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_UTIL_FAILPOINT_H_
