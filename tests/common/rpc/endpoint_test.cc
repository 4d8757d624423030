#include "common/rpc/endpoint.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <chrono>
#include <memory>
#include <string>

#include "tilemend/v1/work.grpc.pb.h"

namespace tilemend {
namespace {

using testing::HasSubstr;

// A server needs a service.
class RpcServerTest : public testing::Test {
 protected:
  absl::StatusOr<std::unique_ptr<RpcServer>> Start(const std::string& listen) {
    return RpcServer::Start(listen, {&service_});
  }
  v1::Work::Service service_;
};

bool CanReach(const std::shared_ptr<grpc::Channel>& channel) {
  return channel->WaitForConnected(std::chrono::system_clock::now() + std::chrono::seconds(20));
}

TEST(CheckAddressTest, WantsAHostAndAPort) {
  for (const char* address : {"127.0.0.1:7070", "localhost:0", "[::1]:65535", "a.b-c:1"}) {
    EXPECT_TRUE(CheckAddress(address).ok()) << address;
  }
  for (const char* address : {"", "7070", ":7070", "host", "host:", "host:-1", "host:65536", "host:http", "host:7 0"}) {
    const absl::Status status = CheckAddress(address);
    EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument) << address;
    EXPECT_THAT(std::string(status.message()), HasSubstr("expected HOST:PORT"));
  }
}

TEST_F(RpcServerTest, ListensOnAFreePort) {
  auto server = Start("127.0.0.1:0");
  ASSERT_TRUE(server.ok()) << server.status();
  EXPECT_GT((*server)->port(), 0);
  EXPECT_TRUE(CanReach(Connect("127.0.0.1:" + std::to_string((*server)->port()))));
}

TEST_F(RpcServerTest, ServesInProcessWithoutAPort) {
  auto server = Start("");
  ASSERT_TRUE(server.ok()) << server.status();
  EXPECT_EQ((*server)->port(), 0);
  EXPECT_NE((*server)->InProcessChannel(), nullptr);
}

TEST_F(RpcServerTest, SaysWhenItsAddressCannotBeHad) {
  auto first = Start("127.0.0.1:0");
  ASSERT_TRUE(first.ok()) << first.status();
  const std::string address = "127.0.0.1:" + std::to_string((*first)->port());
  const absl::Status taken = Start(address).status();
  EXPECT_EQ(taken.code(), absl::StatusCode::kUnavailable);
  EXPECT_THAT(std::string(taken.message()), HasSubstr(address + ": cannot listen there"));
  EXPECT_EQ(Start("nowhere").status().code(), absl::StatusCode::kInvalidArgument);
}

TEST_F(RpcServerTest, MayBeShutDownTwiceAndGivesItsPortBack) {
  auto server = Start("127.0.0.1:0");
  ASSERT_TRUE(server.ok()) << server.status();
  const std::string address = "127.0.0.1:" + std::to_string((*server)->port());
  (*server)->Shutdown(absl::ZeroDuration());
  (*server)->Shutdown(absl::ZeroDuration());
  server->reset();
  EXPECT_TRUE(Start(address).ok());
}

TEST(PrepareProcessTest, RaisesTheLimitOfOpenFiles) {
  rlimit limit{};
  ASSERT_EQ(getrlimit(RLIMIT_NOFILE, &limit), 0);
  ASSERT_GT(limit.rlim_max, 64u);
  limit.rlim_cur = limit.rlim_max - 1;
  ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &limit), 0);
  PrepareProcess();
  ASSERT_EQ(getrlimit(RLIMIT_NOFILE, &limit), 0);
  EXPECT_EQ(limit.rlim_cur, limit.rlim_max);
}

}  // namespace
}  // namespace tilemend
