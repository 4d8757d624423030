#include "common/util/settings.h"

#include <algorithm>

#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_replace.h"
#include "absl/strings/str_split.h"
#include "absl/strings/strip.h"
#include "common/util/files.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

// `where` is told if the value does not do.
absl::Status Take(const FlagSpec& spec, const std::string& value, const std::string& where, Settings& settings) {
  if (spec.value.empty() && value != "true" && value != "false") {
    return absl::InvalidArgumentError(absl::StrCat(where, ": ", spec.name, " is true or false"));
  }
  if (spec.value.empty() && value == "false") {
    settings.erase(spec.name);
  } else {
    settings[spec.name] = spec.value.empty() ? "" : value;
  }
  return absl::OkStatus();
}

bool IsName(absl::string_view name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return absl::ascii_islower(c) || absl::ascii_isdigit(c) || c == '-';
  });
}

// A setting of another program or command is none of ours, but what is nearly one of ours is a slip of the pen.
absl::Status CheckForeign(const std::vector<FlagSpec>& specs, const std::string& name, const std::string& where) {
  std::vector<std::string> names;
  for (const FlagSpec& spec : specs) {
    if (spec.setting) names.push_back(spec.name);
  }
  const std::string hint = DidYouMean(name, names);
  if (hint.empty()) return absl::OkStatus();
  return absl::InvalidArgumentError(absl::StrCat(where, ": unknown setting ", name, hint));
}

absl::Status TakeFile(const std::vector<FlagSpec>& specs, const std::string& path, Settings& settings) {
  TILEMEND_ASSIGN_OR_RETURN(const std::string text, ReadOwnFile(path));
  int number = 0;
  // Some editors put the mark of UTF-8 in front.
  for (const absl::string_view line : absl::StrSplit(absl::StripPrefix(text, "\xEF\xBB\xBF"), '\n')) {
    ++number;
    const absl::string_view content = absl::StripAsciiWhitespace(line);
    if (content.empty() || content.front() == '#') continue;
    const std::string where = absl::StrCat(path, ":", number);
    const size_t equals = content.find('=');
    const absl::string_view name = absl::StripAsciiWhitespace(content.substr(0, equals));
    if (equals == absl::string_view::npos || !IsName(name)) {
      return absl::InvalidArgumentError(where + ": expected NAME = VALUE");
    }
    const std::string value(absl::StripAsciiWhitespace(content.substr(equals + 1)));
    const auto spec =
        std::find_if(specs.begin(), specs.end(), [name](const auto& s) { return s.setting && s.name == name; });
    TILEMEND_RETURN_IF_ERROR(spec == specs.end() ? CheckForeign(specs, std::string(name), where)
                                                 : Take(*spec, value, where, settings));
  }
  return absl::OkStatus();
}

}  // namespace

std::string VariableOf(const std::string& flag) {
  return absl::StrCat("TILEMEND_", absl::AsciiStrToUpper(absl::StrReplaceAll(flag, {{"-", "_"}})));
}

absl::StatusOr<Settings> ReadSettings(const std::vector<FlagSpec>& specs, const std::string& usual_file,
                                      const Environment& environment) {
  Settings settings;
  const char* const named = environment("TILEMEND_CONFIG");
  const std::string file = named == nullptr ? usual_file : named;
  if (!file.empty()) {
    const absl::Status status = TakeFile(specs, file, settings);
    if (!status.ok() && (named != nullptr || !absl::IsNotFound(status))) return status;
  }
  for (const FlagSpec& spec : specs) {
    const std::string variable = VariableOf(spec.name);
    const char* const value = spec.setting ? environment(variable.c_str()) : nullptr;
    if (value != nullptr) TILEMEND_RETURN_IF_ERROR(Take(spec, value, variable, settings));
  }
  return settings;
}

std::string UsualFile(const Environment& environment) {
  if (const char* const folder = environment("XDG_CONFIG_HOME"); folder != nullptr && folder[0] == '/') {
    return absl::StrCat(folder, "/tilemend.conf");
  }
  const char* const home = environment("HOME");
  return home == nullptr || home[0] != '/' ? "" : absl::StrCat(home, "/.config/tilemend.conf");
}

std::vector<FlagSpec> AllAsSettings(std::vector<FlagSpec> specs) {
  for (FlagSpec& spec : specs) {
    spec.setting = spec.name != "help" && spec.name != "version" && spec.name != "describe";
  }
  return specs;
}

}  // namespace tilemend
