#include "common/http/http_server.h"

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <httplib.h>
#include <netinet/in.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/time/clock.h"
#include "tests/support/certificates.h"
#include "tests/support/http_get.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::StartsWith;

std::unique_ptr<HttpServer> Serve(HttpServer::Handler handler, HttpSecurity security = {}, HttpLimits limits = {}) {
  auto server = HttpServer::Start("127.0.0.1:0", "pages", std::move(handler), std::move(security), limits);
  EXPECT_TRUE(server.ok()) << server.status();
  return server.ok() ? *std::move(server) : nullptr;
}

int Connected(int port) {
  const int fd = socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return connect(fd, reinterpret_cast<sockaddr*>(&address), sizeof(address)) == 0 ? fd : -1;
}

std::string ReadAll(int fd) {
  std::string all;
  std::array<char, 4096> part{};
  for (ssize_t count = 0; (count = read(fd, part.data(), part.size())) > 0;)
    all.append(part.data(), static_cast<size_t>(count));
  close(fd);
  return all;
}

TEST(HttpServerTest, HandsOverWhatIsAskedAndAnswersIt) {
  const auto server = Serve([](const HttpRequest& request) {
    HttpAnswer answer;
    answer.status = 201;
    answer.type = "application/json";
    answer.body = absl::StrCat(request.method, " ", request.path, " ", request.query.at("a"), " ",
                               request.Header("x-own"), " ", request.Header("none"), request.body);
    answer.headers = {{"ETag", "\"1\""}};
    return answer;
  });
  httplib::Client client("127.0.0.1", server->port());
  const auto result = client.Post("/v1/x%20y?a=b%2Fc", {{"X-Own", "mine"}}, "body", "text/plain");
  ASSERT_TRUE(result);
  EXPECT_EQ(result->status, 201);
  EXPECT_EQ(result->body, "POST /v1/x y b/c mine body");
  EXPECT_EQ(result->get_header_value("ETag"), "\"1\"");
  EXPECT_EQ(result->get_header_value("Content-Type"), "application/json");
}

TEST(HttpServerTest, SaysWhereACallComesFrom) {
  const auto server = Serve([](const HttpRequest& request) { return HttpAnswer{.body = request.address}; });
  EXPECT_THAT(HttpGet(server->port(), "/"), HasSubstr("\r\n\r\n127.0.0.1:"));
}

TEST(HttpServerTest, NotModifiedHasNoBody) {
  const auto server = Serve([](const HttpRequest&) { return HttpAnswer{.status = 304, .body = "no"}; });
  EXPECT_THAT(HttpGet(server->port(), "/"), StartsWith("HTTP/1.1 304 "));
  EXPECT_THAT(HttpGet(server->port(), "/"), ::testing::Not(HasSubstr("no\n")));
}

TEST(HttpServerTest, CompressesNothingByItself) {
  const auto server = Serve([](const HttpRequest&) { return HttpAnswer{.body = std::string(100, 'a')}; });
  httplib::Client client("127.0.0.1", server->port());
  client.set_decompress(false);
  const auto result = client.Get("/", {{"Accept-Encoding", "gzip, br"}});
  ASSERT_TRUE(result);
  EXPECT_EQ(result->body, std::string(100, 'a'));
}

TEST(HttpServerTest, RefusesABodyThatIsTooLarge) {
  const auto server = Serve([](const HttpRequest&) { return HttpAnswer{.body = "taken"}; });
  const auto result = httplib::Client("127.0.0.1", server->port()).Post("/", std::string(5000, 'a'), "text/plain");
  ASSERT_TRUE(result);
  EXPECT_EQ(result->status, 413);
}

