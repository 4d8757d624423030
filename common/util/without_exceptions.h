// What libraries throw, as a status.
#ifndef TILEMEND_COMMON_UTIL_WITHOUT_EXCEPTIONS_H_
#define TILEMEND_COMMON_UTIL_WITHOUT_EXCEPTIONS_H_

#include <new>
#include <system_error>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"

namespace tilemend {

// `run()`, which gives an absl::Status. kResourceExhausted in place of std::bad_alloc, and of std::system_error: no
// thread could be made.
template <class Run>
absl::Status WithoutExceptions(Run run) {
  try {
    return run();
  } catch (const std::bad_alloc&) {
    return absl::ResourceExhaustedError("out of memory");
  } catch (const std::system_error& error) {
    return absl::ResourceExhaustedError(absl::StrCat("no thread can be made, or the like: ", error.what()));
  }
}

}  // namespace tilemend

#endif  // TILEMEND_COMMON_UTIL_WITHOUT_EXCEPTIONS_H_
