// SHA-256, the name of a content.
#ifndef TILEMEND_COMMON_STORE_DIGEST_H_
#define TILEMEND_COMMON_STORE_DIGEST_H_

#include <string>
#include <string_view>

namespace tilemend {

// The SHA-256 of `bytes` as 64 lowercase hexadecimal digits. Thread-safe.
std::string Sha256Hex(std::string_view bytes);

// Whether `text` has the form that Sha256Hex returns.
bool IsDigest(std::string_view text);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_STORE_DIGEST_H_
