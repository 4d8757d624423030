#include "common/metrics/status_server.h"

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <httplib.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "absl/time/clock.h"
#include "tests/support/certificates.h"
#include "tests/support/http_get.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

// A connection that says only half of what it wants.
int HalfOpen(int port) {
  const int fd = socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  EXPECT_EQ(connect(fd, reinterpret_cast<sockaddr*>(&address), sizeof(address)), 0);
  EXPECT_GT(send(fd, "GET /metrics HT", 15, 0), 0);
  return fd;
}

TEST(StatusServerTest, ServesMetricsAsTheyAre) {
  std::atomic<int> value{1};
  const auto server =
      StatusServer::Start("127.0.0.1:0", {[&value] { return "things_total " + std::to_string(value) + "\n"; }});
  ASSERT_TRUE(server.ok()) << server.status();
  ASSERT_GT((*server)->port(), 0);
  EXPECT_THAT(HttpGet((*server)->port(), "/metrics"), HasSubstr("things_total 1\n"));
  value = 2;
  EXPECT_THAT(HttpGet((*server)->port(), "/metrics"), HasSubstr("things_total 2\n"));
}

TEST(StatusServerTest, IsHealthyBeforeItIsReady) {
  std::atomic<bool> ready{false};
  const auto server = StatusServer::Start(
      "127.0.0.1:0", {[] { return ""; }, [&ready] { return ready ? "" : "the coordinator does not answer"; }});
  ASSERT_TRUE(server.ok()) << server.status();
  EXPECT_THAT(HttpGet((*server)->port(), "/healthz"), StartsWith("HTTP/1.1 200 "));
  const std::string answer = HttpGet((*server)->port(), "/readyz");
  EXPECT_THAT(answer, StartsWith("HTTP/1.1 503 "));
  EXPECT_THAT(answer, HasSubstr("the coordinator does not answer"));
  ready = true;
  EXPECT_THAT(HttpGet((*server)->port(), "/readyz"), StartsWith("HTTP/1.1 200 "));
}

TEST(StatusServerTest, HasNoOtherPages) {
  const auto server = StatusServer::Start("127.0.0.1:0", {[] { return ""; }});
  ASSERT_TRUE(server.ok()) << server.status();
  EXPECT_THAT(HttpGet((*server)->port(), "/etc/passwd"), StartsWith("HTTP/1.1 404 "));
  EXPECT_THAT(HttpGet((*server)->port(), "/metrics/.."), StartsWith("HTTP/1.1 404 "));
  for (const char* method : {"POST", "PUT", "DELETE"}) {
    const std::string head = std::string(method) + " /metrics HTTP/1.1\r\nHost: x\r\nContent-Length: 0\r\n\r\n";
    const std::string answer = HttpAsk((*server)->port(), head);
    EXPECT_THAT(answer, StartsWith("HTTP/1.1 405 ")) << method;
    EXPECT_THAT(answer, HasSubstr("\r\nAllow: GET, HEAD\r\n")) << method;
  }
}

TEST(StatusServerTest, AnswersBesideRequestsThatNeverEnd) {
  const auto server = StatusServer::Start("127.0.0.1:0", {[] { return "here\n"; }});
  ASSERT_TRUE(server.ok()) << server.status();
  // Twice as many as it has threads.
  std::vector<int> open;
  for (int i = 0; i < 32; ++i) open.push_back(HalfOpen((*server)->port()));
  const absl::Time begin = absl::Now();
  EXPECT_THAT(HttpGet((*server)->port(), "/metrics"), HasSubstr("here\n"));
  EXPECT_LT(absl::Now() - begin, absl::Seconds(4));  // less than those have that keep nobody waiting
  for (const int fd : open) close(fd);
}

TEST(StatusServerTest, EndsAHeadThatNeverEnds) {
  const auto server = StatusServer::Start("127.0.0.1:0", {[] { return "here\n"; }});
  ASSERT_TRUE(server.ok()) << server.status();
  const int fd = HalfOpen((*server)->port());
  const std::string header = "TP/1.1\r\nX-Long: " + std::string(4000, 'a') + "\r\n";
  size_t sent = 0;
  for (ssize_t count = 1; count > 0 && sent < (size_t{1} << 30); sent += static_cast<size_t>(count)) {
    count = std::max<ssize_t>(0, send(fd, header.data(), header.size(), MSG_NOSIGNAL));
  }
  close(fd);
  EXPECT_LT(sent, size_t{64} << 20);  // what the kernel holds of it, at most
  EXPECT_THAT(HttpGet((*server)->port(), "/metrics"), HasSubstr("here\n"));
}

