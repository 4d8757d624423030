#include "common/s3/s3_roles.h"

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>

#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/strip.h"
#include "common/s3/s3_answers.h"
#include "common/s3/s3_requests.h"
#include "common/util/files.h"

namespace tilemend {
namespace {

constexpr absl::Duration kBeforeExpiry = absl::Minutes(5);

std::string TextIn(const nlohmann::json& object, const char* name) {
  const auto found = object.find(name);
  return found != object.end() && found->is_string() ? found->get<std::string>() : "";
}

// Nullopt if something is missing.
std::optional<RoleCredentials> Checked(S3Credentials credentials, const std::string& expiration) {
  RoleCredentials role{std::move(credentials), {}, {}};
  std::string error;
  if (role.credentials.key_id.empty() || role.credentials.secret.empty() ||
      !absl::ParseTime(absl::RFC3339_full, expiration, &role.expires, &error)) {
    return std::nullopt;
  }
  role.renew = role.expires - kBeforeExpiry;
  return role;
}

// What a file holds, without the line end that editors leave; "" if it cannot be read.
std::string TokenIn(const std::string& file) {
  const auto text = ReadOwnFile(file);
  return text.ok() ? std::string(absl::StripAsciiWhitespace(*text)) : "";
}

// Whether a token may go there: nobody else can listen, or pretend to be the service.
bool IsTrusted(const std::string& url) {
  if (url.starts_with("https://")) return true;
  constexpr const char* kHosts[] = {"127.0.0.1",     "localhost",      "[::1]",
                                    "169.254.170.2", "169.254.170.23", "[fd00:ec2::23]"};
  absl::string_view rest = url;
  if (!absl::ConsumePrefix(&rest, "http://")) return false;
  return std::any_of(std::begin(kHosts), std::end(kHosts), [&](absl::string_view host) {
    absl::string_view after = rest;
    return absl::ConsumePrefix(&after, host) && !after.empty() && (after.front() == ':' || after.front() == '/') &&
           after.substr(0, after.find('/')).find('@') == absl::string_view::npos;
  });
}

std::string UrlOfContainer(const Environment& environment) {
  const std::string relative = ValueOf(environment, "AWS_CONTAINER_CREDENTIALS_RELATIVE_URI");
  if (!relative.empty()) return absl::StrCat("http://169.254.170.2/", absl::StripPrefix(relative, "/"));
  const std::string full = ValueOf(environment, "AWS_CONTAINER_CREDENTIALS_FULL_URI");
  return IsTrusted(full) ? full : "";
}

}  // namespace

std::optional<RoleCredentials> CredentialsOfRole(const std::string& json) {
  const auto object = nlohmann::json::parse(json, nullptr, false);
  if (!object.is_object()) return std::nullopt;
  return Checked({TextIn(object, "AccessKeyId"), TextIn(object, "SecretAccessKey"), TextIn(object, "Token")},
                 TextIn(object, "Expiration"));
}

std::optional<RoleCredentials> RoleOfWebIdentity(const Environment& environment) {
  const std::string role = ValueOf(environment, "AWS_ROLE_ARN");
  const std::string token = TokenIn(ValueOf(environment, "AWS_WEB_IDENTITY_TOKEN_FILE"));
  if (role.empty() || token.empty()) return std::nullopt;
  std::string session = ValueOf(environment, "AWS_ROLE_SESSION_NAME");
  if (session.empty()) session = "tilemend";
  const std::string region = AddressFrom(environment).region;
  std::string url = ValueOf(environment, "AWS_ENDPOINT_URL_STS");
  if (url.empty()) url = absl::StrCat("https://sts.", region, ".amazonaws.com", region.starts_with("cn-") ? ".cn" : "");
  ServiceRequest request{.method = "POST", .url = url};
  request.header = "Content-Type: application/x-www-form-urlencoded";
  request.body = absl::StrCat(
      "Action=AssumeRoleWithWebIdentity&Version=2011-06-15&RoleArn=", PercentEncoded(role, false),
      "&RoleSessionName=", PercentEncoded(session, false), "&WebIdentityToken=", PercentEncoded(token, false));
  request.is_near = false;
  const auto xml = AskService(request);
  if (!xml) return std::nullopt;
  const auto text = [&](const char* name) {
    constexpr const char* kAbove[] = {"AssumeRoleWithWebIdentityResponse", "AssumeRoleWithWebIdentityResult",
                                      "Credentials"};
    return TextInAnswer(*xml, kAbove, name);
  };
  return Checked({text("AccessKeyId"), text("SecretAccessKey"), text("SessionToken")}, text("Expiration"));
}

std::optional<RoleCredentials> RoleOfContainer(const Environment& environment) {
  ServiceRequest request{.method = "GET", .url = UrlOfContainer(environment)};
  if (request.url.empty()) return std::nullopt;
  const std::string file = ValueOf(environment, "AWS_CONTAINER_AUTHORIZATION_TOKEN_FILE");
  const std::string token = file.empty() ? ValueOf(environment, "AWS_CONTAINER_AUTHORIZATION_TOKEN") : TokenIn(file);
  if (!token.empty()) request.header = absl::StrCat("Authorization: ", token);
  const auto json = AskService(request);
  return json ? CredentialsOfRole(*json) : std::nullopt;
}

std::optional<RoleCredentials> RoleOfMachine(const Environment& environment) {
  if (absl::AsciiStrToLower(ValueOf(environment, "AWS_EC2_METADATA_DISABLED")) == "true") return std::nullopt;
  std::string base = ValueOf(environment, "AWS_EC2_METADATA_SERVICE_ENDPOINT");
  if (base.empty()) base = "http://169.254.169.254";
  while (base.ends_with('/')) base.pop_back();
  const auto token = AskService({"PUT", base + "/latest/api/token", "X-aws-ec2-metadata-token-ttl-seconds: 21600"});
  if (!token) return std::nullopt;
  const std::string header = absl::StrCat("X-aws-ec2-metadata-token: ", *token);
  const std::string roles = base + "/latest/meta-data/iam/security-credentials/";
  const auto names = AskService({"GET", roles, header});
  if (!names) return std::nullopt;
  const std::string name = names->substr(0, names->find('\n'));
  const auto json = AskService({"GET", roles + PercentEncoded(name, false), header});
  return json ? CredentialsOfRole(*json) : std::nullopt;
}

}  // namespace tilemend
