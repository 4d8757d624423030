// Who gets in: every RPC that a coordinator answers, with every kind of caller.
#include "coordinator/api/access.h"

#include <gmock/gmock.h>
#include <google/protobuf/descriptor.h>
#include <grpcpp/create_channel.h>
#include <grpcpp/generic/generic_stub.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "common/rpc/grpc_status.h"
#include "common/store/digest.h"
#include "common/util/files.h"
#include "tests/support/certificates.h"
#include "tests/support/list_log.h"
#include "tests/support/test_cluster.h"
#include "tilemend/v1/work.grpc.pb.h"

namespace tilemend {
namespace {

using Code = absl::StatusCode;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using ::testing::UnorderedElementsAreArray;

// Of the protocol, as protoc knows it.
std::vector<std::string> RpcsOfTheProtocol() {
  std::vector<std::string> rpcs;
  for (const char* file : {"tilemend/v1/jobs.proto", "tilemend/v1/work.proto", "externalscaler/externalscaler.proto"}) {
    const auto* descriptor = google::protobuf::DescriptorPool::generated_pool()->FindFileByName(file);
    for (int s = 0; s < descriptor->service_count(); ++s) {
      const auto* service = descriptor->service(s);
      for (int m = 0; m < service->method_count(); ++m) {
        rpcs.push_back(absl::StrCat(service->full_name(), "/", service->method(m)->name()));
      }
    }
  }
  return rpcs;
}

// Calls an RPC with an empty message, whatever it takes.
absl::Status CallBlindly(const std::shared_ptr<grpc::Channel>& channel, const std::string& rpc) {
  grpc::ClientContext context;
  // A stream that is open to the caller does not end by itself.
  const bool is_endless = rpc.ends_with("/StreamIsActive");
  context.set_deadline(std::chrono::system_clock::now() + std::chrono::seconds(is_endless ? 1 : 10));
  grpc::CompletionQueue queue;
  grpc::GenericStub calls(channel);
  const grpc::Slice nothing;
  const grpc::ByteBuffer request(&nothing, 1);
  const auto reader = calls.PrepareUnaryCall(&context, "/" + rpc, request, &queue);
  reader->StartCall();
  grpc::ByteBuffer response;
  grpc::Status status;
  reader->Finish(&response, &status, nullptr);
  void* tag = nullptr;
  bool ok = false;
  queue.Next(&tag, &ok);
  queue.Shutdown();
  return FromGrpcStatus(status);
}

class AccessTest : public ::testing::Test {
 protected:
  // A coordinator that nobody has called.
  void Start(const std::string& tokens, bool wants_certificates) {
    server_.reset();
    cluster_ = std::make_unique<TestCluster>();
    auto access = Access::Closed(tokens, *Log::Null());
    ASSERT_TRUE(access.ok()) << access.status();
    TlsFiles tls = authority_.Issue("coordinator", {"coordinator"});
    if (!wants_certificates) tls.authority.clear();
    const auto gate = std::make_shared<Gate>(*std::move(access), *MetricsRegistry::Null(), audit_);
    auto server = CoordinatorServer::Start("127.0.0.1:0", cluster_->coordinator(), {tls, gate});
    ASSERT_TRUE(server.ok()) << server.status();
    server_ = *std::move(server);
    address_ = absl::StrCat("localhost:", server_->rpc().port());
  }
  absl::Status Call(const std::string& rpc, const Security& security) {
    return CallBlindly(Connect(address_, security), rpc);
  }
  Security With(const std::string& name, const std::vector<std::string>& roles) {
    return {authority_.Issue(name, {name, roles}), "", false};
  }
  Security WithToken(const std::string& token) {
    const std::string path = folder_ / absl::StrCat("token-", token);
    EXPECT_TRUE(WriteFileAtomically(path, token + "\n").ok());
    return {{"", "", authority_.path()}, path, false};
  }
  std::string TokenFile() {
    std::string text = "# people\n";
    for (const char* role : {"scale", "watch", "submit", "admin", "worker"}) {
      absl::StrAppend(&text, role, "-1 ", role, " ", Sha256Hex(absl::StrCat(role, "-secret")), "\n");
    }
    absl::StrAppend(&text, "old admin,worker ", Sha256Hex("old-secret"), " 2020-01-01T00:00:00Z\n");
    EXPECT_TRUE(WriteFileAtomically(folder_ / "tokens", text).ok());
    return folder_ / "tokens";
  }

