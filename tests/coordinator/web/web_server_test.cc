#include "coordinator/web/web_server.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <future>
#include <string>
#include <utility>
#include <vector>

#include "absl/time/time.h"
#include "coordinator/api/job_wait.h"
#include "tests/support/http_get.h"
#include "tests/support/test_cluster.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

class WebServerTest : public ::testing::Test {
 protected:
  void SetUp() override {
    auto server = WebServer::Start("127.0.0.1:0", cluster_.coordinator());
    ASSERT_TRUE(server.ok()) << server.status();
    server_ = *std::move(server);
  }
  std::string Ask(const std::string& request) const { return HttpAsk(server_->port(), request + "\r\n\r\n"); }

  TestCluster cluster_;
  std::unique_ptr<WebServer> server_;
};

TEST_F(WebServerTest, ServesThePageAndItsFilesCompressed) {
  const std::string page = Ask("GET / HTTP/1.1\r\nHost: localhost:1");
  EXPECT_THAT(page, StartsWith("HTTP/1.1 200 "));
  EXPECT_THAT(page, HasSubstr("<script src=\"/console.js\"></script>"));
  EXPECT_THAT(Ask("GET /console.js HTTP/1.1\r\nHost: 127.0.0.1"), HasSubstr("Content-Encoding: gzip"));
  EXPECT_THAT(Ask("GET /console.css HTTP/1.1\r\nHost: [::1]:1"), HasSubstr("Content-Type: text/css"));
  EXPECT_THAT(Ask("GET /etc/passwd HTTP/1.1\r\nHost: localhost"), StartsWith("HTTP/1.1 404 "));
  EXPECT_THAT(Ask("GET /../../etc/passwd HTTP/1.1\r\nHost: localhost"), StartsWith("HTTP/1.1 404 "));
  EXPECT_THAT(Ask("GET /%2e%2e/%2e%2e/etc/passwd HTTP/1.1\r\nHost: localhost"), StartsWith("HTTP/1.1 404 "));
  EXPECT_THAT(Ask("GET /v1/jobs HTTP/1.1\r\nHost: localhost"), HasSubstr("{\"jobs\":[]"));
}

TEST_F(WebServerTest, EveryAnswerHasTheSecurityHeaders) {
  for (const char* path : {"/", "/console.js", "/v1/jobs", "/v1/nothing", "/nothing"}) {
    const std::string answer = Ask(std::string("GET ") + path + " HTTP/1.1\r\nHost: localhost");
    EXPECT_THAT(answer, HasSubstr("Content-Security-Policy: default-src 'none'; script-src 'self'")) << path;
    EXPECT_THAT(answer, Not(HasSubstr("unsafe"))) << path;
    EXPECT_THAT(answer, HasSubstr("X-Content-Type-Options: nosniff")) << path;
    EXPECT_THAT(answer, HasSubstr("frame-ancestors 'none'")) << path;
  }
}

TEST_F(WebServerTest, AnotherSiteMayNotCall) {
  const std::string post = "POST /v1/jobs/1/cancel HTTP/1.1\r\nContent-Type: application/json\r\nContent-Length: 0\r\n";
  EXPECT_THAT(Ask(post + "Host: localhost:1\r\nOrigin: http://localhost:1"), StartsWith("HTTP/1.1 404 "));
  EXPECT_THAT(Ask(post + "Host: localhost:1\r\nOrigin: https://evil.example"), StartsWith("HTTP/1.1 403 "));
  EXPECT_THAT(Ask(post + "Host: localhost:1\r\nOrigin: null"), StartsWith("HTTP/1.1 403 "));
  EXPECT_THAT(Ask("GET /v1/jobs HTTP/1.1\r\nHost: localhost\r\nSec-Fetch-Site: cross-site\r\nSec-Fetch-Mode: no-cors"),
              StartsWith("HTTP/1.1 403 "));
  // A name that leads here: DNS rebinding.
  EXPECT_THAT(Ask("GET /v1/jobs HTTP/1.1\r\nHost: evil.example:80"), StartsWith("HTTP/1.1 421 "));
  for (const char* host :
       {"[evil.example]", "[::1", "[]", "[127.0.0.1]", "[::1].evil.example", "127.0.0.1.evil.example"}) {
    EXPECT_THAT(Ask(std::string("GET /v1/jobs HTTP/1.1\r\nHost: ") + host), StartsWith("HTTP/1.1 421 ")) << host;
  }
  EXPECT_THAT(Ask("GET /v1/jobs HTTP/1.1"), StartsWith("HTTP/1.1 421 "));
  EXPECT_THAT(Ask("POST / HTTP/1.1\r\nHost: localhost\r\nContent-Length: 0"), StartsWith("HTTP/1.1 405 "));
}

TEST_F(WebServerTest, SaysWhichMethodsAPathHas) {
  const std::vector<std::pair<std::string, std::string>> allowed_of = {
      {"/v1/workers", "GET, HEAD"}, {"/v1/jobs/1/cancel", "POST"}, {"/", "GET, HEAD"}, {"/console.js", "GET, HEAD"}};
  for (const std::string method : {"PUT", "PATCH", "DELETE", "OPTIONS"}) {
    const std::string rest = " HTTP/1.1\r\nHost: localhost\r\nContent-Length: 0";
    for (const auto& [path, allowed] : allowed_of) {
      const std::string answer = Ask(method + " " + path + rest);
      EXPECT_THAT(answer, StartsWith("HTTP/1.1 405 ")) << method << " " << path;
      EXPECT_THAT(answer, HasSubstr("\r\nAllow: " + allowed + "\r\n")) << method << " " << path;
      EXPECT_THAT(answer, HasSubstr("X-Content-Type-Options: nosniff")) << method << " " << path;
    }
    EXPECT_THAT(Ask(method + " /v1/nothing" + rest), StartsWith("HTTP/1.1 404 ")) << method;
  }
}

TEST_F(WebServerTest, WhereCallersHaveNamesAnyHostNameWillDo) {
  const auto server = WebServer::Start("127.0.0.1:0", cluster_.coordinator(), {.callers_have_names = true});
  ASSERT_TRUE(server.ok()) << server.status();
  EXPECT_THAT(HttpAsk((*server)->port(), "GET / HTTP/1.1\r\nHost: coordinator.example\r\n\r\n"),
              StartsWith("HTTP/1.1 200 "));
}

TEST_F(WebServerTest, AWatchIsAnsweredWhenTheJobIsOver) {
  const v1::Job job = cluster_.Submit("toy://2x1");
  const std::string path = "GET /v1/" + job.name() + "/watch?cursor=";
  auto answer = std::async(std::launch::async, [&] {
    return Ask(path + "18446744073709551615 HTTP/1.1\r\nHost: localhost");  // no state but the last is news
  });
  v1::CancelJobRequest cancel;
  cancel.set_name(job.name());
  ASSERT_TRUE(cluster_.coordinator().calls().jobs.CancelJob(cancel).ok());
  const auto longest = absl::ToChronoSeconds(kLongestJobWait / 2);
  ASSERT_EQ(answer.wait_for(longest), std::future_status::ready);
  EXPECT_THAT(answer.get(), HasSubstr("\"state\":\"CANCELLED\""));
}

TEST_F(WebServerTest, SaysIfItCannotServeThere) {
  const auto status = WebServer::Start("nowhere", cluster_.coordinator()).status();
  EXPECT_TRUE(absl::IsInvalidArgument(status)) << status;
}

}  // namespace
}  // namespace tilemend
