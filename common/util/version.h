#ifndef TILEMEND_COMMON_UTIL_VERSION_H_
#define TILEMEND_COMMON_UTIL_VERSION_H_

namespace tilemend {

// The release, "0.1.0".
const char* Version();

}  // namespace tilemend

#endif  // TILEMEND_COMMON_UTIL_VERSION_H_
