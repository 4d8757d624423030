// Times as people and programs read them.
#ifndef TILEMEND_COMMON_UTIL_UTC_H_
#define TILEMEND_COMMON_UTIL_UTC_H_

#include <string>

#include "absl/time/time.h"

namespace tilemend {

// "2026-11-22T05:10:00Z" (RFC 3339).
inline std::string UtcText(absl::Time time) {
  return absl::FormatTime("%Y-%m-%dT%H:%M:%SZ", time, absl::UTCTimeZone());
}

}  // namespace tilemend

#endif  // TILEMEND_COMMON_UTIL_UTC_H_