TEST(HttpServerTest, RefusesABodyByItsHead) {
  const auto server = Serve([](const HttpRequest& request) { return HttpAnswer{.body = request.body}; });
  const auto answer = [&](const std::string& field, const char* method = "POST") {
    const int fd = Connected(server->port());
    const std::string head = absl::StrCat(method, " / HTTP/1.1\r\nHost: x", field, "\r\n\r\n");
    EXPECT_EQ(write(fd, head.data(), head.size()), static_cast<ssize_t>(head.size()));
    std::string line(12, ' ');
    EXPECT_EQ(read(fd, line.data(), line.size()), 12);
    close(fd);
    return line;
  };
  EXPECT_EQ(answer("\r\nContent-Length: 4097"), "HTTP/1.1 413");
  EXPECT_EQ(answer("\r\nTransfer-Encoding: chunked"), "HTTP/1.1 411");
  EXPECT_EQ(answer("\r\nContent-Length: 0\r\nExpect: 100-continue"), "HTTP/1.1 417");
  EXPECT_EQ(answer("\r\nContent-Length: 0\r\nContent-Length: 40"), "HTTP/1.1 400");
  EXPECT_EQ(answer("\r\nContent-Length: 0\r\nHost: y"), "HTTP/1.1 400");
  EXPECT_EQ(answer("\r\nContent-Length: 0"), "HTTP/1.1 200");
  for (const char* method : {"POST", "PUT", "PATCH", "DELETE", "PRI"}) {
    EXPECT_EQ(answer("", method), "HTTP/1.1 411") << method;
  }
}

TEST(HttpServerTest, DoesNothingForACallerThatWaitsToSendItsBody) {
  std::atomic<int> calls = 0;
  const auto server = Serve([&](const HttpRequest&) {
    ++calls;
    return HttpAnswer{};
  });
  const int fd = Connected(server->port());
  const std::string head = "POST / HTTP/1.1\r\nHost: x\r\nContent-Length: 2\r\nExpect: 100-continue\r\n\r\nab";
  ASSERT_EQ(write(fd, head.data(), head.size()), static_cast<ssize_t>(head.size()));
  const std::string answer = ReadAll(fd);
  EXPECT_TRUE(answer.starts_with("HTTP/1.1 417")) << answer;
  EXPECT_EQ(answer.find("HTTP/1.1", 1), std::string::npos) << "one answer: " << answer;
  EXPECT_EQ(calls, 0);
}

TEST(HttpServerTest, KnowsATagHoweverItComes) {
  const auto has = [](const std::string& header) {
    HttpRequest request;
    request.headers["if-none-match"] = header;
    return request.HasTag("\"ab\"");
  };
  for (const char* header : {"\"ab\"", "W/\"ab\"", "\"x\", W/\"ab\"", "*"}) EXPECT_TRUE(has(header)) << header;
  for (const char* header : {"", "\"abc\"", "ab", "W/", ","}) EXPECT_FALSE(has(header)) << header;
}

TEST(HttpServerTest, KeepsWhatAnAnswerHoldsUntilItIsSent) {
  constexpr size_t kMuch = size_t{32} << 20;  // more than the sockets take
  const auto held = std::make_shared<int>(0);
  const auto server =
      Serve([&](const HttpRequest&) { return HttpAnswer{.body = std::string(kMuch, 'a'), .until_sent = held}; });
  const int fd = Connected(server->port());
  constexpr char kHead[] = "GET / HTTP/1.1\r\nHost: x\r\n\r\n";
  ASSERT_EQ(write(fd, kHead, sizeof(kHead) - 1), static_cast<ssize_t>(sizeof(kHead) - 1));
  std::vector<char> part(size_t{1} << 20);
  size_t read_bytes = 0;
  for (ssize_t count = 1; count > 0; read_bytes += static_cast<size_t>(count)) {
    EXPECT_TRUE(read_bytes == 0 || read_bytes > kMuch / 4 || held.use_count() > 1) << read_bytes;
    count = std::max<ssize_t>(read(fd, part.data(), part.size()), 0);
  }
  close(fd);
  EXPECT_GT(read_bytes, kMuch);
  for (int i = 0; i < 1000 && held.use_count() > 1; ++i) absl::SleepFor(absl::Milliseconds(10));
  EXPECT_EQ(held.use_count(), 1);
}

// A server that holds every request for /wait until it is told.
class HoldingServer {
 public:
  explicit HoldingServer(HttpSecurity security = {}, HttpLimits limits = {})
      : server_(Serve([this](const HttpRequest& request) { return Answer(request); }, std::move(security), limits)) {}
  // Those that wait have called; so many are there.
  void AwaitHeld(size_t count) {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait(lock, [&] { return held_.size() >= count; });
  }
  void WakeAll() {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (const auto& wake : held_) wake();
  }
  int port() const { return server_->port(); }
  std::shared_ptr<int> kept = std::make_shared<int>(0);  // by each wait

