// Text that came from outside: file names and file contents need not be UTF-8, messages and protocol buffers must be.
#ifndef TILEMEND_COMMON_UTIL_TEXT_H_
#define TILEMEND_COMMON_UTIL_TEXT_H_

#include <string>
#include <string_view>

namespace tilemend {

// Whether `text` is well-formed UTF-8 (no surrogates, no overlong forms, at most U+10FFFF).
bool IsUtf8(std::string_view text);

// `text` as one line of UTF-8: control characters (C1 and marks of direction too) and bytes that are no
// UTF-8 become \xNN.
std::string Printable(std::string_view text);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_UTIL_TEXT_H_
