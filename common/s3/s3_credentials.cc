#include "common/s3/s3_credentials.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_split.h"
#include "common/s3/s3_requests.h"
#include "common/util/error_info.h"
#include "common/util/files.h"

namespace tilemend {
namespace {

constexpr absl::Duration kFileHolds = absl::Minutes(1);
constexpr absl::Duration kBeforeExpiry = absl::Minutes(5);

std::string TextIn(const nlohmann::json& object, const char* name) {
  const auto found = object.find(name);
  return found != object.end() && found->is_string() ? found->get<std::string>() : "";
}

}  // namespace

std::optional<S3Credentials> CredentialsInFile(const std::string& text, const std::string& profile) {
  S3Credentials found;
  bool is_in = false;
  for (const absl::string_view raw : absl::StrSplit(text, '\n')) {
    const absl::string_view line = absl::StripAsciiWhitespace(raw);
    if (line.empty() || line.front() == '#' || line.front() == ';') continue;
    if (line.front() == '[' && line.back() == ']') {
      is_in = absl::StripAsciiWhitespace(line.substr(1, line.size() - 2)) == profile;
      continue;
    }
    const std::pair<absl::string_view, absl::string_view> pair = absl::StrSplit(line, absl::MaxSplits('=', 1));
    if (!is_in) continue;
    const std::string name(absl::StripAsciiWhitespace(pair.first)), value(absl::StripAsciiWhitespace(pair.second));
    if (name == "aws_access_key_id") found.key_id = value;
    if (name == "aws_secret_access_key") found.secret = value;
    if (name == "aws_session_token") found.session_token = value;
  }
  if (found.key_id.empty() || found.secret.empty()) return std::nullopt;
  return found;
}

std::optional<RoleCredentials> CredentialsOfRole(const std::string& json) {
  const auto object = nlohmann::json::parse(json, nullptr, false);
  if (!object.is_object()) return std::nullopt;
  RoleCredentials role{
      {TextIn(object, "AccessKeyId"), TextIn(object, "SecretAccessKey"), TextIn(object, "Token")}, {}, {}};
  std::string error;
  if (role.credentials.key_id.empty() || role.credentials.secret.empty() ||
      !absl::ParseTime(absl::RFC3339_full, TextIn(object, "Expiration"), &role.expires, &error)) {
    return std::nullopt;
  }
  role.renew = role.expires - kBeforeExpiry;
  return role;
}

absl::StatusOr<S3Credentials> S3CredentialSource::Get(absl::Time now) {
  const std::lock_guard lock(mutex_);
  if (!found_ || found_->renew <= now) {
    auto found = Find(now);
    // What holds still is used on: the service that gives new ones may be busy for a moment.
    if (!found.ok() && (!found_ || found_->expires <= now)) return found.status();
    if (found.ok()) found_ = *std::move(found);
  }
  return found_->credentials;
}

void S3CredentialSource::Forget() {
  const std::lock_guard lock(mutex_);
  found_.reset();
}

absl::StatusOr<RoleCredentials> S3CredentialSource::Find(absl::Time now) const {
  const auto value = [&](const char* name) { return ValueOf(environment_, name); };
  S3Credentials given{value("AWS_ACCESS_KEY_ID"), value("AWS_SECRET_ACCESS_KEY"), value("AWS_SESSION_TOKEN")};
  if (!given.key_id.empty() && !given.secret.empty())
    return RoleCredentials{std::move(given), absl::InfiniteFuture(), absl::InfiniteFuture()};
  std::string file = value("AWS_SHARED_CREDENTIALS_FILE");
  if (file.empty()) file = absl::StrCat(value("HOME"), "/.aws/credentials");
  const std::string profile = value("AWS_PROFILE").empty() ? "default" : value("AWS_PROFILE");
  if (const auto text = ReadOwnFile(file); text.ok()) {
    if (auto found = CredentialsInFile(*text, profile))
      return RoleCredentials{*std::move(found), absl::InfiniteFuture(), now + kFileHolds};
  }
  if (auto role = AskRole()) return *std::move(role);
  return WithErrorInfo(absl::PermissionDeniedError(absl::StrCat(
                           "no credentials for the object store: neither AWS_ACCESS_KEY_ID and AWS_SECRET_ACCESS_KEY, "
                           "nor a profile [",
                           profile, "] in ", file, ", nor a role of this machine")),
                       {"OBJECT_STORE_REFUSED", {}});
}

// Source: Amazon EC2 user guide, "Retrieve security credentials from instance metadata" (IMDSv2).
std::optional<RoleCredentials> S3CredentialSource::AskRole() const {
  if (absl::AsciiStrToLower(ValueOf(environment_, "AWS_EC2_METADATA_DISABLED")) == "true") return std::nullopt;
  std::string base = ValueOf(environment_, "AWS_EC2_METADATA_SERVICE_ENDPOINT");
  if (base.empty()) base = "http://169.254.169.254";
  while (base.ends_with('/')) base.pop_back();
  const auto token = AskMetadata("PUT", base + "/latest/api/token", "X-aws-ec2-metadata-token-ttl-seconds: 21600");
  if (!token) return std::nullopt;
  const std::string header = absl::StrCat("X-aws-ec2-metadata-token: ", *token);
  const std::string roles = base + "/latest/meta-data/iam/security-credentials/";
  const auto names = AskMetadata("GET", roles, header);
  if (!names) return std::nullopt;
  const std::string name = names->substr(0, names->find('\n'));
  const auto json = AskMetadata("GET", roles + PercentEncoded(name, false), header);
  return json ? CredentialsOfRole(*json) : std::nullopt;
}

}  // namespace tilemend