  TempFolder folder_;
  TestAuthority authority_{folder_.path().string(), "authority"};
  ListLog audit_;
  std::unique_ptr<TestCluster> cluster_;
  std::unique_ptr<CoordinatorServer> server_;
  std::string address_;
};

TEST_F(AccessTest, TheTableHasEveryRpcAndNoOther) {
  std::vector<std::string> listed;
  for (const RpcNeed& need : RpcNeeds()) {
    if (!need.rpc.starts_with("grpc.")) {
      listed.emplace_back(need.rpc);
      EXPECT_NE(need.role, Role::kAnybody) << need.rpc;
    }
  }
  EXPECT_THAT(listed, UnorderedElementsAreArray(RpcsOfTheProtocol()));
}

// What becomes of a call, in a word.
std::string Outcome(const absl::Status& status) {
  switch (status.code()) {
    case Code::kUnavailable:
      return "shut";  // no connection
    case Code::kUnauthenticated:
      return "who?";
    case Code::kPermissionDenied:
      return "no";
    default:
      return "may";  // and is told what is wrong with the empty request
  }
}

// Outcomes of all RPCs of the protocol for one kind of caller.
struct Column {
  std::string caller;
  std::vector<std::string> outcomes;
};

std::string Markdown(const std::vector<std::string>& rpcs, const std::vector<Column>& columns) {
  std::string text = "| call |", rule = "|---|";
  for (const Column& column : columns) {
    absl::StrAppend(&text, " ", column.caller, " |");
    absl::StrAppend(&rule, "---|");
  }
  absl::StrAppend(&text, "\n", rule, "\n");
  for (size_t i = 0; i < rpcs.size(); ++i) {
    absl::StrAppend(&text, "| `", rpcs[i].substr(rpcs[i].rfind('.') + 1), "` |");
    for (const Column& column : columns) absl::StrAppend(&text, " ", column.outcomes[i], " |");
    absl::StrAppend(&text, "\n");
  }
  return text;
}

class AccessTableTest : public AccessTest {
 protected:
  Column Try(const std::string& caller, const Security& security) {
    Column column{caller, {}};
    for (const std::string& rpc : rpcs_) column.outcomes.push_back(Outcome(Call(rpc, security)));
    return column;
  }
  Column All(const std::string& caller, const std::string& outcome) const {
    return {caller, std::vector<std::string>(rpcs_.size(), outcome)};
  }
  // What it is to be for a caller with one role; none for "".
  Column Expected(const std::string& role) const {
    Caller caller;
    for (const Role r : {Role::kScale, Role::kWatch, Role::kSubmit, Role::kAdmin, Role::kWorker}) {
      if (RoleName(r) == role) caller.roles.insert(r);
    }
    Column column{role.empty() ? "no role" : role, {}};
    for (const std::string& rpc : rpcs_) column.outcomes.emplace_back(caller.May(NeedOf(rpc)) ? "may" : "no");
    return column;
  }
  Security Bearer(const std::string& token) { return token.empty() ? Anonymous() : WithToken(token); }
  Security Anonymous() { return {{"", "", authority_.path()}, "", false}; }
  Security Foreign() {
    const TestAuthority foreign(folder_.path().string(), "foreign");
    TlsFiles stranger = foreign.Issue("stranger", {"stranger", {"admin", "worker"}});
    stranger.authority = authority_.path();  // it trusts the coordinator, but not the other way round
    return {stranger, "", false};
  }
  Security Valid(const std::string& name, int from_seconds, int to_seconds) {
    return {authority_.Issue(name, {name, {"admin", "worker"}, from_seconds, to_seconds}), "", false};
  }

