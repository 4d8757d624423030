#include "common/util/flags.h"

#include <CLI/CLI.hpp>
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

const FlagSpec* SpecOf(const std::vector<FlagSpec>& specs, const std::string& shown) {
  const auto found = std::ranges::find_if(specs, [&](const FlagSpec& spec) {
    return shown == "--" + spec.name || (spec.letter != 0 && shown == std::string{'-', spec.letter});
  });
  return found == specs.end() ? nullptr : &*found;
}

// The flag that `word` ends with: one alone, or the last letter of several in one word (`-vo`).
const FlagSpec* LastFlagOf(const std::vector<FlagSpec>& specs, const std::string& word) {
  const FlagSpec* const alone = SpecOf(specs, word);
  return alone != nullptr || word.empty() ? alone : SpecOf(specs, {'-', word.back()});
}

absl::Status UnknownFlag(const std::vector<FlagSpec>& specs, const std::string& word) {
  const std::string shown = word.substr(0, word.find('='));
  std::vector<std::string> names;
  for (const FlagSpec& spec : specs) names.push_back("--" + spec.name);
  return absl::InvalidArgumentError(absl::StrCat("unknown flag ", shown, DidYouMean(shown, names)));
}

// A negative number is an argument.
bool IsFlag(const std::string& word) {
  return word.size() > 1 && word[0] == '-' && !absl::ascii_isdigit(static_cast<unsigned char>(word[1]));
}

absl::Status EmptyValue(const FlagSpec& spec) {
  return absl::InvalidArgumentError(absl::StrCat("--", spec.name, " is empty; expected ", spec.value));
}

absl::Status CheckGivenOnce(const FlagSpec& spec, const std::vector<std::string>& values) {
  for (const std::string& value : values) {
    if (value == values.back()) continue;
    return absl::InvalidArgumentError(absl::StrCat("--", spec.name, " is given twice, as ", value, " and as ",
                                                   values.back(), "; it takes one value"));
  }
  return absl::OkStatus();
}

// `-out`, which would be `-o` with the value "ut": the long name of a flag behind one dash.
bool HasOneDash(const std::vector<FlagSpec>& specs, const std::string& word) {
  if (word.size() < 3 || word[0] != '-' || word[1] == '-') return false;
  const std::string name = word.substr(1, word.find('=') - 1);
  return std::ranges::any_of(specs, [&](const FlagSpec& spec) { return spec.name == name; });
}

// The words as CLI11 takes them. It would take the word after `--out=` for the value, and the = of `-o=json` too.
absl::StatusOr<std::vector<std::string>> Prepared(const std::vector<FlagSpec>& specs, std::vector<std::string> words) {
  for (std::string& word : words) {
    if (word == "--") break;
    if (HasOneDash(specs, word)) {
      const std::string shown = word.substr(0, word.find('='));
      return absl::InvalidArgumentError(absl::StrCat("unknown flag ", shown, "; did you mean -", shown, "?"));
    }
    const size_t equals = word.find('=');
    const FlagSpec* const spec = equals == std::string::npos ? nullptr : SpecOf(specs, word.substr(0, equals));
    if (spec == nullptr) continue;
    if (equals + 1 == word.size() && !spec->value.empty()) return EmptyValue(*spec);
    if (spec->value.empty()) return absl::InvalidArgumentError(absl::StrCat("--", spec->name, " takes no value"));
    word = absl::StrCat("--", spec->name, word.substr(equals));
  }
  return words;
}

// Gives the flags to `app` and lets it parse.
absl::Status ParseWords(const std::vector<FlagSpec>& specs, const std::vector<std::string>& words, CLI::App& app) {
  TILEMEND_ASSIGN_OR_RETURN(std::vector<std::string> prepared, Prepared(specs, words));
  app.set_help_flag();  // a flag as any other
  app.allow_extras();
  for (const FlagSpec& spec : specs) {
    const std::string letter = spec.letter == 0 ? "" : absl::StrCat("-", std::string(1, spec.letter), ",");
    const std::string names = absl::StrCat(letter, "--", spec.name);
    if (spec.value.empty()) {
      app.add_flag(names);
    } else {
      app.add_option(names)->expected(1)->take_last();
    }
  }
  std::ranges::reverse(prepared);  // as CLI11 wants them
  try {
    app.parse(std::move(prepared));
  } catch (const CLI::ArgumentMismatch& error) {  // of the last word: every other flag has a word after it
    const FlagSpec* const last = words.empty() ? nullptr : LastFlagOf(specs, words.back());
    if (last == nullptr) return absl::InvalidArgumentError(error.what());
    return absl::InvalidArgumentError(absl::StrCat("--", last->name, " needs a value: ", last->value));
  } catch (const CLI::ParseError& error) {
    return absl::InvalidArgumentError(error.what());
  }
  return absl::OkStatus();
}

