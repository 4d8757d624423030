#include "common/grid/json_text.h"

#include <string_view>

#include "absl/strings/str_cat.h"

namespace tilemend {
namespace {

using Json = nlohmann::json;

// Keeps where and why a text is no JSON. The library tells the place only to such a handler or by an exception.
class ErrorFinder : public nlohmann::json_sax<Json> {
 public:
  const std::string& error() const { return error_; }

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
    // "[json.exception.parse_error.101] parse error at line 2, column 3: syntax error ...": the code means nothing to a
    // user.
    std::string_view text = what.what();
    if (const size_t bracket = text.find("] "); bracket != std::string_view::npos) text.remove_prefix(bracket + 2);
    error_ = absl::StrCat("not JSON: byte ", position, ": ", std::string(text));
    return false;
  }

 private:
  std::string error_;
};

}  // namespace

absl::StatusOr<Json> ParseJson(const std::string& text, const std::string& name) {
  ErrorFinder finder;
  if (!Json::sax_parse(text, &finder)) return absl::InvalidArgumentError(absl::StrCat(name, ": ", finder.error()));
  return Json::parse(text, nullptr, /*allow_exceptions=*/false);
}

}  // namespace tilemend
