#include "common/gis/crs_files.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <string_view>

namespace tilemend {
namespace {

// Ends of the names of parameters that PROJ takes for files: nadgrids, geoidgrids, xy_grids, ... Other values of them
// are in kNoFiles.
constexpr std::string_view kParameters[] = {"grids=", "file=", "init=", "catalog="};
constexpr std::string_view kNoFiles[] = {"@null", "null"};
constexpr std::string_view kCode = "epsg:";             // of "init="
constexpr std::string_view kKeyword = "parameterfile";  // of WKT: PARAMETERFILE["name", "file"]

// In lower case, with one space for several, and without those around "=", "," and brackets, which PROJ and WKT permit.
std::string Compact(std::string_view text) {
  constexpr std::string_view kJoints = "=,[(";
  std::string compact;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_space = std::isspace(byte) != 0, is_joint = kJoints.find(c) != std::string_view::npos;
    if (is_joint && compact.ends_with(' ')) compact.pop_back();
    if (is_space && (compact.ends_with(' ') || kJoints.find(compact.empty() ? ' ' : compact.back()) != kJoints.npos))
      continue;
    compact.push_back(is_space ? ' ' : static_cast<char>(std::tolower(byte)));
  }
  return compact;
}

// Whether a list of values, with commas, has one that is a file.
bool NamesFile(std::string_view values) {
  while (!values.empty()) {
    const size_t end = std::min(values.find(','), values.size());
    const std::string_view value = values.substr(0, end);
    const bool is_none = std::find(std::begin(kNoFiles), std::end(kNoFiles), value) != std::end(kNoFiles);
    if (!value.empty() && !is_none && !value.starts_with(kCode)) return true;
    values.remove_prefix(std::min(end + 1, values.size()));
  }
  return false;
}

// The value that begins at `at`; a space ends it or, within WKT, a quote.
std::string_view ValueAt(std::string_view text, size_t at) {
  return text.substr(at, text.find_first_of(" \"", at) - at);
}

// The second text in quotes behind `at`.
std::string_view SecondQuoted(std::string_view text, size_t at) {
  size_t begin = at;
  for (int quotes = 0; quotes < 3; ++quotes) {
    begin = text.find('"', begin);
    if (begin == std::string_view::npos) return "";
    ++begin;
  }
  return text.substr(begin, text.find('"', begin) - begin);
}

}  // namespace

std::string FileNamedIn(const std::string& crs) {
  const std::string text = Compact(crs);
  for (const std::string_view parameter : kParameters) {
    for (size_t at = text.find(parameter); at != std::string::npos; at = text.find(parameter, at + 1)) {
      const std::string_view value = ValueAt(text, at + parameter.size());
      if (NamesFile(value)) return std::string(parameter).append(value);
    }
  }
  for (size_t at = text.find(kKeyword); at != std::string::npos; at = text.find(kKeyword, at + 1)) {
    const std::string_view value = SecondQuoted(text, at);
    if (NamesFile(value)) return std::string(kKeyword).append("=").append(value);
  }
  return "";
}

}  // namespace tilemend
