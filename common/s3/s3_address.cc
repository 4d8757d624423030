#include "common/s3/s3_address.h"

#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "common/util/object_store.h"
#include "common/util/text.h"

namespace tilemend {

std::string ValueOf(const Environment& environment, const char* name) {
  const char* const value = environment(name);
  return value == nullptr ? "" : value;
}

absl::StatusOr<S3Path> ParseS3Path(const std::string& path) {
  constexpr size_t kScheme = 5;  // s3://
  if (!IsObjectPath(path)) return absl::InvalidArgumentError(absl::StrCat(Printable(path), ": expected s3://BUCKET"));
  std::string rest = path.substr(kScheme);
  while (rest.ends_with('/')) rest.pop_back();
  const size_t slash = rest.find('/');
  S3Path parsed{rest.substr(0, slash), slash == std::string::npos ? "" : rest.substr(slash + 1)};
  for (const char c : parsed.bucket) {
    if (absl::ascii_isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '.' || c == '_') continue;
    return absl::InvalidArgumentError(absl::StrCat(Printable(path), ": not the name of a bucket"));
  }
  if (!parsed.bucket.empty()) return parsed;
  return absl::InvalidArgumentError(absl::StrCat(Printable(path), ": no bucket; expected s3://BUCKET/PREFIX"));
}

S3Address AddressFrom(const Environment& environment) {
  const auto first_of = [&](const char* a, const char* b) {
    const std::string value = ValueOf(environment, a);
    return value.empty() ? ValueOf(environment, b) : value;
  };
  S3Address address{first_of("AWS_ENDPOINT_URL_S3", "AWS_ENDPOINT_URL"), first_of("AWS_REGION", "AWS_DEFAULT_REGION")};
  while (address.endpoint.ends_with('/')) address.endpoint.pop_back();
  if (address.region.empty()) address.region = "us-east-1";
  return address;
}

std::string PercentEncoded(std::string_view text, bool keep_slashes) {
  std::string encoded;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool stays = absl::ascii_isalnum(byte) || c == '-' || c == '.' || c == '_' || c == '~';
    if (stays || (c == '/' && keep_slashes)) {
      encoded += c;
    } else {
      absl::StrAppendFormat(&encoded, "%%%02X", byte);
    }
  }
  return encoded;
}

std::string CopySource(const S3Path& from) {
  return absl::StrCat("x-amz-copy-source: /", from.bucket, "/", PercentEncoded(from.key, true));
}

std::string UrlOf(const S3Address& address, const S3Path& path, const std::map<std::string, std::string>& query) {
  // A certificate for *.s3.REGION does not hold for a bucket with a dot. Other stores are asked by path.
  const std::string amazon =
      absl::StrCat("s3.", address.region, ".amazonaws.com", address.region.starts_with("cn-") ? ".cn" : "");
  const bool by_host = address.endpoint.empty() && path.bucket.find('.') == std::string::npos;
  std::string url = by_host                    ? absl::StrCat("https://", path.bucket, ".", amazon)
                    : address.endpoint.empty() ? absl::StrCat("https://", amazon, "/", path.bucket)
                                               : absl::StrCat(address.endpoint, "/", path.bucket);
  // A bucket that is asked by path has no slash at its end: servers differ in whether they sign one.
  if (by_host || !path.key.empty()) absl::StrAppend(&url, "/", PercentEncoded(path.key, true));
  char separator = '?';
  for (const auto& [name, value] : query) {
    absl::StrAppend(&url, std::string(1, separator), PercentEncoded(name, false), "=", PercentEncoded(value, false));
    separator = '&';
  }
  return url;
}

}  // namespace tilemend
