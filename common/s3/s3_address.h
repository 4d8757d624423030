// Where objects of an S3 store are.
#ifndef TILEMEND_COMMON_S3_S3_ADDRESS_H_
#define TILEMEND_COMMON_S3_S3_ADDRESS_H_

#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "absl/status/statusor.h"

namespace tilemend {

// Value of an environment variable; null if it is not set. As std::getenv.
using Environment = std::function<const char*(const char*)>;

// The value of `name`, "" if it is not set.
std::string ValueOf(const Environment& environment, const char* name);

struct S3Path {
  std::string bucket;
  std::string key;  // "" for the bucket itself
};

// Of s3://BUCKET[/KEY]; slashes at the end do not count. kInvalidArgument.
absl::StatusOr<S3Path> ParseS3Path(const std::string& path);

struct S3Address {
  std::string endpoint;  // http[s]://HOST[:PORT] without a slash at the end, "" for Amazon's own
  std::string region;
};

// AWS_ENDPOINT_URL_S3 or AWS_ENDPOINT_URL; AWS_REGION or AWS_DEFAULT_REGION, else us-east-1.
S3Address AddressFrom(const Environment& environment);

// As RFC 3986, 2.3 has it: all but letters, digits and "-._~", and slashes if `keep_slashes`.
std::string PercentEncoded(std::string_view text, bool keep_slashes);

// The header of a request that copies `from` within the store.
std::string CopySource(const S3Path& from);

// The URL of an object or a bucket, with the query's parameters in the order of their names, as signatures need it.
std::string UrlOf(const S3Address& address, const S3Path& path, const std::map<std::string, std::string>& query = {});

}  // namespace tilemend

#endif  // TILEMEND_COMMON_S3_S3_ADDRESS_H_
