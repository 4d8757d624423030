#include "common/http/http_server.h"

#include <httplib.h>
#include <openssl/ssl.h>
#include <openssl/x509v3.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <mutex>
#include <semaphore>
#include <thread>

#include "absl/strings/ascii.h"
#include "absl/strings/numbers.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_split.h"
#include "absl/strings/string_view.h"
#include "common/http/held_connections.h"
#include "common/http/timed_connection.h"
#include "common/http/waiting_room.h"

namespace tilemend {
namespace {

constexpr size_t kThreads = 16;
constexpr std::ptrdiff_t kMostConnections = 64;  // served or waiting for a thread
constexpr size_t kMostHeld = 256;                // that wait for their answer, 64 KB each at most, and what TLS takes
// A connection that asks nothing is closed then.
constexpr absl::Duration kMostIdle = absl::Seconds(5);

// Threads that have a bounded queue before them: who comes when it is full waits.
class BoundedPool {
 public:
  void Run(std::function<void()> answer) {
    room_.acquire();
    ++waiting_;
    pool_.enqueue([this, answer = std::move(answer)] {
      --waiting_;
      answer();
      room_.release();
    });
  }
  void Shutdown() { pool_.shutdown(); }
  bool others_wait() const { return waiting_ > 0; }  // for a thread

 private:
  std::atomic<int> waiting_{0};
  std::counting_semaphore<kMostConnections> room_{kMostConnections};
  httplib::ThreadPool pool_{kThreads};
};

// Runs what the library does with each accepted connection at once: that hands it to the waiting room.
class RunAtOnce : public httplib::TaskQueue {
 public:
  explicit RunAtOnce(std::function<void()> shutdown) : shutdown_(std::move(shutdown)) {}
  void enqueue(std::function<void()> accept) override { accept(); }
  void shutdown() override { shutdown_(); }

 private:
  const std::function<void()> shutdown_;
};

// Before each handshake, so that new files count at once.
int LoadCertificate(SSL* connection, void* data) {
  const auto& security = *static_cast<const HttpSecurity*>(data);
  if (SSL_use_certificate_chain_file(connection, security.certificate.c_str()) != 1 ||
      SSL_use_PrivateKey_file(connection, security.key.c_str(), SSL_FILETYPE_PEM) != 1) {
    return 0;
  }
  if (security.authority.empty()) return 1;
  X509_STORE* const store = X509_STORE_new();
  if (X509_STORE_load_locations(store, security.authority.c_str(), nullptr) != 1 ||
      SSL_set1_verify_cert_store(connection, store) != 1) {
    X509_STORE_free(store);
    return 0;
  }
  X509_STORE_free(store);
  SSL_set_verify(connection, SSL_VERIFY_PEER | SSL_VERIFY_FAIL_IF_NO_PEER_CERT, nullptr);
  return 1;
}

struct FreeContext {
  void operator()(SSL_CTX* context) const { SSL_CTX_free(context); }
};
using TlsContext = std::unique_ptr<SSL_CTX, FreeContext>;

// None for plain text. `security` must outlive it.
TlsContext NewContext(HttpSecurity& security) {
  if (security.certificate.empty()) return nullptr;
  TlsContext context(SSL_CTX_new(TLS_server_method()));
  SSL_CTX_set_min_proto_version(context.get(), TLS1_2_VERSION);
  // A session that goes on would bring no certificate along.
  SSL_CTX_set_session_cache_mode(context.get(), SSL_SESS_CACHE_OFF);
  SSL_CTX_set_options(context.get(), SSL_OP_NO_TICKET);
  SSL_CTX_set_cert_cb(context.get(), LoadCertificate, &security);
  return context;
}

// The connection that this thread answers, what its answer has to keep until it is sent, and what it waits for.
thread_local TimedConnection* current_connection = nullptr;
thread_local std::shared_ptr<void> current_until_sent;
thread_local HeldConnections::Wait current_wait;

class TimedServer : public httplib::Server {
 public:
  TimedServer(TlsContext context, ConnectionLimits limits, size_t body_bytes)
      : context_(std::move(context)),
        limits_(limits),
        room_(
            {.time = std::min(limits.time, kMostIdle), .body_bytes = body_bytes, .whole_request = context_ == nullptr},
            [this](int fd) { pool_.Run([this, fd] { Serve(fd); }); }),
        held_(kMostHeld, [this](auto connection) { pool_.Run([this, connection] { AnswerHeld(connection); }); }) {
    new_task_queue = [this] { return new RunAtOnce([this] { Stop(); }); };
  }
  ~TimedServer() override { Stop(); }
  // Once it is bound. The library has the kernel keep five connections, and a sixth tries again after a second.
  void KeepMoreInTheKernel() { ::listen(svr_sock_.load(), SOMAXCONN); }

