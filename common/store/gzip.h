// Compression of bytes in memory.
#ifndef TILEMEND_COMMON_STORE_GZIP_H_
#define TILEMEND_COMMON_STORE_GZIP_H_

#include <string>
#include <string_view>

#include "absl/status/statusor.h"

namespace tilemend {

// The gzip stream of `bytes`: the same for the same bytes. kResourceExhausted without memory.
absl::StatusOr<std::string> Gzip(std::string_view bytes);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_STORE_GZIP_H_
