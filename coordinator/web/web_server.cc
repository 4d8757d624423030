#include "coordinator/web/web_server.h"

#include <arpa/inet.h>

#include <string_view>
#include <utility>

#include "absl/strings/match.h"
#include "absl/strings/str_cat.h"
#include "common/store/digest.h"
#include "coordinator/api/guarded_calls.h"
#include "coordinator/web/page_assets.h"
#include "coordinator/web/web_api.h"

namespace tilemend {
namespace {

constexpr char kPage[] =
    "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
    "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
    "<meta name=\"color-scheme\" content=\"light dark\">\n<title>tilemend</title>\n"
    "<link rel=\"icon\" href=\"data:,\">\n<link rel=\"stylesheet\" href=\"/console.css\">\n</head>\n<body>\n"
    "<main id=\"page\"><noscript>This page needs JavaScript. `tilemend list` shows the jobs as "
    "well.</noscript></main>\n"
    "<script src=\"/console.js\"></script>\n</body>\n</html>\n";

constexpr char kPolicy[] =
    "default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self' blob:; img-src 'self' data: blob:; "
    "worker-src blob:; "
    "base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

void AddSecurityHeaders(HttpAnswer& answer) {
  answer.headers.insert(answer.headers.end(), {{"Content-Security-Policy", kPolicy},
                                               {"X-Content-Type-Options", "nosniff"},
                                               {"X-Frame-Options", "DENY"},
                                               {"Referrer-Policy", "no-referrer"},
                                               {"Cross-Origin-Resource-Policy", "same-origin"},
                                               {"Cross-Origin-Opener-Policy", "same-origin"}});
}

HttpAnswer PlainAnswer(int status, std::string text) { return {.status = status, .body = std::move(text)}; }

// "HOST" of a Host header.
std::string HostOf(const HttpRequest& request) {
  const std::string host = request.Header("host");
  if (!absl::StartsWith(host, "[")) return host.substr(0, host.find(':'));
  const size_t after = host.find(']') + 1;
  return after == 0 || host.substr(after, 1) == ":" ? host.substr(0, after) : host;
}

bool IsAddressOrLocal(const std::string& host) {
  in_addr number{};
  in6_addr longer{};
  if (absl::StartsWith(host, "[") && absl::EndsWith(host, "]")) {
    return inet_pton(AF_INET6, host.substr(1, host.size() - 2).c_str(), &longer) == 1;
  }
  return host == "localhost" || inet_pton(AF_INET, host.c_str(), &number) == 1;
}

// Whether a page of another site makes the request.
bool IsFromAnotherSite(const HttpRequest& request) {
  const std::string origin = request.Header("origin"), host = request.Header("host");
  if (!origin.empty() && origin != absl::StrCat("http://", host) && origin != absl::StrCat("https://", host)) {
    return true;
  }
  return request.Header("sec-fetch-site") == "cross-site" && request.Header("sec-fetch-mode") != "navigate";
}

HttpAnswer AssetAnswer(const HttpRequest& request, const char* type, std::string_view bytes, bool gzip) {
  HttpAnswer answer;
  answer.type = type;
  const std::string tag = absl::StrCat("\"", Sha256Hex(bytes).substr(0, 32), "\"");
  answer.headers = {{"ETag", tag}, {"Cache-Control", "no-cache"}};
  if (request.HasTag(tag)) {
    answer.status = 304;
    return answer;
  }
  if (gzip) answer.headers.emplace_back("Content-Encoding", "gzip");
  answer.body.assign(bytes);
  return answer;
}

}  // namespace

struct WebServer::Impl {
  Impl(Coordinator& coordinator, std::shared_ptr<Gate> gate, const JobLogTail* log, std::string listen)
      : entrance(std::move(gate)), calls(coordinator.calls(), entrance), api(calls, log, std::move(listen)) {}

  HttpAnswer Answer(const HttpRequest& request);

  const Entrance entrance;
  const GuardedCalls calls;
  WebApi api;
  bool is_open = false;                // nobody needs a name
  std::unique_ptr<HttpServer> server;  // ends first
};

HttpAnswer WebServer::Impl::Answer(const HttpRequest& request) {
  if (is_open && !IsAddressOrLocal(HostOf(request))) {
    return PlainAnswer(421, "without tokens this page is found by address or as localhost alone\n");
  }
  if (IsFromAnotherSite(request)) return PlainAnswer(403, "a page of another site may not call this one\n");
  if (absl::StartsWith(request.path, "/v1/")) return api.Answer(request);
  if (request.method != "GET" && request.method != "HEAD") {
    HttpAnswer answer = PlainAnswer(405, "this is a page to read; the calls are below /v1/\n");
    answer.headers.emplace_back("Allow", "GET, HEAD");
    return answer;
  }
  if (request.path == "/" || request.path == "/index.html") {
    return AssetAnswer(request, "text/html; charset=utf-8", kPage, false);
  }
  if (request.path == "/console.js") {
    return AssetAnswer(request, "text/javascript; charset=utf-8", ConsoleScript(), true);
  }
  if (request.path == "/draco_decoder.js") {
    return AssetAnswer(request, "text/javascript; charset=utf-8", DracoDecoder(), true);
  }
  if (request.path == "/console.css") {
    return AssetAnswer(request, "text/css; charset=utf-8", ConsoleStyle(), true);
  }
  return PlainAnswer(404, "there is nothing here; the page is at /\n");
}

absl::StatusOr<std::unique_ptr<WebServer>> WebServer::Start(const std::string& address, Coordinator& coordinator,
                                                            WebOptions options) {
  if (options.gate == nullptr)
    options.gate = std::make_shared<Gate>(Access::Open(), *MetricsRegistry::Null(), *Log::Null());
  auto impl = std::make_unique<Impl>(coordinator, std::move(options.gate), options.log, std::move(options.listen));
  impl->is_open = !options.callers_have_names;
  HttpLimits limits;
  limits.time = absl::Seconds(60);
  limits.write_time_while_others_wait = absl::Seconds(20);
  auto server = HttpServer::Start(
      address, "the page",
      [&shared = *impl](const HttpRequest& request) {
        HttpAnswer answer = shared.Answer(request);
        AddSecurityHeaders(answer);
        return answer;
      },
      std::move(options.security), limits);
  if (!server.ok()) return server.status();
  impl->server = *std::move(server);
  return std::unique_ptr<WebServer>(new WebServer(std::move(impl)));
}

WebServer::WebServer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
WebServer::~WebServer() = default;

int WebServer::port() const { return impl_->server->port(); }

}  // namespace tilemend