 private:
  bool process_and_close_socket(socket_t fd) override {
    room_.Add(fd);
    return true;
  }
  void Serve(int fd) {
    auto connection = std::make_shared<TimedConnection>(fd, limits_, [this] { return pool_.others_wait(); });
    if (context_ != nullptr && !connection->Encrypt(context_.get())) return;
    Answer(std::move(connection));
  }
  void Answer(std::shared_ptr<TimedConnection> connection) {
    current_connection = connection.get();
    bool closed = false;
    process_request(*connection, true, closed, [](httplib::Request& request) {
      request.ranges.clear();                    // an answer is whole: 8 KB of ranges made an answer of 0.2 GB
      request.headers.erase("Accept-Encoding");  // the library's compression takes a second for a megabyte
      request.set_header("Accept-Encoding", "");
    });
    current_connection = nullptr;
    current_until_sent.reset();  // the body is gone
    const auto wait = std::exchange(current_wait, nullptr);
    if (wait != nullptr) held_.Hold(std::move(connection), wait);
  }
  void AnswerHeld(std::shared_ptr<TimedConnection> connection) {
    connection->Rewind();  // now, since from here on its time counts
    Answer(std::move(connection));
  }
  void Stop() {
    room_.Close();
    held_.Close();
    std::call_once(stopped_, [this] { pool_.Shutdown(); });
  }

  const TlsContext context_;
  const ConnectionLimits limits_;
  std::once_flag stopped_;
  BoundedPool pool_;
  WaitingRoom room_;  // it and the next use the pool
  HeldConnections held_;
};

// Alternative names that are URIs, as over gRPC.
std::vector<std::string> UrisOf(const X509& certificate) {
  std::vector<std::string> names;
  auto* const all = static_cast<GENERAL_NAMES*>(X509_get_ext_d2i(&certificate, NID_subject_alt_name, nullptr, nullptr));
  for (int k = 0; k < sk_GENERAL_NAME_num(all); ++k) {
    const GENERAL_NAME* const name = sk_GENERAL_NAME_value(all, k);
    if (name->type != GEN_URI) continue;
    const ASN1_STRING* const text = name->d.ia5;
    names.emplace_back(reinterpret_cast<const char*>(ASN1_STRING_get0_data(text)),
                       static_cast<size_t>(ASN1_STRING_length(text)));
  }
  GENERAL_NAMES_free(all);
  return names;
}

void SetCaller(const TimedConnection& connection, HttpRequest& request) {
  std::string ip;
  int port = 0;
  connection.get_remote_ip_and_port(ip, port);
  request.address = absl::StrCat(ip, ":", port);
  const auto certificate = connection.PeerCertificate();
  if (certificate == nullptr) return;
  std::array<char, 256> name{};
  const int length = X509_NAME_get_text_by_NID(X509_get_subject_name(certificate.get()), NID_commonName, name.data(),
                                               static_cast<int>(name.size()));
  if (length > 0) request.certificate_name.assign(name.data(), static_cast<size_t>(length));
  request.certificate_uris = UrisOf(*certificate);
}

HttpRequest RequestOf(const httplib::Request& from) {
  HttpRequest request;
  request.method = from.method;
  request.path = from.path;
  for (const auto& [name, value] : from.params) request.query.emplace(name, value);
  for (const auto& [name, value] : from.headers) request.headers.emplace(absl::AsciiStrToLower(name), value);
  request.body = from.body;
  if (current_connection == nullptr) return request;
  SetCaller(*current_connection, request);
  request.has_waited = current_connection->was_rewound();
  request.made_room = current_connection->made_room();
  return request;
}

// Whether the library reads a body. Without a length it does so until the connection ends.
bool ReadsBody(const std::string& method) {
  constexpr std::array<std::string_view, 5> kMethods = {"POST", "PUT", "PATCH", "DELETE", "PRI"};
  return std::ranges::find(kMethods, method) != kMethods.end();
}

// Before the body comes: the library would read one that it refuses, and a thread wait for it.
bool RefuseByHead(const httplib::Request& request, size_t most_bytes, httplib::Response& response) {
  const auto comes_twice = [&](const char* name) { return request.get_header_value_count(name) > 1; };
  if (comes_twice("Content-Length") || comes_twice("Host")) {  // RFC 9112, 3.2 and 6.3
    response.status = 400;
    response.body = "Host and Content-Length may each come once\n";
  } else if (request.has_header("Transfer-Encoding") ||
             (ReadsBody(request.method) && !request.has_header("Content-Length"))) {
    response.status = 411;
    response.body = "a body needs its length before it (Content-Length)\n";
  } else if (request.get_header_value<uint64_t>("Content-Length") > most_bytes) {
    response.status = 413;
    response.body = absl::StrCat("a body has at most ", most_bytes, " bytes\n");
  } else {
    return false;
  }
  response.set_header("Content-Type", "text/plain; charset=utf-8");
  return true;
}

void AllowAddressAgain(int socket) {
  const int yes = 1;
  setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof(yes));
}

}  // namespace

