#include "common/metrics/status_server.h"

#include <openssl/crypto.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"
#include "common/http/http_server.h"
#include "common/util/files.h"

namespace tilemend {
namespace {

constexpr char kMetricsType[] = "text/plain; version=0.0.4; charset=utf-8";

// Of a file that cannot be read nothing is let in. Takes the same time for every wrong token of the right length.
bool ShowsToken(const HttpRequest& request, const std::string& token_file) {
  if (token_file.empty()) return true;
  const auto token = ReadOwnFile(token_file);
  if (!token.ok()) return false;
  const std::string expected = absl::StrCat("Bearer ", absl::StripAsciiWhitespace(*token));
  const std::string shown = request.Header("authorization");
  return shown.size() == expected.size() && CRYPTO_memcmp(shown.data(), expected.data(), expected.size()) == 0;
}

HttpAnswer Text(int status, std::string text) { return {.status = status, .body = std::move(text)}; }

HttpAnswer PageOf(const HttpRequest& request, const StatusPages& pages, const std::string& token_file) {
  constexpr const char* kPaths[] = {"/metrics", "/healthz", "/readyz"};
  if (std::ranges::find(kPaths, request.path) == std::end(kPaths)) {
    return Text(404, "there are /metrics, /healthz and /readyz\n");
  }
  if (request.method != "GET" && request.method != "HEAD") {
    HttpAnswer answer = Text(405, "this is a page to read\n");
    answer.headers = {{"Allow", "GET, HEAD"}};
    return answer;
  }
  if (request.path == "/healthz") return Text(200, "ok\n");
  if (request.path == "/readyz") {
    const std::string reason = pages.not_ready();
    return reason.empty() ? Text(200, "ready\n") : Text(503, reason + "\n");
  }
  if (ShowsToken(request, token_file)) return {.type = kMetricsType, .body = pages.metrics()};
  HttpAnswer answer = Text(401, "needs the token of --metrics-token\n");
  answer.headers = {{"WWW-Authenticate", "Bearer"}};
  return answer;
}

}  // namespace

absl::StatusOr<std::unique_ptr<StatusServer>> StatusServer::Start(const std::string& address, StatusPages pages,
                                                                  StatusSecurity security) {
  const HttpSecurity tls{security.certificate, security.key};
  auto server = HttpServer::Start(
      address, "metrics",
      [pages = std::move(pages), token_file = security.token_file](const HttpRequest& request) {
        HttpAnswer answer = PageOf(request, pages, token_file);
        answer.headers.emplace_back("Cache-Control", "no-store");
        return answer;
      },
      tls);
  if (!server.ok()) return server.status();
  return std::unique_ptr<StatusServer>(new StatusServer(*std::move(server)));
}

StatusServer::StatusServer(std::unique_ptr<HttpServer> server) : server_(std::move(server)) {}
StatusServer::~StatusServer() = default;

int StatusServer::port() const { return server_->port(); }

}  // namespace tilemend