  const std::vector<std::string> rpcs_ = RpcsOfTheProtocol();
};

// Every RPC with every kind of caller. access_table.txt has the table.
TEST_F(AccessTableTest, NobodyMayWhatHisIdentityDoesNotSay) {
  std::vector<Column> is, wanted;
  const auto expect = [&](const Column& column, const Column& expected) {
    is.push_back({expected.caller, column.outcomes});
    wanted.push_back(expected);
  };
  const std::vector<std::string> roles = {"", "scale", "watch", "submit", "admin", "worker"};
  Start("", true);
  expect(Try("", {}), All("plain text", "shut"));
  expect(Try("", Anonymous()), All("no certificate", "shut"));
  expect(Try("", Valid("expired", -7200, -3600)), All("expired", "shut"));
  expect(Try("", Valid("early", 3600, 7200)), All("not yet valid", "shut"));
  expect(Try("", Foreign()), All("foreign", "shut"));
  std::vector<Column> certificates;
  for (const std::string& role : roles) certificates.push_back(Try("", With(absl::StrCat("one-", role), {role})));
  Start(TokenFile(), false);
  for (const auto& [caller, token] : std::vector<std::pair<std::string, std::string>>{
           {"no token", ""}, {"unknown token", "guess"}, {"expired token", "old-secret"}}) {
    expect(Try("", Bearer(token)), All(caller, "who?"));
  }
  for (size_t i = 0; i < roles.size(); ++i) {
    expect(certificates[i], Expected(roles[i]));
    if (roles[i].empty()) continue;  // a token without a role is refused when the file is read
    const Column token = Try("", WithToken(absl::StrCat(roles[i], "-secret")));
    EXPECT_EQ(token.outcomes, certificates[i].outcomes) << roles[i];
  }
  const std::string table = Markdown(rpcs_, is);
  std::printf("%s", table.c_str());
  EXPECT_EQ(table, Markdown(rpcs_, wanted));
  EXPECT_EQ(*ReadFile(ACCESS_TABLE), table) << "access_table.txt has another table";
  EXPECT_TRUE(Call("tilemend.v1.Jobs/ListJobs", WithToken("watch-secret")).ok());  // it still serves
}

TEST_F(AccessTest, OnlyItsOwnerAndAdministratorsCancelAJob) {
  Start("", true);
  const auto as = [&](const std::string& name, const std::string& role) {
    return v1::Jobs::NewStub(Connect(address_, With(name, {role})));
  };
  v1::CreateJobRequest create;
  create.mutable_spec()->set_scene("toy://2x1");
  create.mutable_spec()->set_out(folder_ / "out");
  create.mutable_spec()->set_overwrite(true);
  v1::Job job;
  grpc::ClientContext first;
  ASSERT_TRUE(as("ann", "submit")->CreateJob(&first, create, &job).ok());
  EXPECT_EQ(job.owner(), "ann");
  v1::CancelJobRequest cancel;
  cancel.set_name(job.name());
  grpc::ClientContext second, third;
  EXPECT_EQ(as("bob", "submit")->CancelJob(&second, cancel, &job).error_code(), grpc::PERMISSION_DENIED);
  EXPECT_TRUE(as("eve", "admin")->CancelJob(&third, cancel, &job).ok());
  const auto line = [&](const std::string& rpc, const std::string& who, const std::string& end) {
    return AllOf(StartsWith(absl::StrCat("info audit rpc=tilemend.v1.Jobs/", rpc, " who=", who, " address=")),
                 HasSubstr(" what=" + job.name() + " "), EndsWith(end + "\n"));
  };
  EXPECT_THAT(audit_.lines(),
              ElementsAre(line("CreateJob", "ann", absl::StrCat("out=", folder_ / "out", " overwrite=true code=OK")),
                          line("CancelJob", "bob", "code=PERMISSION_DENIED reason=ROLE_NEEDED"),
                          line("CancelJob", "eve", "code=OK")));
}

// New connections get the new certificates; those that are there lose no call.
TEST_F(AccessTest, CertificatesChangeWhileItServes) {
  Start("", true);
  const Security old = With("watch", {"watch"});
  const auto kept = Connect(address_, old);
  const TestAuthority next(folder_.path().string(), "next");
  const TlsFiles watcher = next.Issue("next-watch", {"watch", {"watch"}});
  const auto old_bundle = ReadFile(authority_.path());
  const auto new_bundle = ReadFile(next.path());
  // Both authorities are trusted before the first certificate of the new one comes.
  ASSERT_TRUE(WriteFileAtomically(authority_.path(), *old_bundle + *new_bundle).ok());
  next.Issue("coordinator", {"coordinator"});
  absl::Status changed = absl::UnavailableError("");
  const absl::Time give_up = absl::Now() + absl::Seconds(30);
  while (!changed.ok() && absl::Now() < give_up) {
    EXPECT_TRUE(CallBlindly(kept, "tilemend.v1.Jobs/ListJobs").ok());
    changed = Call("tilemend.v1.Jobs/ListJobs", {watcher, "", false});
  }
  EXPECT_TRUE(changed.ok()) << changed;
  EXPECT_TRUE(CallBlindly(kept, "tilemend.v1.Jobs/ListJobs").ok());
}

}  // namespace
}  // namespace tilemend
