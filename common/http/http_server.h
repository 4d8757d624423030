// A small web server: one request for each connection, and a bounded time for both. Nothing here names the library.
#ifndef TILEMEND_COMMON_HTTP_HTTP_SERVER_H_
#define TILEMEND_COMMON_HTTP_HTTP_SERVER_H_

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "absl/status/statusor.h"
#include "absl/time/time.h"

namespace tilemend {

struct HttpRequest {
  std::string method;  // "GET", "HEAD", "POST", "PUT", "PATCH", "DELETE", "OPTIONS"
  std::string path;    // decoded, without the query
  std::map<std::string, std::string> query = {};
  std::map<std::string, std::string> headers = {};  // names in lower case; of one that comes twice the first
  std::string body = {};
  std::string address = {};                        // of the caller, "ADDRESS:PORT"
  std::string certificate_name = {};               // the common name of a checked certificate, "" without one
  std::vector<std::string> certificate_uris = {};  // its alternative names
  bool has_waited = false;                         // HttpAnswer::wait was heeded: the request is handled once more
  bool made_room = false;                          // and woken because too many others wait

  // "" if there is none. `name` is in lower case.
  std::string Header(const std::string& name) const;
  // Whether the caller has the answer with this entity tag: If-None-Match, compared weakly (RFC 9110, 13.1.2).
  bool HasTag(std::string_view tag) const;
};

struct HttpAnswer {
  int status = 200;
  std::string type = "text/plain; charset=utf-8";
  std::string body = {};
  std::vector<std::pair<std::string, std::string>> headers = {};
  std::shared_ptr<void> until_sent = nullptr;  // let go when the body was sent, or cannot be
  // Of an answer that is to come later, else null. Nothing is sent, and the connection waits without a thread until
  // `wake` is called; then the request is handled once more. `wake` may be called at any time, by any thread, more than
  // once. What is returned is let go when the wait is over.
  std::function<std::shared_ptr<void>(std::function<void()> wake)> wait = nullptr;
};

// Paths of PEM files, which are read again for each connection: new ones count at once.
struct HttpSecurity {
  std::string certificate, key;  // "": plain HTTP
  std::string authority = {};    // a caller needs a certificate of it; "": none
};

struct HttpLimits {
  absl::Duration time = absl::Seconds(5);  // of a connection
  // While others wait for a thread: until the request is there, and until the answer is taken.
  absl::Duration read_time_while_others_wait = absl::Milliseconds(250);
  absl::Duration write_time_while_others_wait = absl::Milliseconds(250);
  size_t request_body_bytes = 4096;
};

// 16 threads answer the connections from which a whole request came (of TLS its first byte). 64 such are served or wait
// for a thread. 256 others wait without a thread (waiting_room.h); of more, those that came first are closed. So
// connections that ask nothing, or ask byte by byte, delay nobody. 256 more wait for their answer (HttpAnswer::wait);
// of more, those that came first are handled at once. A request has 64 KB at most, and without TLS a head
// of 16 KB (431). What may have a body needs its length before it (411).
class HttpServer {
 public:
  // Called on threads of the server.
  using Handler = std::function<HttpAnswer(const HttpRequest&)>;

  // Serves on `address` ("HOST:PORT", port 0 takes a free one) as long as it lives. `what` is served there, for errors.
  // kInvalidArgument for a malformed address, kUnavailable if it cannot be had.
  static absl::StatusOr<std::unique_ptr<HttpServer>> Start(const std::string& address, const std::string& what,
                                                           Handler handler, HttpSecurity security = {},
                                                           HttpLimits limits = {});
  ~HttpServer();

  int port() const;

 private:
  struct Impl;
  explicit HttpServer(std::unique_ptr<Impl> impl);
  const std::unique_ptr<Impl> impl_;
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_HTTP_HTTP_SERVER_H_
