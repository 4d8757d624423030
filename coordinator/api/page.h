// Pages of lists.
#ifndef TILEMEND_COORDINATOR_API_PAGE_H_
#define TILEMEND_COORDINATOR_API_PAGE_H_

#include <algorithm>
#include <cstdint>
#include <string>

#include "absl/status/status.h"
#include "common/util/error_info.h"

namespace tilemend {

inline absl::Status InvalidPage(const std::string& what) {
  return WithErrorInfo(absl::InvalidArgumentError(what), {"INVALID_PAGE", {}});
}

// Entries of a page: 50 where the request does not say, at most 1,000.
inline int32_t PageSize(int32_t wanted) { return wanted == 0 ? 50 : std::min(wanted, 1000); }

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_API_PAGE_H_
