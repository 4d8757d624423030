// Signed requests to an S3 store, tried again where that may help.
#ifndef TILEMEND_COMMON_S3_S3_REQUESTS_H_
#define TILEMEND_COMMON_S3_S3_REQUESTS_H_

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "common/s3/s3_address.h"
#include "common/s3/s3_credentials.h"

namespace tilemend {

struct S3Request {
  std::string method;  // GET, HEAD, PUT, POST, DELETE
  S3Path path;
  std::map<std::string, std::string> query = {};
  std::vector<std::string> headers = {};  // "name: value", signed too
  std::string_view body = {};             // of PUT and POST
  int to_file = -1;                       // where the body of the answer goes; -1: into S3Answer
};

struct S3Answer {
  int64_t size = -1;  // Content-Length
  std::string etag;   // without quotation marks
  std::string body;
};

// How often and when a request is tried again: after 503 and other 5xx, 429, a lost connection, 30 s without a byte, a
// body that is not what its ETag says. Before the n-th try it waits up to 2^n times `unit`, at most 20 s, a random
// share of it ("full jitter", as the SDKs of Amazon do).
struct S3Patience {
  int tries = 5;
  absl::Duration unit = absl::Seconds(1);
};

// Thread-safe; each thread keeps its connection.
class S3Requests {
 public:
  S3Requests(const Environment& environment, S3Patience patience)
      : address_(AddressFrom(environment)), credentials_(environment), patience_(patience) {}
  // Errors as ObjectStore's; `path` stands in their text.
  absl::StatusOr<S3Answer> Send(const S3Request& request, const std::string& path);

 private:
  struct Outcome;
  Outcome Try(const S3Request& request, const std::string& path, const std::string& digest);

  const S3Address address_;
  S3CredentialSource credentials_;
  const S3Patience patience_;
};

// To a service that gives credentials.
struct ServiceRequest {
  std::string method;  // GET, PUT, POST
  std::string url;
  std::string header = {};  // "" for none
  std::string body = {};
  bool is_near = true;  // on this machine or the next one: answers at once, without a proxy, or is not there
};
// The body of an answer 200; nullopt for anything else.
std::optional<std::string> AskService(const ServiceRequest& request);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_S3_S3_REQUESTS_H_
