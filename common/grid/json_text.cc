#include "common/grid/json_text.h"

#include <string_view>

#include "absl/strings/str_cat.h"
#include "common/util/text.h"

namespace tilemend {
namespace {

using Json = nlohmann::json;

// Keeps where a text stops to be JSON, and what the library says of it. The library tells this only to such a handler
// or by an exception.
class ErrorFinder : public nlohmann::json_sax<Json> {
 public:
  size_t bytes_read() const { return bytes_read_; }  // the last of them is where it stops
  const std::string& what() const { return what_; }

  bool null() override { return true; }
  bool boolean(bool /*value*/) override { return true; }
  bool number_integer(number_integer_t /*value*/) override { return true; }
  bool number_unsigned(number_unsigned_t /*value*/) override { return true; }
  bool number_float(number_float_t /*value*/, const string_t& /*text*/) override { return true; }
  bool string(string_t& /*value*/) override { return true; }
  bool binary(binary_t& /*value*/) override { return true; }
  bool start_object(std::size_t /*elements*/) override { return true; }
  bool key(string_t& /*value*/) override { return true; }
  bool end_object() override { return true; }
  bool start_array(std::size_t /*elements*/) override { return true; }
  bool end_array() override { return true; }
  bool parse_error(std::size_t position, const std::string& /*token*/,
                   const nlohmann::detail::exception& what) override {
    bytes_read_ = position;
    what_ = what.what();
    return false;
  }

 private:
  size_t bytes_read_ = 0;
  std::string what_;
};

bool IsSpace(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

// "byte 17 (line 2, column 3)" of the byte at `at`, all from 1; columns count characters.
std::string PlaceText(std::string_view text, size_t at) {
  size_t line = 1, column = 1;
  for (const char c : text.substr(0, at)) {
    if (c == '\n') {
      ++line;
      column = 1;
    } else if ((static_cast<unsigned char>(c) & 0xC0) != 0x80) {
      ++column;
    }
  }
  return absl::StrCat("byte ", at + 1, " (line ", line, ", column ", column, ")");
}

// The library's own words name its tokens and states, which mean nothing to a user.
std::string Reason(std::string_view text, size_t at, std::string_view what) {
  const auto says = [what](std::string_view words) { return what.find(words) != std::string_view::npos; };
  if (says("UTF-8")) return "a text with bytes that are not UTF-8";
  if (at >= text.size()) return text.empty() ? "the file is empty" : "the file ends before the JSON does";
  if (says("number overflow")) return "a number that is too large";
  if (says("control character")) return "a line break or control character inside quotes; is a closing quote missing?";
  if (says("invalid string")) return "a backslash that begins no character";
  if (text[at] == '\'') return "' is not expected here; names and texts are written in double quotes";
  size_t before = at;
  while (before > 0 && IsSpace(text[before - 1])) --before;
  const bool closes = text[at] == '}' || text[at] == ']';
  if (closes && before > 0 && text[before - 1] == ',')
    return absl::StrCat("a comma too many before ", std::string(1, text[at]));
  if (says("expected end of input")) return "more text behind the end of the JSON";
  return absl::StrCat(Printable(text.substr(at, 1)), " is not expected here");
}

}  // namespace

absl::StatusOr<Json> ParseJson(const std::string& text, const std::string& name, const Json::parser_callback_t& keep) {
  // The library would take it for the end of the text.
  if (const size_t zero = text.find('\0'); zero != std::string::npos) {
    return absl::InvalidArgumentError(absl::StrCat(name, ": not JSON: ", PlaceText(text, zero), ": a zero byte"));
  }
  ErrorFinder finder;
  if (!Json::sax_parse(text, &finder)) {
    const size_t at = finder.bytes_read() > 0 ? finder.bytes_read() - 1 : 0;
    return absl::InvalidArgumentError(
        absl::StrCat(name, ": not JSON: ", PlaceText(text, at), ": ", Reason(text, at, finder.what())));
  }
  return Json::parse(text, keep, /*allow_exceptions=*/false);
}

}  // namespace tilemend