 private:
  HttpAnswer Answer(const HttpRequest& request) {
    HttpAnswer answer{.body = absl::StrCat(request.body, request.has_waited ? " waited" : " at once")};
    if (request.path != "/wait" || request.has_waited) return answer;
    answer.wait = [this](std::function<void()> wake) {
      const std::lock_guard<std::mutex> lock(mutex_);
      held_.push_back(std::move(wake));
      changed_.notify_all();
      return kept;
    };
    return answer;
  }
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::function<void()>> held_;
  std::unique_ptr<HttpServer> server_;  // last: it uses the others
};

constexpr char kWaitingPost[] = "POST /wait HTTP/1.1\r\nHost: x\r\nContent-Length: 4\r\n\r\nbody";

TEST(HttpServerTest, AnswersThatWaitHoldNoThread) {
  HoldingServer server;
  std::vector<int> open;
  for (int i = 0; i < 100; ++i) {
    open.push_back(Connected(server.port()));
    ASSERT_EQ(write(open.back(), kWaitingPost, sizeof(kWaitingPost) - 1),
              static_cast<ssize_t>(sizeof(kWaitingPost) - 1));
  }
  server.AwaitHeld(100);  // 16 threads
  EXPECT_THAT(HttpGet(server.port(), "/"), HasSubstr(" at once"));
  char byte = 0;
  EXPECT_EQ(recv(open.front(), &byte, 1, MSG_PEEK | MSG_DONTWAIT), -1) << "answered before it was woken";
  server.WakeAll();
  for (const int fd : open) EXPECT_THAT(ReadAll(fd), HasSubstr("\r\n\r\nbody waited"));
  for (int i = 0; i < 1000 && server.kept.use_count() > 1; ++i) absl::SleepFor(absl::Milliseconds(10));
  EXPECT_EQ(server.kept.use_count(), 1);
}

TEST(HttpServerTest, TheTimeOfAnAnswerThatWaitedBeginsWhenItIsWoken) {
  HoldingServer server({}, {.time = absl::Milliseconds(200)});
  const int fd = Connected(server.port());
  ASSERT_EQ(write(fd, kWaitingPost, sizeof(kWaitingPost) - 1), static_cast<ssize_t>(sizeof(kWaitingPost) - 1));
  server.AwaitHeld(1);
  absl::SleepFor(absl::Milliseconds(300));
  server.WakeAll();
  EXPECT_THAT(ReadAll(fd), HasSubstr("body waited"));
}

TEST(HttpServerTest, TheFirstOfTooManyThatWaitIsAnswered) {
  HoldingServer server;
  std::vector<int> open;
  for (size_t i = 0; i < 257; ++i) {
    open.push_back(Connected(server.port()));
    ASSERT_EQ(write(open.back(), kWaitingPost, sizeof(kWaitingPost) - 1),
              static_cast<ssize_t>(sizeof(kWaitingPost) - 1));
    server.AwaitHeld(i + 1);
  }
  EXPECT_THAT(ReadAll(open.front()), HasSubstr("body waited"));
  char byte = 0;
  EXPECT_EQ(recv(open[1], &byte, 1, MSG_PEEK | MSG_DONTWAIT), -1);
  for (size_t i = 1; i < open.size(); ++i) close(open[i]);
}

TEST(HttpServerTest, AnswersThatWaitEndWithTheServer) {
  auto server = std::make_unique<HoldingServer>();
  const std::shared_ptr<int> kept = server->kept;
  const int fd = Connected(server->port());
  ASSERT_EQ(write(fd, kWaitingPost, sizeof(kWaitingPost) - 1), static_cast<ssize_t>(sizeof(kWaitingPost) - 1));
  server->AwaitHeld(1);
  server = nullptr;
  EXPECT_EQ(ReadAll(fd), "");
  EXPECT_EQ(kept.use_count(), 1);
}

