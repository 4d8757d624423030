#include "common/codec/gltf/json_view.h"

#include <cmath>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/util/status_macros.h"
#include "common/util/text.h"

namespace tilemend {
namespace {

constexpr size_t kMaxDepth = 250;
constexpr size_t kMaxMembers = 1024;

// Checks the limits, and keeps the byte where a text stops to be JSON.
class LimitChecker : public nlohmann::json_sax<OrderedJson> {
 public:
  size_t bytes_read() const { return bytes_read_; }
  const char* problem() const { return problem_; }

  bool null() override { return true; }
  bool boolean(bool /*value*/) override { return true; }
  bool number_integer(number_integer_t /*value*/) override { return true; }
  bool number_unsigned(number_unsigned_t /*value*/) override { return true; }
  bool number_float(number_float_t /*value*/, const string_t& /*text*/) override { return true; }
  bool string(string_t& /*value*/) override { return true; }
  bool binary(binary_t& /*value*/) override { return true; }
  bool start_object(std::size_t /*elements*/) override { return Open(); }
  bool key(string_t& /*value*/) override {
    if (++members_.back() <= kMaxMembers) return true;
    problem_ = "an object has more than 1024 members";
    return false;
  }
  bool end_object() override { return Close(); }
  bool start_array(std::size_t /*elements*/) override { return Open(); }
  bool end_array() override { return Close(); }
  bool parse_error(std::size_t position, const std::string& /*token*/,
                   const nlohmann::detail::exception& /*what*/) override {
    bytes_read_ = position;
    problem_ = "not JSON";
    return false;
  }

 private:
  bool Open() {
    members_.push_back(0);
    if (members_.size() <= kMaxDepth) return true;
    problem_ = "JSON nests deeper than 250 levels";
    return false;
  }
  bool Close() {
    members_.pop_back();
    return true;
  }

  std::vector<size_t> members_;  // of each open object
  size_t bytes_read_ = 0;
  const char* problem_ = "not JSON";
};

std::string MemberPath(const std::string& path, std::string_view key) {
  std::string out = path + '/';
  for (const char c : key) {
    if (c == '~') {
      out += "~0";
    } else if (c == '/') {
      out += "~1";
    } else {
      out += c;
    }
  }
  return out;
}

}  // namespace

absl::StatusOr<OrderedJson> ParseOrderedJson(std::string_view text, size_t offset, const std::string& name) {
  LimitChecker checker;
  if (!OrderedJson::sax_parse(text.begin(), text.end(), &checker)) {
    const size_t at = checker.bytes_read() > 0 ? checker.bytes_read() - 1 : 0;
    return absl::InvalidArgumentError(absl::StrCat(name, ": byte ", offset + at, ": ", checker.problem()));
  }
  return OrderedJson::parse(text.begin(), text.end(), nullptr, /*allow_exceptions=*/false);
}

absl::Status JsonView::Error(std::string_view what) const {
  return absl::InvalidArgumentError(
      absl::StrCat(*name_, ": JSON ", path_.empty() ? "/" : Printable(Shortened(path_, 200)), ": ", std::string(what)));
}

std::optional<JsonView> JsonView::Find(std::string_view key) const {
  if (!value_->is_object()) return std::nullopt;
  const auto it = value_->find(std::string(key));
  if (it == value_->end()) return std::nullopt;
  return JsonView(*it, *name_, MemberPath(path_, key));
}

absl::StatusOr<JsonView> JsonView::Get(std::string_view key) const {
  if (std::optional<JsonView> member = Find(key)) return *std::move(member);
  return Error(absl::StrCat("expected a member \"", std::string(key), "\""));
}

std::optional<JsonView> JsonView::Extension(std::string_view key) const {
  const std::optional<JsonView> extensions = Find("extensions");
  return extensions ? extensions->Find(key) : std::nullopt;
}

absl::StatusOr<JsonView> JsonView::At(int64_t index) const {
  if (!value_->is_array()) return Error("expected an array");
  if (index < 0 || index >= static_cast<int64_t>(value_->size())) return Error(absl::StrCat("no element ", index));
  return JsonView((*value_)[static_cast<size_t>(index)], *name_, absl::StrCat(path_, "/", index));
}

absl::StatusOr<std::vector<JsonView>> JsonView::Elements(std::string_view key) const {
  std::vector<JsonView> elements;
  const std::optional<JsonView> member = Find(key);
  if (!member) return elements;
  if (!member->value_->is_array()) return member->Error("expected an array");
  for (int64_t i = 0; i < static_cast<int64_t>(member->value_->size()); ++i) elements.push_back(*member->At(i));
  return elements;
}

absl::StatusOr<int64_t> JsonView::AsInteger(int64_t min, int64_t max) const {
  const absl::StatusOr<double> number = AsNumber();  // 3.0 is an integer as well
  if (number.ok() && *number == std::floor(*number) && *number >= static_cast<double>(min) &&
      *number <= static_cast<double>(max)) {
    return static_cast<int64_t>(*number);
  }
  return Error(absl::StrCat("expected an integer in ", min, " to ", max));
}

absl::StatusOr<double> JsonView::AsNumber() const {
  if (value_->is_number() && std::isfinite(value_->get<double>())) return value_->get<double>();
  return Error("expected a finite number");
}

absl::StatusOr<std::string> JsonView::AsText() const {
  if (value_->is_string()) return value_->get<std::string>();
  return Error("expected a text");
}

absl::StatusOr<std::vector<double>> JsonView::AsNumbers(size_t count) const {
  if (!value_->is_array() || value_->size() != count) return Error(absl::StrCat("expected ", count, " numbers"));
  std::vector<double> numbers;
  for (size_t i = 0; i < count; ++i) {
    TILEMEND_ASSIGN_OR_RETURN(const JsonView element, At(static_cast<int64_t>(i)));
    TILEMEND_ASSIGN_OR_RETURN(const double number, element.AsNumber());
    numbers.push_back(number);
  }
  return numbers;
}

absl::StatusOr<int64_t> JsonView::Integer(std::string_view key, int64_t min, int64_t max) const {
  TILEMEND_ASSIGN_OR_RETURN(const JsonView member, Get(key));
  return member.AsInteger(min, max);
}

absl::StatusOr<int64_t> JsonView::IntegerOr(std::string_view key, int64_t min, int64_t max, int64_t otherwise) const {
  const std::optional<JsonView> member = Find(key);
  return member ? member->AsInteger(min, max) : otherwise;
}

absl::StatusOr<bool> JsonView::BoolOr(std::string_view key, bool otherwise) const {
  const std::optional<JsonView> member = Find(key);
  if (!member) return otherwise;
  if (!member->value_->is_boolean()) return member->Error("expected true or false");
  return member->value_->get<bool>();
}

absl::StatusOr<std::string> JsonView::TextOr(std::string_view key, const std::string& otherwise) const {
  const std::optional<JsonView> member = Find(key);
  return member ? member->AsText() : otherwise;
}

absl::StatusOr<std::vector<double>> JsonView::NumbersOr(std::string_view key,
                                                        const std::vector<double>& otherwise) const {
  const std::optional<JsonView> member = Find(key);
  return member ? member->AsNumbers(otherwise.size()) : otherwise;
}

}  // namespace tilemend
