#ifndef TILEMEND_COMMON_UTIL_BUILD_ID_H_
#define TILEMEND_COMMON_UTIL_BUILD_ID_H_

#include <string>

namespace tilemend {

// Stands for all that results depend on beside their inputs, in 16 hexadecimal digits. These are the sources of
// coordinator and worker, the compiler, its flags and the releases of the libraries that are compiled in. All programs
// of one build have the same, and so have builds of the same sources in the same way on other machines
// (cmake/build_id.cmake).
std::string BuildId();

}  // namespace tilemend

#endif  // TILEMEND_COMMON_UTIL_BUILD_ID_H_
