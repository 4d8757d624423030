#include "common/util/colour.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <system_error>

#include "absl/strings/str_format.h"

namespace tilemend {
namespace {

// The number that `text` is as a whole, in 0 to 255.
std::optional<uint8_t> Channel(std::string_view text, int base) {
  uint8_t value = 0;
  const char* const end = text.data() + text.size();
  const std::from_chars_result parsed = std::from_chars(text.data(), end, value, base);
  if (parsed.ec != std::errc() || parsed.ptr != end) return std::nullopt;
  return value;
}

std::string_view WithoutBlanksBefore(std::string_view text) {
  return text.substr(std::min(text.size(), text.find_first_not_of(' ')));
}

}  // namespace

std::optional<Rgb> ParseColour(std::string_view text) {
  std::array<std::string_view, 3> words;
  const bool is_hex = !text.empty() && text[0] == '#';
  if (is_hex) {
    constexpr size_t kLength = 7;
    if (text.size() != kLength) return std::nullopt;
    words = {text.substr(1, 2), text.substr(3, 2), text.substr(5, 2)};
  } else {
    const size_t first = text.find(','), second = text.find(',', first == std::string_view::npos ? first : first + 1);
    if (second == std::string_view::npos) return std::nullopt;
    words = {text.substr(0, first), WithoutBlanksBefore(text.substr(first + 1, second - first - 1)),
             WithoutBlanksBefore(text.substr(second + 1))};
  }
  const int base = is_hex ? 16 : 10;
  const auto r = Channel(words[0], base), g = Channel(words[1], base), b = Channel(words[2], base);
  if (!r || !g || !b) return std::nullopt;
  return Rgb{*r, *g, *b};
}

std::string ColourText(Rgb colour) { return absl::StrFormat("#%02x%02x%02x", colour.r, colour.g, colour.b); }

}  // namespace tilemend
