#include "common/codec/text.h"

#include <algorithm>

#include "absl/strings/str_cat.h"

namespace tilemend {
namespace {

constexpr size_t kShownBytes = 40;  // of a token, in a message

int64_t LineAt(std::string_view text, size_t offset) {
  const std::string_view before = text.substr(0, std::min(offset, text.size()));
  const char ending = text.find('\n') == std::string_view::npos ? '\r' : '\n';
  return 1 + std::count(before.begin(), before.end(), ending);
}

template <class Number>
void AppendChars(Number value, std::string& out) {
  char buffer[32];  // the longest double takes 24
  const std::to_chars_result written = std::to_chars(buffer, buffer + sizeof(buffer), value);
  out.append(buffer, written.ptr);
}

}  // namespace

void AppendNumber(double value, std::string& out) { AppendChars(value, out); }
void AppendNumber(int64_t value, std::string& out) { AppendChars(value, out); }

std::string_view LineEndingOf(std::string_view text) {
  const size_t newline = text.find('\n');
  if (newline == std::string_view::npos) return text.find('\r') == std::string_view::npos ? "\n" : "\r";
  return newline > 0 && text[newline - 1] == '\r' ? "\r\n" : "\n";
}

std::string FurtherColumns(std::string_view text, char newline, bool all_lines) {
  constexpr int kMaxColumns = 16;
  constexpr size_t kMaxWordBytes = 64;
  const auto continuation = [&](size_t i) -> size_t {
    if (all_lines || text[i] != '\\') return 0;
    if (text.substr(i + 1, 1) == std::string_view(&newline, 1)) return 2;
    return text.substr(i + 1, 1) == "\r" && text.substr(i + 2, 1) == std::string_view(&newline, 1) ? 3 : 0;
  };
  std::string columns;
  int count = 0;
  for (size_t i = 0; i < text.size() && count < kMaxColumns;) {
    if (text[i] == '#') {
      i = std::min(text.find(newline, i), text.size());
    } else if (text[i] == newline && !all_lines) {
      break;
    } else if (IsSpace(text[i])) {
      ++i;
    } else if (const size_t length = continuation(i); length > 0) {
      i += length;
    } else {
      const size_t begin = i;
      while (i < text.size() && !IsSpace(text[i]) && text[i] != '#' && continuation(i) == 0) ++i;
      columns += ' ';
      const bool number =
          i - begin <= kMaxWordBytes && ParseDoubleAt(text.data() + begin, text.data() + i).stop == text.data() + i;
      columns += number ? text.substr(begin, i - begin) : std::string_view("0");
      ++count;
    }
  }
  return columns;
}

std::string FoundAt(std::string_view text, size_t offset) {
  constexpr std::string_view kOfNumbers = "+-.0123456789eE/";
  if (offset >= text.size()) return "end of file";
  if (text[offset] == '\n' || text[offset] == '\r') return "end of line";
  size_t end = offset;
  while (end < text.size() && !IsSpace(text[end]) && kOfNumbers.find(text[end]) != std::string_view::npos) ++end;
  const bool number = (end >= text.size() || IsSpace(text[end])) && end - offset < kShownBytes;
  return number ? QuotedAt(text, offset) : "something else";
}

std::string QuotedAt(std::string_view text, size_t offset) {
  if (offset >= text.size()) return "end of file";
  if (text[offset] == '\n' || text[offset] == '\r') return "end of line";
  std::string shown = "'";
  size_t i = offset;
  for (; i < text.size() && !IsSpace(text[i]) && i - offset < kShownBytes; ++i) {
    const unsigned char c = static_cast<unsigned char>(text[i]);
    if (c >= 0x20 && c < 0x7f) {
      shown += text[i];
    } else {
      absl::StrAppend(&shown, "\\x", absl::Hex(c, absl::kZeroPad2));
    }
  }
  if (i < text.size() && !IsSpace(text[i])) shown += "...";
  return shown + "'";
}

absl::Status LineError(const std::string& name, std::string_view text, size_t offset, std::string_view expected) {
  return LineProblem(name, text, offset,
                     absl::StrCat("expected ", std::string(expected), ", found ", FoundAt(text, offset)));
}

absl::Status HeaderError(const std::string& name, std::string_view text, size_t offset, std::string_view expected) {
  return LineProblem(name, text, offset,
                     absl::StrCat("expected ", std::string(expected), ", found ", QuotedAt(text, offset)));
}

absl::Status LineProblem(const std::string& name, std::string_view text, size_t offset, std::string_view problem) {
  return absl::InvalidArgumentError(absl::StrCat(name, ": line ", LineAt(text, offset), ": ", std::string(problem)));
}

absl::Status ByteProblem(const std::string& name, size_t offset, std::string_view problem) {
  return absl::InvalidArgumentError(absl::StrCat(name, ": byte ", offset, ": ", std::string(problem)));
}

}  // namespace tilemend
