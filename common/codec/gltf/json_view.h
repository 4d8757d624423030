// JSON from outside: parsed within limits, read with the JSON path in every error.
#ifndef TILEMEND_COMMON_CODEC_GLTF_JSON_VIEW_H_
#define TILEMEND_COMMON_CODEC_GLTF_JSON_VIEW_H_

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"

namespace tilemend {

// Keeps the order of members, so that what is written looks like what was read.
using OrderedJson = nlohmann::ordered_json;

// Parses the `text` that begins at byte `offset` of the file `name`. Returns kInvalidArgument with the byte of the file
// if it is no JSON or nests deeper than 250 levels. The same for an object of more than 1,024 members, since
// OrderedJson looks them up one by one. Takes up to about 50 bytes of memory for each byte of text.
absl::StatusOr<OrderedJson> ParseOrderedJson(std::string_view text, size_t offset, const std::string& name);

// A value with its place. All errors are kInvalidArgument and begin with "NAME: JSON PATH: ". The value and the name
// must outlive the view.
class JsonView {
 public:
  JsonView(const OrderedJson& value, const std::string& name) : value_(&value), name_(&name) {}

  const OrderedJson& value() const { return *value_; }
  const std::string& path() const { return path_; }  // JSON pointer; empty for the document

  absl::Status Error(std::string_view what) const;

  // A member of an object; none if this is no object or has no such member.
  std::optional<JsonView> Find(std::string_view key) const;
  absl::StatusOr<JsonView> Get(std::string_view key) const;
  // The object `extensions/key`.
  std::optional<JsonView> Extension(std::string_view key) const;

  // An element; an error if this is no array or has no such element.
  absl::StatusOr<JsonView> At(int64_t index) const;
  // The elements of a member that is an array; none if there is no such member.
  absl::StatusOr<std::vector<JsonView>> Elements(std::string_view key) const;

  // This value as a number.
  absl::StatusOr<int64_t> AsInteger(int64_t min, int64_t max) const;
  absl::StatusOr<double> AsNumber() const;  // finite
  absl::StatusOr<std::string> AsText() const;
  absl::StatusOr<std::vector<double>> AsNumbers(size_t count) const;

  // A member as a number; `otherwise` if there is no such member.
  absl::StatusOr<int64_t> Integer(std::string_view key, int64_t min, int64_t max) const;
  absl::StatusOr<int64_t> IntegerOr(std::string_view key, int64_t min, int64_t max, int64_t otherwise) const;
  absl::StatusOr<bool> BoolOr(std::string_view key, bool otherwise) const;
  absl::StatusOr<std::string> TextOr(std::string_view key, const std::string& otherwise) const;
  // Of exactly `otherwise.size()` elements.
  absl::StatusOr<std::vector<double>> NumbersOr(std::string_view key, const std::vector<double>& otherwise) const;

 private:
  JsonView(const OrderedJson& value, const std::string& name, std::string path)
      : value_(&value), name_(&name), path_(std::move(path)) {}

  const OrderedJson* value_;
  const std::string* name_;
  std::string path_;
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_CODEC_GLTF_JSON_VIEW_H_
