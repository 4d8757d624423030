// A watch went on after its token was taken away, and a DNS name of a certificate that looks like a role was one.
#include <gtest/gtest.h>

#include <chrono>
#include <iostream>
#include <memory>
#include <string>

#include "absl/strings/str_cat.h"
#include "common/rpc/grpc_status.h"
#include "common/store/digest.h"
#include "common/util/files.h"
#include "tests/support/certificates.h"
#include "tests/support/list_log.h"
#include "tests/support/test_cluster.h"

namespace tilemend {
namespace {

class AccessThatLastsTest : public ::testing::Test {
 protected:
  void Start(const std::string& tokens) {
    auto access = Access::Closed(tokens, *Log::Null());
    ASSERT_TRUE(access.ok()) << access.status();
    TlsFiles tls = authority_.Issue("coordinator", {"coordinator"});
    if (!tokens.empty()) tls.authority.clear();
    const auto gate = std::make_shared<Gate>(*std::move(access), *MetricsRegistry::Null(), audit_);
    auto server = CoordinatorServer::Start("127.0.0.1:0", cluster_.coordinator(), {tls, gate});
    ASSERT_TRUE(server.ok()) << server.status();
    server_ = *std::move(server);
  }
  std::unique_ptr<v1::Jobs::Stub> StubWith(const Security& security) {
    return v1::Jobs::NewStub(Connect(absl::StrCat("localhost:", server_->rpc().port()), security));
  }
  std::string Write(const std::string& name, const std::string& text) {
    EXPECT_TRUE(WriteFileAtomically(folder_ / name, text).ok());
    return folder_ / name;
  }

  TempFolder folder_;
  TestAuthority authority_{folder_.path().string(), "authority"};
  ListLog audit_;
  TestCluster cluster_;
  std::unique_ptr<CoordinatorServer> server_;
};

TEST_F(AccessThatLastsTest, AWatchEndsSoonAfterItsTokenIsTakenAway) {
  const std::string tokens = Write("tokens", absl::StrCat("ann watch ", Sha256Hex("secret"), "\n"));
  Start(tokens);
  const auto stub = StubWith({{"", "", authority_.path()}, Write("token", "secret\n"), false});
  v1::WatchJobRequest watch;
  watch.set_name(cluster_.Submit("toy://2x1").name());  // there is no worker
  grpc::ClientContext context;
  context.set_deadline(std::chrono::system_clock::now() + std::chrono::seconds(30));
  const auto reader = stub->WatchJob(&context, watch);
  v1::Job job;
  ASSERT_TRUE(reader->Read(&job));
  Write("tokens", absl::StrCat("bob watch ", Sha256Hex("other"), "\n"));
  const auto start = std::chrono::steady_clock::now();
  while (reader->Read(&job)) {
  }
  const absl::Status status = FromGrpcStatus(reader->Finish());
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  std::cout << status << " after " << took.count() << " s\n";
  EXPECT_TRUE(absl::IsUnauthenticated(status));
}

TEST_F(AccessThatLastsTest, ADnsNameIsNoRole) {
  Start("");
  TestAuthority::Wanted wanted{"eve"};
  wanted.names = {"DNS:tilemend:role:admin"};
  const auto stub = StubWith({authority_.Issue("eve", wanted), "", false});
  grpc::ClientContext context;
  v1::ListJobsResponse listed;
  const grpc::Status status = stub->ListJobs(&context, v1::ListJobsRequest(), &listed);
  std::cout << status.error_message() << '\n';
  EXPECT_EQ(status.error_code(), grpc::PERMISSION_DENIED);
}

}  // namespace
}  // namespace tilemend
