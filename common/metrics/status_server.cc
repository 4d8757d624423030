#include "common/metrics/status_server.h"

#include <civetweb.h>

#include <array>
#include <utility>

#include "absl/strings/str_cat.h"

namespace tilemend {
namespace {

constexpr char kThreads[] = "8";
constexpr char kRequestTimeoutMs[] = "5000";

constexpr char kMetricsType[] = "text/plain; version=0.0.4; charset=utf-8";
constexpr char kTextType[] = "text/plain; charset=utf-8";

int Answer(mg_connection* connection, const char* status, const char* type, const std::string& text) {
  const std::string head =
      absl::StrCat("HTTP/1.1 ", status, "\r\nContent-Type: ", type, "\r\nContent-Length: ", text.size(),
                   "\r\nCache-Control: no-store\r\nConnection: close\r\n\r\n");
  mg_write(connection, head.data(), head.size());
  mg_write(connection, text.data(), text.size());
  return 1;
}

int Show(mg_connection* connection, void* data) {
  const StatusPages& pages = *static_cast<StatusPages*>(data);
  const char* const uri = mg_get_request_info(connection)->local_uri;
  const std::string path = uri == nullptr ? "" : uri;
  if (path == "/metrics") return Answer(connection, "200 OK", kMetricsType, pages.metrics());
  if (path == "/healthz") return Answer(connection, "200 OK", kTextType, "ok\n");
  if (path != "/readyz") {
    return Answer(connection, "404 Not Found", kTextType, "there are /metrics, /healthz and /readyz\n");
  }
  const std::string reason = pages.not_ready();
  if (reason.empty()) return Answer(connection, "200 OK", kTextType, "ready\n");
  return Answer(connection, "503 Service Unavailable", kTextType, reason + "\n");
}

}  // namespace

struct StatusServer::Impl {
  ~Impl() {
    if (context != nullptr) mg_stop(context);
  }
  StatusPages pages;
  mg_context* context = nullptr;
};

absl::StatusOr<std::unique_ptr<StatusServer>> StatusServer::Start(const std::string& address, StatusPages pages) {
  auto impl = std::make_unique<Impl>();
  impl->pages = std::move(pages);
  std::array<const char*, 7> options = {"listening_ports",    address.c_str(),   "num_threads", kThreads,
                                        "request_timeout_ms", kRequestTimeoutMs, nullptr};
  const mg_callbacks callbacks{};
  impl->context = mg_start(&callbacks, nullptr, options.data());
  if (impl->context == nullptr) {
    return absl::UnavailableError(absl::StrCat(address, ": cannot serve metrics there; choose another address"));
  }
  mg_set_request_handler(impl->context, "/", Show, &impl->pages);
  return std::unique_ptr<StatusServer>(new StatusServer(std::move(impl)));
}

StatusServer::StatusServer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
StatusServer::~StatusServer() = default;

int StatusServer::port() const {
  mg_server_port port{};
  return mg_get_server_ports(impl_->context, 1, &port) > 0 ? port.port : 0;
}

}  // namespace tilemend