TEST(HttpServerTest, WaitsOverTlsAsWell) {
  const TemporaryFolder folder;
  const TestAuthority ours(folder.path(), "ours");
  const TlsFiles own = ours.Issue("server", {"server"}), caller = ours.Issue("ann", {"ann", {"watch"}});
  HoldingServer server({own.certificate, own.key, own.authority});
  httplib::Client client(absl::StrCat("https://127.0.0.1:", server.port()), caller.certificate, caller.key);
  client.set_ca_cert_path(ours.path());
  std::thread waker([&] {
    server.AwaitHeld(1);
    server.WakeAll();
  });
  const auto result = client.Post("/wait", "body", "text/plain");
  waker.join();
  ASSERT_TRUE(result);
  EXPECT_EQ(result->body, "body waited");
}

TEST(HttpServerTest, TwoThousandOpenConnectionsHoldNobodyUp) {
  rlimit limit{};
  ASSERT_EQ(getrlimit(RLIMIT_NOFILE, &limit), 0);
  limit.rlim_cur = limit.rlim_max;
  setrlimit(RLIMIT_NOFILE, &limit);
  if (limit.rlim_cur < 5000) GTEST_SKIP() << "needs 5,000 open files";
  const auto server = Serve([](const HttpRequest&) { return HttpAnswer{.body = "here"}; });
  std::vector<int> open;
  for (int i = 0; i < 2000; ++i) open.push_back(Connected(server->port()));
  EXPECT_THAT(open, ::testing::Not(Contains(-1)));
  httplib::Client client("127.0.0.1", server->port());
  client.set_read_timeout(90);
  const auto result = client.Get("/");
  ASSERT_TRUE(result);
  EXPECT_EQ(result->body, "here");
  char byte = 0;
  EXPECT_EQ(recv(open.back(), &byte, 1, MSG_PEEK | MSG_DONTWAIT), -1) << "was closed before the answer came";
  EXPECT_EQ(errno, EAGAIN);
  for (const int fd : open) close(fd);
}

TEST(HttpServerTest, TakesOnlyCertificatesOfItsAuthorityAndSaysWhoseTheyAre) {
  const TemporaryFolder folder;
  const TestAuthority ours(folder.path(), "ours"), others(folder.path(), "others");
  const TlsFiles own = ours.Issue("server", {"server"});
  const TlsFiles caller = ours.Issue("ann", {"ann", {"watch"}}), stranger = others.Issue("eve", {"eve", {"admin"}});
  const auto server = Serve(
      [](const HttpRequest& request) {
        HttpAnswer answer{.body = request.certificate_name};
        for (const std::string& name : request.certificate_uris) absl::StrAppend(&answer.body, " ", name);
        return answer;
      },
      {own.certificate, own.key, own.authority});
  const auto get = [&](const TlsFiles* files) {
    const std::string address = absl::StrCat("https://127.0.0.1:", server->port());
    auto client = files == nullptr ? std::make_unique<httplib::Client>(address)
                                   : std::make_unique<httplib::Client>(address, files->certificate, files->key);
    client->set_ca_cert_path(ours.path());
    const auto result = client->Get("/");
    return result ? result->body : "refused";
  };
  EXPECT_THAT(get(&caller), StartsWith("ann "));
  EXPECT_THAT(get(&caller), HasSubstr("tilemend:role:watch"));
  EXPECT_EQ(get(&stranger), "refused");
  EXPECT_EQ(get(nullptr), "refused");
}

TEST(HttpServerTest, SaysWhatItCannotServe) {
  const auto answer = [](const HttpRequest&) { return HttpAnswer(); };
  const auto wrong = HttpServer::Start("nowhere", "the page", answer);
  EXPECT_TRUE(absl::IsInvalidArgument(wrong.status()));
  EXPECT_THAT(std::string(wrong.status().message()), HasSubstr("expected HOST:PORT to serve the page at"));
  const auto first = Serve(answer);
  const auto second = HttpServer::Start(absl::StrCat("127.0.0.1:", first->port()), "the page", answer);
  EXPECT_TRUE(absl::IsUnavailable(second.status()));
}

}  // namespace
}  // namespace tilemend
