#include "common/metrics/status_server.h"

#include <httplib.h>
#include <openssl/crypto.h>
#include <openssl/ssl.h>

#include <cerrno>
#include <cstring>
#include <semaphore>
#include <thread>
#include <utility>

#include "absl/strings/ascii.h"
#include "absl/strings/numbers.h"
#include "absl/strings/str_cat.h"
#include "common/util/files.h"

namespace tilemend {
namespace {

constexpr size_t kThreads = 8;
constexpr std::ptrdiff_t kMostConnections = 64;  // that wait for a thread; the others wait in the kernel
constexpr time_t kRequestSeconds = 5;
constexpr size_t kMostRequestBytes = 4096;

constexpr char kMetricsType[] = "text/plain; version=0.0.4; charset=utf-8";
constexpr char kTextType[] = "text/plain; charset=utf-8";

// Threads that have a bounded queue before them: who comes when it is full waits to be accepted.
class BoundedPool : public httplib::TaskQueue {
 public:
  void enqueue(std::function<void()> answer) override {
    room_.acquire();
    pool_.enqueue([this, answer = std::move(answer)] {
      answer();
      room_.release();
    });
  }
  void shutdown() override { pool_.shutdown(); }

 private:
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

std::unique_ptr<httplib::Server> NewServer(StatusSecurity& security) {
  if (security.certificate.empty()) return std::make_unique<httplib::Server>();
  return std::make_unique<httplib::SSLServer>([&security](SSL_CTX& context) {
    SSL_CTX_set_min_proto_version(&context, TLS1_2_VERSION);
    SSL_CTX_set_cert_cb(&context, LoadCertificate, &security);
    return true;
  });
}

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
  std::unique_ptr<httplib::Server> server;
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
  server->new_task_queue = [] { return new BoundedPool; };
  server->set_default_headers({{"Cache-Control", "no-store"}});
  server->set_keep_alive_max_count(1);
  server->set_read_timeout(kRequestSeconds);
  server->set_write_timeout(kRequestSeconds);
  server->set_payload_max_length(kMostRequestBytes);
  server->set_socket_options(AllowAddressAgain);
  if (wanted_port == 0) {
    port = server->bind_to_any_port(host);
  } else if (server->bind_to_port(host, wanted_port)) {
    port = wanted_port;
  }
  if (port <= 0) return false;
  thread = std::thread([this] { server->listen_after_bind(); });
  while (!server->is_running()) std::this_thread::yield();  // before that it cannot be stopped
  return true;
}

absl::StatusOr<std::unique_ptr<StatusServer>> StatusServer::Start(const std::string& address, StatusPages pages,
                                                                  StatusSecurity security) {
  auto impl = std::make_unique<Impl>();
  impl->pages = std::move(pages);
  impl->security = std::move(security);
  impl->server = NewServer(impl->security);
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
