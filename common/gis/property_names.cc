#include "common/gis/property_names.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

#include "common/util/text.h"

namespace tilemend {
namespace {

constexpr size_t kLettersForAnEdit = 4;
constexpr size_t kLongest = 20;  // letters: longer names are near none

struct Word {
  std::string_view letters, property;
};
// Words that are not in the first list are taken as they are.
constexpr std::array<Word, 6> kProperties = {{{"water", kWaterProperty},
                                              {"levelm", kLevelProperty},
                                              {"centreline", kCentrelineProperty},
                                              {"clear", kClearProperty},
                                              {"clearheight", kClearHeightProperty},
                                              {"decision", kDecisionProperty}}};
constexpr std::array<Word, 5> kOtherWords = {{{"level", kLevelProperty},
                                              {"z", kLevelProperty},
                                              {"height", kLevelProperty},
                                              {"elevation", kLevelProperty},
                                              {"cleared", kClearProperty}}};

// Without what is no letter or digit, in lower case.
std::string LettersOf(std::string_view name) {
  std::string letters;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) != 0) letters += static_cast<char>(std::tolower(byte));
  }
  return letters;
}

}  // namespace

std::string_view PropertyMeantBy(std::string_view name) {
  if (name.size() > kLongest) return "";
  const std::string letters = LettersOf(name);
  const auto same = std::ranges::find(kOtherWords, std::string_view(letters), &Word::letters);
  if (same != kOtherWords.end()) return same->property;
  const auto near = std::ranges::find_if(kProperties, [&](const Word& word) {
    return EditDistance(letters, word.letters) <= word.letters.size() / kLettersForAnEdit;
  });
  return near == kProperties.end() ? "" : near->property;
}

}  // namespace tilemend
