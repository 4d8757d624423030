// A small web server for those who look after a program: GET /metrics, /healthz and /readyz.
#ifndef TILEMEND_COMMON_METRICS_STATUS_SERVER_H_
#define TILEMEND_COMMON_METRICS_STATUS_SERVER_H_

#include <functional>
#include <memory>
#include <string>

#include "absl/status/statusor.h"

namespace tilemend {

class HttpServer;

// What the pages say. Each is called on a thread of the server.
struct StatusPages {
  std::function<std::string()> metrics;  // Prometheus' text
  // Why the program cannot do its work now; "" if it can. /healthz says only that the program answers.
  std::function<std::string()> not_ready = [] { return std::string(); };
};

// Paths of files, which are read again whenever they are needed: new ones count at once.
struct StatusSecurity {
  std::string certificate, key;  // PEM; "": plain HTTP
  // The token that a caller of /metrics shows as "Authorization: Bearer TOKEN"; "": anybody may read them. The other
  // pages are for everybody.
  std::string token_file;
};

// A connection has five seconds in all, a quarter of one while others wait for a thread, and 64 KB (ConnectionLimits):
// requests that never end, or come byte by byte, keep nobody out and take no memory.
class StatusServer {
 public:
  // Serves on `address` ("HOST:PORT", port 0 takes a free one) as long as it lives. kUnavailable if the address cannot
  // be had.
  static absl::StatusOr<std::unique_ptr<StatusServer>> Start(const std::string& address, StatusPages pages,
                                                             StatusSecurity security = {});
  ~StatusServer();

  int port() const;

 private:
  explicit StatusServer(std::unique_ptr<HttpServer> server);
  const std::unique_ptr<HttpServer> server_;
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_METRICS_STATUS_SERVER_H_
