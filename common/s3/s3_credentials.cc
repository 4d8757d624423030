#include "common/s3/s3_credentials.h"

#include <utility>

#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_split.h"
#include "common/util/error_info.h"
#include "common/util/files.h"

namespace tilemend {
namespace {

constexpr absl::Duration kFileHolds = absl::Minutes(1);

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
  const bool is_pod = !value("AWS_WEB_IDENTITY_TOKEN_FILE").empty();
  const bool is_container =
      !value("AWS_CONTAINER_CREDENTIALS_RELATIVE_URI").empty() || !value("AWS_CONTAINER_CREDENTIALS_FULL_URI").empty();
  auto role = is_pod         ? RoleOfWebIdentity(environment_)
              : is_container ? RoleOfContainer(environment_)
                             : RoleOfMachine(environment_);
  if (role) return *std::move(role);
  const char* const asked = is_pod         ? "the role AWS_ROLE_ARN by the token in AWS_WEB_IDENTITY_TOKEN_FILE"
                            : is_container ? "the role of this container (AWS_CONTAINER_CREDENTIALS_...)"
                                           : "a role of this machine";
  return WithErrorInfo(absl::PermissionDeniedError(absl::StrCat(
                           "no credentials for the object store: neither AWS_ACCESS_KEY_ID and AWS_SECRET_ACCESS_KEY, "
                           "nor a profile [",
                           profile, "] in ", file, ", nor ", asked)),
                       {"OBJECT_STORE_REFUSED", {}});
}

}  // namespace tilemend
