// What the readers of mesh files share: limits, numbers in text, and messages that say where a file is wrong.
#ifndef TILEMEND_COMMON_CODEC_TEXT_H_
#define TILEMEND_COMMON_CODEC_TEXT_H_

#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include "absl/status/status.h"
#include "fast_float/fast_float.h"

namespace tilemend {

// A coordinate beyond this many metres is taken for damage: no place on Earth is so far from a scene's origin.
inline constexpr double kMaxCoordinate = 1e9;
// A text line or a list beyond these is taken for damage.
inline constexpr size_t kMaxLineBytes = size_t{1} << 20;
inline constexpr int64_t kMaxListCount = 1000000;

inline constexpr char kNoVertices[] = "the file has no vertices";
inline constexpr char kCoordinate[] = "a coordinate that is finite and at most 1e9 m";
inline bool IsValidCoordinate(double x) { return std::abs(x) <= kMaxCoordinate; }  // false for NaN

// Where a text begins: behind the byte order mark that some editors put in front.
inline size_t TextStart(std::string_view text) { return text.starts_with("\xef\xbb\xbf") ? 3 : 0; }

inline bool IsSpace(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

// A number at the start of [begin, end) and where it ends; `stop` is null if there is none. Independent of the locale;
// correctly rounded; "inf" and "nan" are numbers here.
struct ParsedDouble {
  double value = 0;
  const char* stop = nullptr;
};
inline ParsedDouble ParseDoubleAt(const char* begin, const char* end) {
  if (end - begin > 1 && *begin == '+' && begin[1] != '-') ++begin;
  ParsedDouble result;
  const fast_float::from_chars_result parsed = fast_float::from_chars(begin, end, result.value);
  if (parsed.ec == std::errc()) result.stop = parsed.ptr;
  return result;
}

// A decimal integer at the start of [begin, end) and where it ends; `stop` is null if there is none or it is too large.
struct ParsedInteger {
  int64_t value = 0;
  const char* stop = nullptr;
};
inline ParsedInteger ParseIntegerAt(const char* begin, const char* end) {
  if (end - begin > 1 && *begin == '+' && begin[1] != '-') ++begin;
  ParsedInteger result;
  const std::from_chars_result parsed = std::from_chars(begin, end, result.value);
  if (parsed.ec == std::errc()) result.stop = parsed.ptr;
  return result;
}

// Appends the shortest decimal text that reads back as `value`.
void AppendNumber(double value, std::string& out);
void AppendNumber(int64_t value, std::string& out);

// "\r\n", "\r" (only if the text has no "\n" at all) or "\n": what ends the first line of `text`.
std::string_view LineEndingOf(std::string_view text);

// The words of `text`, each after a space: the further columns of a vertex. With `all_lines` they go up to its end,
// else up to its first line end that no backslash stands before. Comments (#) are left out, and what is not a number
// becomes 0. There are at most 16, since many new vertices may copy them.
std::string FurtherColumns(std::string_view text, char newline, bool all_lines);

// What stands at `offset`, for a message: a number as it is, "end of line", "end of file" or "something else". A file
// that is no mesh may be private: nothing else of it is shown.
std::string FoundAt(std::string_view text, size_t offset);
// The same for a text that is known to be a mesh's header: up to the next white space, made printable and cut.
std::string QuotedAt(std::string_view text, size_t offset);

// kInvalidArgument "NAME: line N: expected ..., found ...", the line being the one that holds `offset`.
absl::Status LineError(const std::string& name, std::string_view text, size_t offset, std::string_view expected);
// The same with what QuotedAt shows.
absl::Status HeaderError(const std::string& name, std::string_view text, size_t offset, std::string_view expected);
// The same with the text of `problem` after the line.
absl::Status LineProblem(const std::string& name, std::string_view text, size_t offset, std::string_view problem);
// kInvalidArgument "NAME: byte N: PROBLEM".
absl::Status ByteProblem(const std::string& name, size_t offset, std::string_view problem);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_CODEC_TEXT_H_
