#include "common/util/text.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <utility>

namespace tilemend {
namespace {

// The length of the well-formed character that `text` begins with, 0 if there is none. `text` is not empty.
size_t CharacterLength(std::string_view text) {
  const auto byte = [&](size_t i) { return static_cast<uint8_t>(text[i]); };
  const uint8_t lead = byte(0);
  if (lead < 0x80) return 1;
  const size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < length) return 0;
  for (size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return 0;
  }
  const bool overlong = (lead == 0xE0 && byte(1) < 0xA0) || (lead == 0xF0 && byte(1) < 0x90);
  const bool beyond = (lead == 0xED && byte(1) > 0x9F) || (lead == 0xF4 && byte(1) > 0x8F);
  return overlong || beyond ? 0 : length;
}

// Whether a character of several bytes steers a terminal: C1 controls, and marks that turn the direction of writing.
bool IsControl(std::string_view character) {
  if (character.size() == 2) return character[0] == '\xC2' && static_cast<uint8_t>(character[1]) < 0xA0;
  if (character.size() != 3 || character[0] != '\xE2') return false;
  const auto second = static_cast<uint8_t>(character[1]), third = static_cast<uint8_t>(character[2]);
  return (second == 0x80 && (third == 0x8E || third == 0x8F || (third >= 0xA8 && third <= 0xAE))) ||
         (second == 0x81 && third >= 0xA6 && third <= 0xA9);
}

// Of a well-formed character.
uint32_t CodePointOf(std::string_view character) {
  const auto byte = [&](size_t i) { return static_cast<uint32_t>(static_cast<uint8_t>(character[i])); };
  if (character.size() == 1) return byte(0);
  uint32_t point = byte(0) & (0x7FU >> character.size());
  for (size_t i = 1; i < character.size(); ++i) point = point << 6 | (byte(i) & 0x3F);
  return point;
}

struct Range {
  uint32_t first, last;
};
// The blocks of Unicode's East Asian Width that are wide as a whole; emoji are among the last but one.
constexpr std::array<Range, 10> kWide = {{{0x1100, 0x115F},
                                          {0x2E80, 0x303E},
                                          {0x3041, 0xA4CF},
                                          {0xA960, 0xA97F},
                                          {0xAC00, 0xD7A3},
                                          {0xF900, 0xFAFF},
                                          {0xFE30, 0xFE6F},
                                          {0xFF00, 0xFF60},
                                          {0x1F300, 0x1FAFF},
                                          {0x20000, 0x3FFFD}}};
constexpr std::array<Range, 4> kCombining = {{{0x0300, 0x036F}, {0x1AB0, 0x1AFF}, {0x200B, 0x200D}, {0xFE00, 0xFE0F}}};

template <size_t kCount>
bool IsIn(const std::array<Range, kCount>& ranges, uint32_t point) {
  return std::any_of(ranges.begin(), ranges.end(), [=](Range r) { return r.first <= point && point <= r.last; });
}

size_t ColumnsOfCharacter(std::string_view character) {
  const uint32_t point = CodePointOf(character);
  if (IsIn(kCombining, point)) return 0;
  return IsIn(kWide, point) ? 2 : 1;
}

}  // namespace

size_t ColumnsOf(std::string_view text) {
  size_t columns = 0;
  while (!text.empty()) {
    const std::string_view character = text.substr(0, std::max<size_t>(1, CharacterLength(text)));
    columns += ColumnsOfCharacter(character);
    text.remove_prefix(character.size());
  }
  return columns;
}

std::string CutToColumns(std::string_view text, size_t columns) {
  size_t end = 0, taken = 0;
  while (end < text.size()) {
    const std::string_view rest = text.substr(end);
    const std::string_view character = rest.substr(0, std::max<size_t>(1, CharacterLength(rest)));
    taken += ColumnsOfCharacter(character);
    if (taken > columns) break;
    end += character.size();
  }
  return std::string(text.substr(0, end));
}

bool IsUtf8(std::string_view text) {
  while (!text.empty()) {
    const size_t length = CharacterLength(text);
    if (length == 0) return false;
    text.remove_prefix(length);
  }
  return true;
}

std::string SqueezedTo(std::string_view text, size_t columns) {
  constexpr std::string_view kBetween = "...";
  const size_t all = ColumnsOf(text);
  if (all <= columns) return std::string(text);
  if (columns <= kBetween.size()) return CutToColumns(text, columns);
  const size_t begin = (columns - kBetween.size()) / 3, end = columns - kBetween.size() - begin;
  std::string_view tail = text.substr(CutToColumns(text, all - end).size());
  while (ColumnsOf(tail) > end) tail.remove_prefix(std::max<size_t>(1, CharacterLength(tail)));
  return CutToColumns(text, begin).append(kBetween).append(tail);
}

std::string Shortened(std::string_view text, size_t most) {
  constexpr std::string_view kBetween = " ... ";
  if (text.size() <= most) return std::string(text);
  const size_t end = (most - kBetween.size()) / 2;
  return std::string(text.substr(0, end)).append(kBetween).append(text.substr(text.size() - end));
}

void KeepFirst(size_t most, const std::string& what, std::vector<std::string>& warnings) {
  if (warnings.size() <= most) return;
  const size_t more = warnings.size() - most;
  warnings.resize(most);
  warnings.push_back(what + ": " + std::to_string(more) + " more warnings");
}

size_t EditDistance(std::string_view a, std::string_view b) {
  std::vector<size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), size_t{0});
  for (size_t i = 1; i <= a.size(); ++i) {
    size_t diagonal = std::exchange(row[0], i);
    for (size_t j = 1; j <= b.size(); ++j) {
      const size_t change = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = std::exchange(row[j], std::min({change, row[j] + 1, row[j - 1] + 1}));
    }
  }
  return row.back();
}

std::string Printable(std::string_view text) {
  constexpr char kDigits[] = "0123456789abcdef";
  std::string result;
  result.reserve(text.size());
  while (!text.empty()) {
    const auto first = static_cast<uint8_t>(text.front());
    size_t length = CharacterLength(text);
    if (length == 0 || first < 0x20 || first == 0x7F || IsControl(text.substr(0, length))) {
      length = std::max<size_t>(length, 1);
      for (const char c : text.substr(0, length)) {
        result += "\\x";
        result += kDigits[static_cast<uint8_t>(c) >> 4];
        result += kDigits[static_cast<uint8_t>(c) & 15];
      }
    } else {
      result += text.substr(0, length);
    }
    text.remove_prefix(length);
  }
  return result;
}

}  // namespace tilemend