TEST(StatusServerTest, AnswersAPageOnceHoweverManyRangesAreAskedFor) {
  const auto server = StatusServer::Start("127.0.0.1:0", {[] { return "here\n"; }});
  ASSERT_TRUE(server.ok()) << server.status();
  const auto result =
      httplib::Client("127.0.0.1", (*server)->port()).Get("/metrics", {{"Range", "bytes=0-,0-,0-,1-2"}});
  ASSERT_TRUE(result);
  EXPECT_EQ(result->status, 200);
  EXPECT_EQ(result->body, "here\n");
}

TEST(StatusServerTest, SaysWhenItsPortIsTaken) {
  const auto first = StatusServer::Start("127.0.0.1:0", {[] { return ""; }});
  ASSERT_TRUE(first.ok()) << first.status();
  const std::string address = "127.0.0.1:" + std::to_string((*first)->port());
  const auto second = StatusServer::Start(address, {[] { return ""; }});
  EXPECT_TRUE(absl::IsUnavailable(second.status())) << second.status();
  EXPECT_THAT(std::string(second.status().message()),
              HasSubstr(address + ": cannot serve metrics there: Address already in use"));
  EXPECT_TRUE(absl::IsInvalidArgument(StatusServer::Start("nowhere", {[] { return ""; }}).status()));
}

class SecuredStatusServerTest : public ::testing::Test {
 protected:
  void Start(StatusSecurity security) {
    auto server = StatusServer::Start("127.0.0.1:0", {[] { return "here\n"; }}, std::move(security));
    ASSERT_TRUE(server.ok()) << server.status();
    server_ = *std::move(server);
  }
  // The status, 0 without an answer. With an authority over TLS, else in plain text.
  int Get(const std::string& path, const std::string& authorization, const std::string& authority = "") {
    const std::string address =
        (authority.empty() ? "http://127.0.0.1:" : "https://127.0.0.1:") + std::to_string(server_->port());
    httplib::Client client(address);
    if (!authority.empty()) client.set_ca_cert_path(authority);
    httplib::Headers headers;
    if (!authorization.empty()) headers.emplace("Authorization", authorization);
    const httplib::Result result = client.Get(path, headers);
    return result ? result->status : 0;
  }
  TemporaryFolder folder_;
  std::unique_ptr<StatusServer> server_;
};

TEST_F(SecuredStatusServerTest, ShowsMetricsToThoseWhoHaveTheToken) {
  const std::string token = folder_.Write("token", "secret\n");
  Start({"", "", token});
  EXPECT_EQ(Get("/metrics", "Bearer secret"), 200);
  for (const char* wrong :
       {"", "Bearer guess!", "Bearer secre", "Bearer secrets", "Basic secret", "secret", "Bearer "}) {
    EXPECT_EQ(Get("/metrics", wrong), 401) << wrong;
  }
  EXPECT_EQ(Get("/healthz", ""), 200);
  EXPECT_EQ(Get("/readyz", ""), 200);
  folder_.Write("token", "another");
  EXPECT_EQ(Get("/metrics", "Bearer secret"), 401);
  EXPECT_EQ(Get("/metrics", "Bearer another"), 200);
  ASSERT_EQ(std::remove(token.c_str()), 0);
  EXPECT_EQ(Get("/metrics", "Bearer another"), 401);
  EXPECT_EQ(Get("/metrics", "Bearer "), 401);
}

TEST_F(SecuredStatusServerTest, ServesOverTlsAloneAndTakesUpNewCertificates) {
  const TestAuthority authority(folder_.path(), "authority"), next(folder_.path(), "next");
  const TlsFiles files = authority.Issue("server", {"server"});
  Start({files.certificate, files.key, ""});
  EXPECT_EQ(Get("/metrics", "", authority.path()), 200);
  EXPECT_EQ(Get("/metrics", "", next.path()), 0);
  EXPECT_EQ(Get("/metrics", ""), 0);  // plain text
  next.Issue("server", {"server"});
  EXPECT_EQ(Get("/metrics", "", next.path()), 200);
  EXPECT_EQ(Get("/metrics", "", authority.path()), 0);
}

}  // namespace
}  // namespace tilemend