// Of what the parser left: words that are no flags, and all after `--`.
absl::StatusOr<std::vector<std::string>> ArgumentsOf(const std::vector<FlagSpec>& specs,
                                                     std::vector<std::string> remaining) {
  const auto mark = std::ranges::find(remaining, "--");
  const auto unknown = std::find_if(remaining.begin(), mark, IsFlag);
  if (unknown != mark) return UnknownFlag(specs, *unknown);
  if (mark != remaining.end()) remaining.erase(mark);
  return remaining;
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

std::string HelpLine(const FlagSpec& spec, size_t columns) {
  constexpr size_t kIndent = 34;
  std::string left = spec.letter != 0 ? absl::StrCat("  -", std::string(1, spec.letter), ", --", spec.name)
                                      : absl::StrCat("      --", spec.name);
  if (!spec.value.empty()) absl::StrAppend(&left, " ", spec.value);
  left.resize(std::max<size_t>(left.size() + 2, kIndent), ' ');
  const std::string given = spec.default_value.empty() ? "" : absl::StrCat(" (default: ", spec.default_value, ")");
  return absl::StrCat(Wrapped(absl::StrCat(left, spec.help, given), kIndent, columns), "\n");
}

}  // namespace

absl::StatusOr<Flags> Flags::Parse(const std::vector<FlagSpec>& specs, const std::vector<std::string>& words,
                                   const std::map<std::string, std::string>& settings, TwoValues two_values) {
  CLI::App app;
  TILEMEND_RETURN_IF_ERROR(ParseWords(specs, words, app));
  Flags flags;
  flags.given_ = settings;
  TILEMEND_ASSIGN_OR_RETURN(flags.arguments_, ArgumentsOf(specs, app.remaining()));
  for (const FlagSpec& spec : specs) {
    flags.defaults_[spec.name] = spec.default_value;
    const CLI::Option& option = *app.get_option("--" + spec.name);
    if (option.count() == 0) continue;
    if (!spec.value.empty() && option.results().back().empty()) return EmptyValue(spec);
    const bool may_be_two = two_values == TwoValues::kLastCounts || spec.value.empty();
    if (!may_be_two) TILEMEND_RETURN_IF_ERROR(CheckGivenOnce(spec, option.results()));
    flags.given_[spec.name] = spec.value.empty() ? "" : option.results().back();
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
  if (nearest == names.end() || word.empty()) return "";
  std::string meant;
  if (EditDistance(word, *nearest) <= std::max<size_t>(2, word.size() / 4)) {
    meant = *nearest;
  } else {
    const auto begins_with_word = [&word](const std::string& name) { return name.starts_with(word); };
    if (std::ranges::count_if(names, begins_with_word) == 1) meant = *std::ranges::find_if(names, begins_with_word);
  }
  return meant.empty() ? "" : absl::StrCat("; did you mean ", meant, "?");
}

std::string FlagsHelp(const std::vector<FlagSpec>& specs, size_t columns, bool all) {
  std::string text;
  size_t hidden = 0;
  for (const auto& [group, title] : {std::pair(FlagGroup::kEveryday, ""),
                                     {FlagGroup::kAdvanced, "Advanced"},
                                     {FlagGroup::kPapers, "Published methods, for comparison"}}) {
    std::string lines;
    for (const FlagSpec& spec : specs) {
      if (spec.group != group) continue;
      if (group != FlagGroup::kPapers || all) {
        lines += HelpLine(spec, columns);
      } else {
        ++hidden;
      }
    }
    if (lines.empty()) continue;
    absl::StrAppend(&text, text.empty() ? "" : absl::StrCat("\n", title, ":\n"), lines);
  }
  if (hidden > 0) absl::StrAppend(&text, "\n--help-all shows ", hidden, " more flags, of published methods.\n");
  return text;
}

}  // namespace tilemend
