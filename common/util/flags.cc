#include "common/util/flags.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "absl/strings/ascii.h"
#include "absl/strings/numbers.h"
#include "absl/strings/str_cat.h"
#include "common/util/status_macros.h"
#include "common/util/text.h"

namespace tilemend {
namespace {

// A word split into the flag that it names and the value that it carries.
struct FlagWord {
  const FlagSpec* spec = nullptr;
  bool has_value = false;
  std::string value;
};

absl::StatusOr<FlagWord> SplitWord(const std::vector<FlagSpec>& specs, const std::string& word) {
  const size_t equals = word.find('=');
  const std::string shown = word.substr(0, equals);
  FlagWord result;
  result.has_value = equals != std::string::npos;
  if (result.has_value) result.value = word.substr(equals + 1);
  std::vector<std::string> names;
  for (const FlagSpec& spec : specs) {
    names.push_back("--" + spec.name);
    if (shown == names.back() || (spec.letter != 0 && shown == std::string{'-', spec.letter})) {
      result.spec = &spec;
      return result;
    }
  }
  return absl::InvalidArgumentError(absl::StrCat("unknown flag ", shown, DidYouMean(shown, names)));
}

// A negative number is an argument.
bool IsFlag(const std::string& word) {
  return word.size() > 1 && word[0] == '-' && !absl::ascii_isdigit(static_cast<unsigned char>(word[1]));
}

// `line` broken at blanks, so that no part has more than `columns`, but for a word that has; all but the first begin
// with `indent` blanks. As it is where that leaves no room.
std::string Wrapped(std::string line, size_t indent, size_t columns) {
  constexpr size_t kLeastRoom = 20;
  if (columns < indent + kLeastRoom) return line;
  size_t begin = 0;
  while (line.size() - begin > columns) {
    const size_t blank = line.rfind(' ', begin + columns);
    if (blank == std::string::npos || blank <= begin + indent) break;
    line.replace(blank, 1, absl::StrCat("\n", std::string(indent, ' ')));
    begin = blank + 1;
  }
  return line;
}

}  // namespace

absl::StatusOr<Flags> Flags::Parse(const std::vector<FlagSpec>& specs, const std::vector<std::string>& words,
                                   const std::map<std::string, std::string>& settings) {
  Flags flags;
  flags.given_ = settings;
  for (const FlagSpec& spec : specs) flags.defaults_[spec.name] = spec.default_value;
  for (size_t i = 0; i < words.size(); ++i) {
    if (words[i] == "--") {
      flags.arguments_.insert(flags.arguments_.end(), words.begin() + static_cast<std::ptrdiff_t>(i) + 1, words.end());
      break;
    }
    if (!IsFlag(words[i])) {
      flags.arguments_.push_back(words[i]);
      continue;
    }
    TILEMEND_ASSIGN_OR_RETURN(FlagWord word, SplitWord(specs, words[i]));
    if (word.spec->value.empty()) {
      if (word.has_value) return absl::InvalidArgumentError(absl::StrCat("--", word.spec->name, " takes no value"));
    } else if (!word.has_value) {
      if (++i >= words.size()) {
        return absl::InvalidArgumentError(absl::StrCat("--", word.spec->name, " needs a value: ", word.spec->value));
      }
      word.value = words[i];
    }
    if (!word.spec->value.empty() && word.value.empty()) {
      return absl::InvalidArgumentError(absl::StrCat("--", word.spec->name, " is empty; expected ", word.spec->value));
    }
    flags.given_[word.spec->name] = std::move(word.value);
  }
  return flags;
}

std::string Flags::Text(const std::string& name) const {
  if (const auto it = given_.find(name); it != given_.end()) return it->second;
  const auto it = defaults_.find(name);
  return it == defaults_.end() ? std::string() : it->second;
}

absl::StatusOr<int64_t> Flags::Integer(const std::string& name, int64_t low, int64_t high) const {
  int64_t value = 0;
  if (absl::SimpleAtoi(Text(name), &value) && value >= low && value <= high) return value;
  return absl::InvalidArgumentError(
      absl::StrCat("--", name, " '", Text(name), "': expected a whole number from ", low, " to ", high));
}

absl::StatusOr<double> Flags::Number(const std::string& name, double low, double high) const {
  double value = 0;
  if (absl::SimpleAtod(Text(name), &value) && std::isfinite(value) && value >= low && value <= high) return value;
  return absl::InvalidArgumentError(
      absl::StrCat("--", name, " '", Text(name), "': expected a number from ", low, " to ", high));
}

std::string DidYouMean(const std::string& word, const std::vector<std::string>& names) {
  const auto nearest = std::min_element(names.begin(), names.end(), [&word](const auto& a, const auto& b) {
    return EditDistance(word, a) < EditDistance(word, b);
  });
  if (nearest == names.end() || EditDistance(word, *nearest) > std::max<size_t>(2, word.size() / 4)) return "";
  return absl::StrCat("; did you mean ", *nearest, "?");
}

std::string FlagsHelp(const std::vector<FlagSpec>& specs, size_t columns) {
  constexpr size_t kIndent = 34;
  std::string text;
  for (const FlagSpec& spec : specs) {
    std::string left = spec.letter != 0 ? absl::StrCat("  -", std::string(1, spec.letter), ", --", spec.name)
                                        : absl::StrCat("      --", spec.name);
    if (!spec.value.empty()) absl::StrAppend(&left, " ", spec.value);
    left.resize(std::max<size_t>(left.size() + 2, kIndent), ' ');
    const std::string given = spec.default_value.empty() ? "" : absl::StrCat(" (default: ", spec.default_value, ")");
    absl::StrAppend(&text, Wrapped(absl::StrCat(left, spec.help, given), kIndent, columns), "\n");
  }
  return text;
}

}  // namespace tilemend
