#include "client/crs_text.h"

#include <vector>

#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"
#include "common/util/text.h"

namespace tilemend {
namespace {

std::string_view Trimmed(std::string_view text) {
  const auto is_blank = [](char c) { return absl::ascii_isspace(static_cast<unsigned char>(c)); };
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

// Whether it begins as WKT does: a word of letters and an opening bracket.
bool IsWkt(std::string_view text) {
  const size_t bracket = text.find_first_of("[(");
  if (bracket == std::string_view::npos || bracket == 0) return false;
  for (const char c : text.substr(0, bracket)) {
    if (!absl::ascii_isalnum(static_cast<unsigned char>(c)) && c != '_') return false;
  }
  return text.substr(0, bracket).ends_with("CRS") || text.substr(0, bracket).ends_with("CS");
}

// The members of the outermost node, each as its text. Brackets in quotes do not count.
std::vector<std::string_view> MembersOf(std::string_view wkt) {
  std::vector<std::string_view> members;
  size_t depth = 0, begin = 0;
  bool is_quoted = false;
  for (size_t i = 0; i < wkt.size(); ++i) {
    const char c = wkt[i];
    if (c == '"') is_quoted = !is_quoted;
    if (is_quoted) continue;
    const bool opens = c == '[' || c == '(', closes = c == ']' || c == ')';
    if (depth == 1 && (c == ',' || closes)) members.push_back(wkt.substr(begin, i - begin));
    if ((opens && depth == 0) || (c == ',' && depth == 1)) begin = i + 1;
    if (opens) ++depth;
    if (closes && depth-- == 1) break;
  }
  return members;
}

std::string Unquoted(std::string_view text) {
  text = Trimmed(text);
  if (text.size() >= 2 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
  return std::string(text);
}

// "EPSG:25832" of ID["EPSG",25832] or AUTHORITY["EPSG","25832"]; "" for anything else.
std::string CodeOf(std::string_view member) {
  member = Trimmed(member);
  if (!member.starts_with("ID[") && !member.starts_with("AUTHORITY[")) return "";
  const std::vector<std::string_view> parts = MembersOf(member);
  return parts.size() < 2 ? "" : absl::StrCat(Unquoted(parts[0]), ":", Unquoted(parts[1]));
}

}  // namespace

std::string CrsText(std::string_view crs) {
  const std::string_view text = Trimmed(crs);
  if (!IsWkt(text)) return Printable(std::string(crs));
  const std::vector<std::string_view> members = MembersOf(text);
  if (members.empty() || Unquoted(members[0]).empty()) return Printable(std::string(crs));
  std::string code;
  for (const std::string_view member : members) {
    if (std::string found = CodeOf(member); !found.empty()) code = absl::StrCat(" (", found, ")");
  }
  return Printable(absl::StrCat(Unquoted(members[0]), code));
}

}  // namespace tilemend
