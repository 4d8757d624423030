#include "common/options/option.h"

#include <algorithm>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "absl/strings/str_replace.h"
#include "common/util/colour.h"

namespace tilemend {
namespace {

constexpr size_t kMaxWordsShown = 4;

// "city or usgs", "copy, link or off".
std::string Alternatives(std::vector<std::string> words) {
  if (words.size() < 2) return absl::StrJoin(words, "");
  const std::string last = std::move(words.back());
  words.pop_back();
  return absl::StrCat(absl::StrJoin(words, ", "), " or ", last);
}

// "1e6", not "1e+06".
std::string NumberText(double number) {
  return absl::StrReplaceAll(absl::StrCat(number), {{"e+0", "e"}, {"e-0", "e-"}, {"e+", "e"}});
}

// What a value is beside the words that may stand for it; "" if it is nothing else.
std::string OtherValue(const Option& option) {
  switch (option.type) {
    case OptionType::kNumber:
      return absl::StrCat("a number from ", NumberText(option.min), " to ", NumberText(option.max));
    case OptionType::kWholeNumber:
      return absl::StrCat("a whole number from ", NumberText(option.min), " to ", NumberText(option.max));
    case OptionType::kPath:
      return "a path in UTF-8";
    case OptionType::kColour:
      return kColourForm;
    case OptionType::kCells:
      return "cells, \"3,4 0,0-5,9\"";
    case OptionType::kSwitch:
      return "true or false";
    case OptionType::kWord:
      break;
  }
  return "";
}

FlagSpec AsFlag(const Option& option) {
  FlagSpec flag = {FlagOf(option), ValueShown(option), option.help, option.default_value};
  flag.group = option.group;
  const bool is_number = option.type == OptionType::kNumber || option.type == OptionType::kWholeNumber;
  const bool is_name = option.type == OptionType::kWord && option.words.size() > kMaxWordsShown;
  if (is_number) absl::StrAppend(&flag.help, "; ", NumberText(option.min), " to ", NumberText(option.max));
  if (option.unit[0] != 0) absl::StrAppend(&flag.help, " ", option.unit);
  if (is_name) absl::StrAppend(&flag.help, ": ", Alternatives(option.words));
  return flag;
}

}  // namespace

std::string FlagOf(const Option& option) { return absl::StrReplaceAll(option.field, {{"_", "-"}}); }

std::string ValueShown(const Option& option) {
  if (option.words.size() > kMaxWordsShown) return "NAME";
  std::vector<std::string> parts = option.words;
  if (option.value_name[0] != 0) parts.emplace_back(option.value_name);
  return absl::StrJoin(parts, "|");
}

std::string Expected(const Option& option) {
  std::vector<std::string> all = option.words;
  if (std::string other = OtherValue(option); !other.empty()) all.push_back(std::move(other));
  return Alternatives(std::move(all));
}

std::vector<FlagSpec> OptionFlags(unsigned commands) {
  std::vector<FlagSpec> flags;
  for (const Option& option : AllOptions()) {
    if ((option.commands & commands) != 0) flags.push_back(AsFlag(option));
  }
  return flags;
}

FlagSpec OptionFlag(const std::string& flag, unsigned commands) {
  const std::vector<FlagSpec> flags = OptionFlags(commands);
  return *std::ranges::find(flags, flag, &FlagSpec::name);
}

}  // namespace tilemend
