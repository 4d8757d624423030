#ifndef TILEMEND_COMMON_UTIL_VERSION_H_
#define TILEMEND_COMMON_UTIL_VERSION_H_

#include <string>

namespace tilemend {

// The release, "0.1.0".
const char* Version();

// What tells this build of the program from any other: the linker's id of the running file, in hexadecimal digits; the
// release where the linker gave none.
std::string BuildId();

}  // namespace tilemend

#endif  // TILEMEND_COMMON_UTIL_VERSION_H_
