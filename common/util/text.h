// Text that came from outside: file names and file contents need not be UTF-8, messages and protocol buffers must be.
#ifndef TILEMEND_COMMON_UTIL_TEXT_H_
#define TILEMEND_COMMON_UTIL_TEXT_H_

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tilemend {

// Whether `text` is well-formed UTF-8 (no surrogates, no overlong forms, at most U+10FFFF).
bool IsUtf8(std::string_view text);

// How many columns of a terminal `text` takes, which is UTF-8 without control characters. It is two for ideographs and
// the like, none for marks that combine with the character before them.
size_t ColumnsOf(std::string_view text);

// The longest beginning of `text` with no more columns.
std::string CutToColumns(std::string_view text, size_t columns);

// Returns `text` or, if it has more columns, its two ends with "..." between them. Most of it is the second end, where
// paths and names differ.
std::string SqueezedTo(std::string_view text, size_t columns);

// `text` or, if it has more than `most` bytes (at least 5), its two ends with " ... " between them.
std::string Shortened(std::string_view text, size_t most);

// Keeps the first `most` of many warnings, with one more that says how many of `what` follow.
void KeepFirst(size_t most, const std::string& what, std::vector<std::string>& warnings);

// How many characters (bytes) have to be put in, taken out or changed to make `b` of `a`. Cost O(|a| |b|).
size_t EditDistance(std::string_view a, std::string_view b);

// `text` as one line of UTF-8: control characters (C1 and marks of direction too) and bytes that are no
// UTF-8 become \xNN.
std::string Printable(std::string_view text);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_UTIL_TEXT_H_
