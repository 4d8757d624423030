#include "common/util/error_info.h"

#include <string_view>
#include <vector>

#include "absl/strings/cord.h"

namespace tilemend {
namespace {

// The payload is a row of strings, each ended by a zero byte: reason, then key and value by turns.
constexpr char kPayloadUrl[] = "tilemend.dev/ErrorInfo";

void AppendField(std::string_view field, std::string& out) {
  out.append(field.substr(0, field.find('\0')));
  out.push_back('\0');
}

std::vector<std::string> SplitFields(const std::string& text) {
  std::vector<std::string> fields;
  size_t begin = 0;
  for (size_t end = text.find('\0'); end != std::string::npos; end = text.find('\0', begin)) {
    fields.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return fields;
}

}  // namespace

absl::Status WithErrorInfo(absl::Status status, const ErrorInfo& info) {
  if (status.ok()) return status;
  std::string text;
  AppendField(info.reason, text);
  for (const auto& [key, value] : info.metadata) {
    AppendField(key, text);
    AppendField(value, text);
  }
  status.SetPayload(kPayloadUrl, absl::Cord(text));
  return status;
}

std::optional<ErrorInfo> GetErrorInfo(const absl::Status& status) {
  const auto payload = status.GetPayload(kPayloadUrl);
  if (!payload.has_value()) return std::nullopt;
  const std::vector<std::string> fields = SplitFields(std::string(*payload));
  if (fields.empty()) return std::nullopt;
  ErrorInfo info;
  info.reason = fields[0];
  for (size_t i = 1; i + 1 < fields.size(); i += 2) info.metadata[fields[i]] = fields[i + 1];
  return info;
}

std::string ErrorReason(const absl::Status& status) {
  const auto info = GetErrorInfo(status);
  return info.has_value() ? info->reason : std::string();
}

}  // namespace tilemend
