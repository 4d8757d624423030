#include "client/job_client.h"

#include <gmock/gmock.h>
#include <grpcpp/create_channel.h>
#include <grpcpp/security/credentials.h>
#include <grpcpp/security/server_credentials.h>
#include <grpcpp/server_builder.h>
#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <memory>
#include <string>

#include "absl/strings/str_cat.h"
#include "absl/time/clock.h"
#include "tests/support/test_cluster.h"
#include "tilemend/v1/jobs.grpc.pb.h"

namespace tilemend {
namespace {

// Takes every job and says of each that it is done.
class Jobs : public v1::Jobs::Service {
 public:
  // Calls that are answered as while a server ends.
  std::atomic<int> cancels{0};

 private:
  grpc::Status GetJob(grpc::ServerContext*, const v1::GetJobRequest* request, v1::Job* job) override {
    if (cancels-- > 0) return grpc::Status::CANCELLED;
    job->set_name(request->name());
    return grpc::Status::OK;
  }
  grpc::Status CreateJob(grpc::ServerContext*, const v1::CreateJobRequest*, v1::Job* job) override {
    job->set_name("jobs/1");
    return grpc::Status::OK;
  }
  grpc::Status WatchJob(grpc::ServerContext*, const v1::WatchJobRequest*,
                        grpc::ServerWriter<v1::Job>* writer) override {
    if (cancels-- > 0) return grpc::Status::CANCELLED;
    v1::Job job;
    job.set_name("jobs/1");
    job.set_state(v1::DONE);
    writer->Write(job);
    return grpc::Status::OK;
  }
};

std::unique_ptr<grpc::Server> Serve(Jobs& jobs, int& port) {
  grpc::ServerBuilder builder;
  builder.AddListeningPort(absl::StrCat("127.0.0.1:", port), grpc::InsecureServerCredentials(), &port);
  builder.RegisterService(&jobs);
  return builder.BuildAndStart();
}

class JobClientTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!kHasGrpc) GTEST_SKIP() << "needs gRPC";
    server_ = Serve(jobs_, port_);
  }
  JobClient Client(absl::Duration patience = absl::Milliseconds(200)) const {
    return {grpc::CreateChannel(absl::StrCat("127.0.0.1:", port_), grpc::InsecureChannelCredentials()), patience};
  }

  Jobs jobs_;
  int port_ = 0;
  std::unique_ptr<grpc::Server> server_;
};

TEST_F(JobClientTest, WatchesAJobItHasStartedThoughTheCoordinatorEndsAtOnce) {
  JobClient client = Client();
  ASSERT_TRUE(client.Create({}).ok());
  server_->Shutdown();
  auto watched = std::async(std::launch::async, [&] { return client.Watch("jobs/1", [](const v1::Job&) {}); });
  absl::SleepFor(absl::Seconds(1));  // longer than its patience
  server_ = Serve(jobs_, port_);
  ASSERT_NE(server_, nullptr);
  const absl::StatusOr<v1::Job> job = watched.get();
  ASSERT_TRUE(job.ok()) << job.status();
  EXPECT_EQ(job->state(), v1::DONE);
}

TEST_F(JobClientTest, ACallThatTheCoordinatorCancelsAsItEndsIsMadeAgain) {
  JobClient client = Client(absl::Seconds(20));
  jobs_.cancels = 1;
  const absl::StatusOr<v1::Job> got = client.Get("jobs/1");
  EXPECT_TRUE(got.ok()) << got.status();
  jobs_.cancels = 2;
  const absl::StatusOr<v1::Job> watched = client.Watch("jobs/1", [](const v1::Job&) {});
  ASSERT_TRUE(watched.ok()) << watched.status();
  EXPECT_EQ(watched->state(), v1::DONE);
}

TEST_F(JobClientTest, AWatchThatItsUserStopsIsCancelled) {
  JobClient client = Client();
  client.StopWatch();
  EXPECT_TRUE(absl::IsCancelled(client.Watch("jobs/1", [](const v1::Job&) {}).status()));
}

TEST_F(JobClientTest, AWatchBegunWhileTheCoordinatorIsDownWaitsAndSaysSoOnce) {
  server_->Shutdown();
  std::promise<void> waits;
  int told = 0;
  JobClient::Patience patience{absl::Minutes(1)};
  patience.on_wait = [&](const absl::Status& why) {
    EXPECT_TRUE(absl::IsUnavailable(why)) << why;
    if (++told == 1) waits.set_value();
  };
  JobClient client(grpc::CreateChannel(absl::StrCat("127.0.0.1:", port_), grpc::InsecureChannelCredentials()),
                   std::move(patience));
  auto watched = std::async(std::launch::async, [&] { return client.Watch("jobs/1", [](const v1::Job&) {}); });
  waits.get_future().get();
  server_ = Serve(jobs_, port_);
  ASSERT_NE(server_, nullptr);
  const absl::StatusOr<v1::Job> job = watched.get();
  ASSERT_TRUE(job.ok()) << job.status();
  EXPECT_EQ(job->state(), v1::DONE);
  EXPECT_EQ(told, 1);
}

TEST_F(JobClientTest, AUserMayStopACallThatWaits) {
  server_->Shutdown();
  JobClient::Patience patience{absl::Minutes(10)};
  std::promise<void> waits;
  patience.on_wait = [&](const absl::Status&) { waits.set_value(); };
  JobClient client(grpc::CreateChannel(absl::StrCat("127.0.0.1:", port_), grpc::InsecureChannelCredentials()),
                   std::move(patience));
  auto asked = std::async(std::launch::async, [&] { return client.List({}); });
  waits.get_future().get();
  client.StopWatch();
  EXPECT_TRUE(absl::IsCancelled(asked.get().status()));
}

TEST_F(JobClientTest, SaysWhatMayBeMissing) {
  server_->Shutdown();
  JobClient::Patience patience{absl::ZeroDuration()};
  patience.hint = "--token-file is given without --tls-ca.";
  JobClient client(grpc::CreateChannel(absl::StrCat("127.0.0.1:", port_), grpc::InsecureChannelCredentials()),
                   std::move(patience));
  const absl::Status status = client.Get("jobs/1").status();
  EXPECT_THAT(std::string(status.message()), testing::HasSubstr("right? --token-file is given without --tls-ca. ("));
}

TEST_F(JobClientTest, GivesUpSoonOnACoordinatorThatItNeverReached) {
  server_->Shutdown();
  JobClient client = Client();
  const absl::Time begin = absl::Now();
  const absl::Status status = client.Watch("jobs/1", [](const v1::Job&) {}).status();
  EXPECT_TRUE(absl::IsUnavailable(status)) << status;
  EXPECT_LT(absl::Now() - begin, absl::Minutes(1));
}

}  // namespace
}  // namespace tilemend
