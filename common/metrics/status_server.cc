#include "common/metrics/status_server.h"

#include <httplib.h>
#include <openssl/crypto.h>
#include <openssl/ssl.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <functional>
#include <semaphore>
#include <thread>
#include <utility>

#include "absl/strings/ascii.h"
#include "absl/strings/numbers.h"
#include "absl/strings/str_cat.h"
#include "common/metrics/timed_connection.h"
#include "common/util/files.h"

namespace tilemend {
namespace {

constexpr size_t kThreads = 16;
constexpr std::ptrdiff_t kMostConnections = 64;  // served or waiting for a thread; the others wait in the kernel
constexpr size_t kMostRequestBytes = 4096;

constexpr char kMetricsType[] = "text/plain; version=0.0.4; charset=utf-8";
constexpr char kTextType[] = "text/plain; charset=utf-8";

// Threads that have a bounded queue before them: who comes when it is full waits to be accepted.
class BoundedPool : public httplib::TaskQueue {
 public:
  explicit BoundedPool(std::atomic<int>& waiting) : waiting_(waiting) {}
  void enqueue(std::function<void()> answer) override {
    room_.acquire();
    ++waiting_;
    pool_.enqueue([this, answer = std::move(answer)] {
      --waiting_;
      answer();
      room_.release();
    });
  }
  void shutdown() override { pool_.shutdown(); }

 private:
  std::atomic<int>& waiting_;  // for a thread
  std::counting_semaphore<kMostConnections> room_{kMostConnections};
  httplib::ThreadPool pool_{kThreads};
};

// Before each handshake, so that a new certificate is shown at once.
int LoadCertificate(SSL* connection, void* data) {
  const auto& security = *static_cast<const StatusSecurity*>(data);
  return SSL_use_certificate_chain_file(connection, security.certificate.c_str()) == 1 &&
                 SSL_use_PrivateKey_file(connection, security.key.c_str(), SSL_FILETYPE_PEM) == 1
             ? 1
             : 0;
}

struct FreeContext {
  void operator()(SSL_CTX* context) const { SSL_CTX_free(context); }
};
using TlsContext = std::unique_ptr<SSL_CTX, FreeContext>;

// None for plain text. `security` must outlive it.
TlsContext NewContext(StatusSecurity& security) {
  if (security.certificate.empty()) return nullptr;
  TlsContext context(SSL_CTX_new(TLS_server_method()));
  SSL_CTX_set_min_proto_version(context.get(), TLS1_2_VERSION);
  SSL_CTX_set_cert_cb(context.get(), LoadCertificate, &security);
  return context;
}

// One request for each connection, and a bounded time for both.
class TimedServer : public httplib::Server {
 public:
  explicit TimedServer(TlsContext context) : context_(std::move(context)) {
    new_task_queue = [this] { return new BoundedPool(waiting_); };
  }
  // Once it is bound. The library has the kernel keep five connections, and a sixth tries again after a second.
  void KeepMoreInTheKernel() { ::listen(svr_sock_.load(), SOMAXCONN); }

 private:
  bool process_and_close_socket(socket_t fd) override {
    TimedConnection connection(fd, {}, [this] { return waiting_ > 0; });
    if (context_ != nullptr && !connection.Encrypt(context_.get())) return false;
    bool closed = false;
    // A page is answered whole: 8 KB of ranges made an answer of 0.2 GB.
    return process_request(connection, true, closed, [](httplib::Request& request) { request.ranges.clear(); });
  }

  const TlsContext context_;
  std::atomic<int> waiting_{0};
};

// Of a file that cannot be read nothing is let in. Takes the same time for every wrong token of the right length.
bool ShowsToken(const httplib::Request& request, const std::string& token_file) {
  if (token_file.empty()) return true;
  const auto token = ReadOwnFile(token_file);
  if (!token.ok()) return false;
  const std::string expected = absl::StrCat("Bearer ", absl::StripAsciiWhitespace(*token));
  const std::string shown = request.get_header_value("Authorization");
  return shown.size() == expected.size() && CRYPTO_memcmp(shown.data(), expected.data(), expected.size()) == 0;
}

void AllowAddressAgain(int socket) {
  const int yes = 1;
  setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof(yes));
}

}  // namespace

struct StatusServer::Impl {
  ~Impl() {
    if (!thread.joinable()) return;
    server->stop();
    thread.join();
  }
  void AddPages();
  bool Listen(const std::string& host, int wanted_port);

  StatusPages pages;
  StatusSecurity security;
  std::unique_ptr<TimedServer> server;
  int port = 0;
  std::thread thread;
};

void StatusServer::Impl::AddPages() {
  server->Get("/metrics", [this](const httplib::Request& request, httplib::Response& response) {
    if (ShowsToken(request, security.token_file)) return response.set_content(pages.metrics(), kMetricsType);
    response.status = 401;
    response.set_header("WWW-Authenticate", "Bearer");
    response.set_content("needs the token of --metrics-token\n", kTextType);
  });
  server->Get("/healthz",
              [](const httplib::Request&, httplib::Response& response) { response.set_content("ok\n", kTextType); });
  server->Get("/readyz", [this](const httplib::Request&, httplib::Response& response) {
    const std::string reason = pages.not_ready();
    response.status = reason.empty() ? 200 : 503;
    response.set_content(reason.empty() ? "ready\n" : reason + "\n", kTextType);
  });
  server->Get(".*", [](const httplib::Request&, httplib::Response& response) {
    response.status = 404;
    response.set_content("there are /metrics, /healthz and /readyz\n", kTextType);
  });
}

bool StatusServer::Impl::Listen(const std::string& host, int wanted_port) {
  server->set_default_headers({{"Cache-Control", "no-store"}});
  server->set_payload_max_length(kMostRequestBytes);
  server->set_socket_options(AllowAddressAgain);
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

absl::StatusOr<std::unique_ptr<StatusServer>> StatusServer::Start(const std::string& address, StatusPages pages,
                                                                  StatusSecurity security) {
  auto impl = std::make_unique<Impl>();
  impl->pages = std::move(pages);
  impl->security = std::move(security);
  impl->server = std::make_unique<TimedServer>(NewContext(impl->security));
  impl->AddPages();
  const size_t colon = address.rfind(':');
  std::string host = address.substr(0, colon);
  if (host.size() > 2 && host.front() == '[') host = host.substr(1, host.size() - 2);
  int port = -1;
  if (colon == std::string::npos || !absl::SimpleAtoi(address.substr(colon + 1), &port)) {
    return absl::InvalidArgumentError(absl::StrCat(address, ": expected HOST:PORT to serve metrics at"));
  }
  errno = 0;
  if (!impl->Listen(host, port)) {
    const std::string why = errno == 0 ? "no address of this machine" : std::strerror(errno);
    return absl::UnavailableError(absl::StrCat(address, ": cannot serve metrics there: ", why));
  }
  return std::unique_ptr<StatusServer>(new StatusServer(std::move(impl)));
}

StatusServer::StatusServer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
StatusServer::~StatusServer() = default;

int StatusServer::port() const { return impl_->port; }

}  // namespace tilemend
