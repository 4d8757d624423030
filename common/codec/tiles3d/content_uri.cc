#include "common/codec/tiles3d/content_uri.h"

#include <optional>

#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"
#include "common/util/status_macros.h"
#include "common/util/text.h"

namespace tilemend {
namespace {

std::optional<int> HexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  return std::nullopt;
}

// Without percent-encoding; nothing if that is malformed.
std::optional<std::string> Decoded(std::string_view uri) {
  std::string out;
  for (size_t i = 0; i < uri.size(); ++i) {
    if (uri[i] != '%') {
      out += uri[i];
      continue;
    }
    if (uri.size() - i < 3) return std::nullopt;
    const std::optional<int> high = HexDigit(uri[i + 1]), low = HexDigit(uri[i + 2]);
    if (!high || !low) return std::nullopt;
    out += static_cast<char>(*high * 16 + *low);
    i += 2;
  }
  return out;
}

bool IsControl(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

// What is wrong with a decoded path; empty if nothing is.
const char* PathProblem(std::string_view path) {
  constexpr size_t kMaxPath = 4096;
  if (path.empty()) return "it is empty";
  if (path.size() > kMaxPath) return "it is longer than 4096 bytes";
  if (path.front() == '/') return "it is no relative path";
  for (const char c : path) {
    if (c == ':') return "it has a scheme or a drive";
    if (c == '\\') return "it has a backslash";
    if (IsControl(c)) return "it has a control character";
  }
  return IsUtf8(path) ? "" : "it is not UTF-8";
}

}  // namespace

absl::StatusOr<std::string> ResolveContentUri(std::string_view document, std::string_view uri) {
  const auto error = [uri](const char* why) {
    return absl::InvalidArgumentError(
        absl::StrCat("the URI \"", Printable(Shortened(uri, 200)), "\" is not opened: ", why));
  };
  if (uri.find_first_of("?#") != std::string_view::npos) return error("it has a query or a fragment");
  const std::optional<std::string> path = Decoded(uri);
  if (!path) return error("its percent-encoding is malformed");
  if (const std::string_view problem = PathProblem(*path); !problem.empty()) return error(problem.data());
  std::string out(document.substr(0, document.rfind('/') + 1));  // npos + 1 is 0
  size_t segments = 0;
  for (size_t begin = 0; begin <= path->size();) {
    const size_t end = std::min(path->find('/', begin), path->size());
    const std::string segment = path->substr(begin, end - begin);
    begin = end + 1;
    if (segment == "..") return error("it leads out of its folder");
    if (segment.empty() || segment == ".") continue;
    if (segments++ > 0) out += '/';
    out += segment;
  }
  if (segments == 0) return error("it names no file");
  return out;
}

std::string ContentUriOf(std::string_view path) {
  constexpr char kDigits[] = "0123456789ABCDEF";
  std::string uri;
  for (const char c : path) {
    if (absl::ascii_isalnum(static_cast<unsigned char>(c)) ||
        std::string_view("-._~/").find(c) != std::string_view::npos) {
      uri += c;
      continue;
    }
    const auto byte = static_cast<unsigned char>(c);
    uri += {'%', kDigits[byte >> 4], kDigits[byte & 15]};
  }
  return uri;
}

}  // namespace tilemend