std::string HttpRequest::Header(const std::string& name) const {
  const auto found = headers.find(name);
  return found == headers.end() ? "" : found->second;
}

bool HttpRequest::HasTag(std::string_view tag) const {
  const std::string header = Header("if-none-match");
  for (const absl::string_view entry : absl::StrSplit(header, ',')) {
    const absl::string_view trimmed = absl::StripAsciiWhitespace(entry);
    std::string_view known(trimmed.data(), trimmed.size());
    if (known.starts_with("W/")) known.remove_prefix(2);
    if (known == tag || known == "*") return true;
  }
  return false;
}

struct HttpServer::Impl {
  ~Impl() {
    if (!thread.joinable()) return;
    server->stop();
    thread.join();
  }
  void Answer(const httplib::Request& request, httplib::Response& response) const;
  bool Listen(const std::string& host, int wanted_port, size_t request_body_bytes);

  Handler handler;
  HttpSecurity security;
  std::unique_ptr<TimedServer> server;
  int port = 0;
  std::thread thread;
};

void HttpServer::Impl::Answer(const httplib::Request& request, httplib::Response& response) const {
  HttpAnswer answer = handler(RequestOf(request));
  if (answer.wait != nullptr && current_connection != nullptr) {
    current_connection->HoldAnswer();
    current_wait = std::move(answer.wait);
    return;
  }
  current_until_sent = std::move(answer.until_sent);
  response.status = answer.status;
  for (const auto& [name, value] : answer.headers) response.set_header(name, value);
  if (answer.status == 304) return;
  response.body = std::move(answer.body);
  response.set_header("Content-Type", answer.type);
}

bool HttpServer::Impl::Listen(const std::string& host, int wanted_port, size_t request_body_bytes) {
  server->set_payload_max_length(request_body_bytes);
  server->set_pre_routing_handler([=](const httplib::Request& request, httplib::Response& response) {
    return RefuseByHead(request, request_body_bytes, response) ? httplib::Server::HandlerResponse::Handled
                                                               : httplib::Server::HandlerResponse::Unhandled;
  });
  // A caller that waits for leave to send its body would hold a thread. The library goes on with the request if the
  // result is 417.
  server->set_expect_100_continue_handler([](const httplib::Request&, httplib::Response& response) {
    response.status = 417;
    response.body = "send the body without waiting for 100 Continue\n";
    response.set_header("Content-Type", "text/plain; charset=utf-8");
    return 0;
  });
  server->set_socket_options(AllowAddressAgain);
  const auto answer = [this](const httplib::Request& request, httplib::Response& response) {
    Answer(request, response);
  };
  server->Get(".*", answer);
  server->Post(".*", answer);
  server->Put(".*", answer);
  server->Patch(".*", answer);
  server->Delete(".*", answer);
  server->Options(".*", answer);
  if (wanted_port == 0) {
    port = server->bind_to_any_port(host);
  } else if (server->bind_to_port(host, wanted_port)) {
    port = wanted_port;
  }
  if (port <= 0) return false;
  server->KeepMoreInTheKernel();
  thread = std::thread([this] { server->listen_after_bind(); });
  while (!server->is_running()) std::this_thread::yield();  // before that it cannot be stopped
  return true;
}

absl::StatusOr<std::unique_ptr<HttpServer>> HttpServer::Start(const std::string& address, const std::string& what,
                                                              Handler handler, HttpSecurity security,
                                                              HttpLimits limits) {
  auto impl = std::make_unique<Impl>();
  impl->handler = std::move(handler);
  impl->security = std::move(security);
  impl->server = std::make_unique<TimedServer>(
      NewContext(impl->security),
      ConnectionLimits{.time = limits.time,
                       .time_while_others_wait = limits.read_time_while_others_wait,
                       .write_time_while_others_wait = limits.write_time_while_others_wait},
      limits.request_body_bytes);
  const size_t colon = address.rfind(':');
  std::string host = address.substr(0, colon);
  if (host.size() > 2 && host.front() == '[') host = host.substr(1, host.size() - 2);
  int port = -1;
  if (colon == std::string::npos || !absl::SimpleAtoi(address.substr(colon + 1), &port)) {
    return absl::InvalidArgumentError(absl::StrCat(address, ": expected HOST:PORT to serve ", what, " at"));
  }
  errno = 0;
  if (!impl->Listen(host, port, limits.request_body_bytes)) {
    const std::string why = errno == 0 ? "no address of this machine" : std::strerror(errno);
    return absl::UnavailableError(absl::StrCat(address, ": cannot serve ", what, " there: ", why));
  }
  return std::unique_ptr<HttpServer>(new HttpServer(std::move(impl)));
}

HttpServer::HttpServer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
HttpServer::~HttpServer() = default;

int HttpServer::port() const { return impl_->port; }

}  // namespace tilemend
