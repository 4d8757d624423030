// The page of the coordinator and its JSON mirror, on a port of their own.
#ifndef TILEMEND_COORDINATOR_WEB_WEB_SERVER_H_
#define TILEMEND_COORDINATOR_WEB_WEB_SERVER_H_

#include <memory>
#include <string>

#include "absl/status/statusor.h"
#include "common/http/http_server.h"
#include "common/util/job_log_tail.h"
#include "coordinator/api/coordinator.h"
#include "coordinator/api/gate.h"

namespace tilemend {

struct WebOptions {
  HttpSecurity security = {};
  std::shared_ptr<Gate> gate = nullptr;  // null: everybody may do everything, and nobody counts it
  // If callers need no name, only requests to an address or to localhost are answered: a page of another site, whose
  // name was made to lead here, sends that name.
  bool callers_have_names = false;
  const JobLogTail* log = nullptr;  // lines on jobs; null: none are shown. Must outlive the server
  std::string listen = {};          // where gRPC is served, "0.0.0.0:7443"; "" if the page is not to tell
};

// Bounded as HttpServer; an answer that is taken may last 60 s. Ends before `coordinator` does.
class WebServer {
 public:
  // Errors of HttpServer::Start. `coordinator` must outlive the server.
  static absl::StatusOr<std::unique_ptr<WebServer>> Start(const std::string& address, Coordinator& coordinator,
                                                          WebOptions options = {});
  ~WebServer();

  int port() const;

 private:
  struct Impl;
  explicit WebServer(std::unique_ptr<Impl> impl);
  const std::unique_ptr<Impl> impl_;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_WEB_WEB_SERVER_H_
