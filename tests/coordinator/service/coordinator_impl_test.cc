// The client's and the worker's calls, without workers and without gRPC.
#include "coordinator/service/coordinator_impl.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "absl/strings/str_cat.h"
#include "common/rpc/limits.h"
#include "common/util/error_info.h"
#include "tests/support/test_cluster.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;

class CoordinatorImplTest : public ::testing::Test {
 protected:
  v1::CreateJobRequest NewRequest(const std::string& out = "o") {
    v1::CreateJobRequest request;
    request.mutable_spec()->set_scene("toy://2x1");
    request.mutable_spec()->set_out(cluster_.folder() / out);
    return request;
  }
  v1::SyncRequest NewSync(const std::string& worker = "w", int threads = 1) {
    v1::SyncRequest request;
    request.set_protocol(kProtocolVersion);
    request.set_worker(worker);
    request.set_threads(threads);
    request.set_sequence(++sequence_);
    request.set_wait_ms(1000);
    return request;
  }
  v1::SyncResponse Sync(const v1::SyncRequest& request) {
    auto response = cluster_.impl().Sync(request, [] { return true; });
    EXPECT_TRUE(response.ok()) << response.status();
    return response.ok() ? *std::move(response) : v1::SyncResponse();
  }
  // Asks until there is a task.
  v1::Task AwaitTask(const std::string& worker = "w") {
    for (int i = 0; i < 20; ++i) {
      const v1::SyncResponse response = Sync(NewSync(worker));
      if (response.start_size() > 0) return response.start(0);
    }
    ADD_FAILURE() << "no task came";
    return {};
  }

  static ClusterOptions Options() {
    ClusterOptions options;
    options.max_running_jobs = 3;
    options.fake_clock = true;
    return options;
  }

  TestCluster cluster_{Options()};
  CoordinatorImpl& impl_ = cluster_.impl();
  uint64_t sequence_ = 0;
};

TEST_F(CoordinatorImplTest, TheSameRequestIdGivesTheSameJob) {
  v1::CreateJobRequest request = NewRequest();
  request.set_request_id("r");
  const auto first = impl_.CreateJob(request);
  ASSERT_TRUE(first.ok()) << first.status();
  EXPECT_EQ(impl_.CreateJob(request)->name(), first->name());
  request.mutable_spec()->set_uniform(true);
  EXPECT_EQ(ErrorReason(impl_.CreateJob(request).status()), "REQUEST_ID_REUSED");
}

TEST_F(CoordinatorImplTest, RefusesSpecsOutOfRange) {
  v1::CreateJobRequest request = NewRequest();
  request.mutable_spec()->set_gradation(0.5);
  const auto status = impl_.CreateJob(request).status();
  EXPECT_TRUE(absl::IsInvalidArgument(status));
  EXPECT_EQ(GetErrorInfo(status)->metadata.at("field"), "gradation");
  request = NewRequest();
  request.mutable_spec()->set_surface("flat");
  EXPECT_EQ(GetErrorInfo(impl_.CreateJob(request).status())->metadata.at("field"), "surface");
}

TEST_F(CoordinatorImplTest, RefusesASecondWriterToAFolder) {
  ASSERT_TRUE(impl_.CreateJob(NewRequest("o")).ok());
  EXPECT_EQ(ErrorReason(impl_.CreateJob(NewRequest("x/../o/")).status()), "OUTPUT_IN_USE");
}

TEST_F(CoordinatorImplTest, RefusesMoreJobsThanItsLimit) {
  for (const char* out : {"1", "2", "3"}) ASSERT_TRUE(impl_.CreateJob(NewRequest(out)).ok());
  EXPECT_EQ(ErrorReason(impl_.CreateJob(NewRequest("4")).status()), "TOO_MANY_JOBS");
}

TEST_F(CoordinatorImplTest, NamesWhatItDoesNotKnow) {
  v1::GetJobRequest get;
  get.set_name("jobs/none");
  EXPECT_EQ(ErrorReason(impl_.GetJob(get).status()), "JOB_NOT_FOUND");
  get.set_name("none");
  EXPECT_EQ(ErrorReason(impl_.GetJob(get).status()), "INVALID_NAME");
}

TEST_F(CoordinatorImplTest, ListsNewestFirstInPages) {
  std::vector<std::string> names;
  for (const char* out : {"1", "2", "3"}) names.push_back(impl_.CreateJob(NewRequest(out))->name());
  v1::ListJobsRequest request;
  request.set_page_size(2);
  const auto first = impl_.ListJobs(request);
  ASSERT_EQ(first->jobs_size(), 2);
  EXPECT_EQ(first->jobs(0).name(), names[2]);
  EXPECT_EQ(first->jobs(1).name(), names[1]);
  request.set_page_token(first->next_page_token());
  const auto second = impl_.ListJobs(request);
  ASSERT_EQ(second->jobs_size(), 1);
  EXPECT_EQ(second->jobs(0).name(), names[0]);
  EXPECT_EQ(second->next_page_token(), "");
  request.set_page_token("nonsense");
  EXPECT_EQ(ErrorReason(impl_.ListJobs(request).status()), "INVALID_PAGE");
}

TEST_F(CoordinatorImplTest, CancelIsIdempotentAndFinal) {
  v1::CancelJobRequest request;
  request.set_name(impl_.CreateJob(NewRequest())->name());
  EXPECT_EQ(impl_.CancelJob(request)->state(), v1::CANCELLED);
  EXPECT_EQ(impl_.CancelJob(request)->state(), v1::CANCELLED);
}

TEST_F(CoordinatorImplTest, RetryStartsAnotherJobWithTheSameSpec) {
  const auto job = impl_.CreateJob(NewRequest());
  v1::RetryJobRequest retry;
  retry.set_name(job->name());
  EXPECT_EQ(ErrorReason(impl_.RetryJob(retry).status()), "JOB_NOT_OVER");
  v1::CancelJobRequest cancel;
  cancel.set_name(job->name());
  ASSERT_TRUE(impl_.CancelJob(cancel).ok());
  absl::StatusOr<v1::Job> again;
  do {
    again = impl_.RetryJob(retry);  // refused until the cancelled pipeline has let go of the folder
  } while (ErrorReason(again.status()) == "OUTPUT_IN_USE");
  ASSERT_TRUE(again.ok()) << again.status();
  EXPECT_NE(again->name(), job->name());
  EXPECT_EQ(again->spec().SerializeAsString(), job->spec().SerializeAsString());
}

TEST_F(CoordinatorImplTest, TellsALostAnswerAgain) {
  ASSERT_TRUE(impl_.CreateJob(NewRequest()).ok());
  const v1::Task task = AwaitTask();
  const v1::SyncResponse again = Sync(NewSync());  // says that it holds nothing
  ASSERT_EQ(again.start_size(), 1);
  EXPECT_EQ(again.start(0).SerializeAsString(), task.SerializeAsString());
}

TEST_F(CoordinatorImplTest, TellsToDropWhatIsNoLongerLeased) {
  const auto job = impl_.CreateJob(NewRequest());
  const v1::Task task = AwaitTask();
  v1::SyncRequest holding = NewSync();
  *holding.add_held() = task.ref();
  holding.set_wait_ms(0);
  EXPECT_EQ(Sync(holding).keep_size(), 1);
  v1::CancelJobRequest cancel;
  cancel.set_name(job->name());
  ASSERT_TRUE(impl_.CancelJob(cancel).ok());
  holding.set_sequence(++sequence_);
  EXPECT_EQ(Sync(holding).keep_size(), 0);
}

TEST_F(CoordinatorImplTest, RefusesLateResultsAndCountsThem) {
  const auto job = impl_.CreateJob(NewRequest());
  const v1::Task late = AwaitTask("slow");
  cluster_.ExpireLeases();
  const v1::Task task = AwaitTask("fast");
  EXPECT_EQ(task.ref().task(), late.ref().task());
  EXPECT_EQ(task.attempt(), 2);
  for (const v1::Task* reported : {&late, &task, &task}) {
    v1::SyncRequest report = NewSync(reported == &late ? "slow" : "fast", 0);
    auto* finished = report.add_finished();
    *finished->mutable_ref() = reported->ref();
    finished->set_stage(reported->stage());
    finished->mutable_output()->set_content("5 ");
    finished->mutable_output()->set_size(2);
    EXPECT_EQ(Sync(report).acknowledged_size(), 1);
  }
  EXPECT_EQ(cluster_.Metric("tilemend_coordinator_tasks_refused_late_total{stage=\"survey\"}"), 1);
  EXPECT_EQ(cluster_.Metric("tilemend_coordinator_tasks_finished_total{stage=\"survey\"}"), 1);
  EXPECT_EQ(cluster_.Metric("tilemend_coordinator_tasks_retried_total{stage=\"survey\"}"), 1);
  EXPECT_EQ(cluster_.Get(job->name()).progress().tasks_done(), 1);
}

TEST_F(CoordinatorImplTest, RetriesAResultWhoseBlobNeverCame) {
  const auto job = impl_.CreateJob(NewRequest());
  const v1::Task task = AwaitTask();
  v1::SyncRequest report = NewSync("w", 0);
  auto* finished = report.add_finished();
  *finished->mutable_ref() = task.ref();
  finished->set_stage(task.stage());
  finished->mutable_output()->set_digest(std::string(64, 'a'));
  finished->mutable_output()->set_size(1'000'000);
  EXPECT_EQ(Sync(report).acknowledged_size(), 1);
  EXPECT_EQ(cluster_.Get(job->name()).progress().tasks_done(), 0);
  EXPECT_EQ(AwaitTask().attempt(), 2);
}

TEST_F(CoordinatorImplTest, LeasesNothingToAWorkerThatIsGone) {
  ASSERT_TRUE(impl_.CreateJob(NewRequest()).ok());
  AwaitTask("first");
  EXPECT_TRUE(absl::IsCancelled(impl_.Sync(NewSync("gone"), [] { return false; }).status()));
  EXPECT_EQ(AwaitTask("second").ref().task(), 2);
}

TEST_F(CoordinatorImplTest, RefusesAnotherProtocol) {
  v1::SyncRequest request = NewSync();
  request.set_protocol(2);
  EXPECT_EQ(ErrorReason(impl_.Sync(request, [] { return true; }).status()), "PROTOCOL_VERSION");
}

TEST_F(CoordinatorImplTest, ReleasesADrainingWorker) {
  ASSERT_TRUE(impl_.CreateJob(NewRequest()).ok());
  AwaitTask();
  v1::SyncRequest request = NewSync();
  request.set_draining(true);
  EXPECT_TRUE(Sync(request).leave());
  EXPECT_EQ(AwaitTask("other").attempt(), 2);
}

TEST_F(CoordinatorImplTest, RefusesBadBlobs) {
  const auto job = impl_.CreateJob(NewRequest());
  const auto write = [&](const std::string& name, const std::string& digest, std::vector<std::string> chunks) {
    size_t next = 0;
    return impl_.WriteBlob([&](v1::WriteBlobRequest& message) {
      if (next >= chunks.size()) return false;
      message.set_job(name);
      message.set_digest(digest);
      message.set_data(chunks[next++]);
      return true;
    });
  };
  const std::string id = job->name().substr(5);
  EXPECT_EQ(write(id, Sha256Hex("ab"), {"a", "b"})->size(), 2);
  EXPECT_EQ(ErrorReason(write(id, Sha256Hex("ab"), {"a"}).status()), "BLOB_CORRUPT");
  EXPECT_TRUE(absl::IsInvalidArgument(write(id, "../x", {"a"}).status()));
  EXPECT_EQ(ErrorReason(write("none", Sha256Hex("a"), {"a"}).status()), "JOB_NOT_FOUND");
  const std::string big(kMaxChunkBytes + 1, 'x');
  EXPECT_TRUE(absl::IsInvalidArgument(write(id, Sha256Hex(big), {big}).status()));
  EXPECT_FALSE(write(id, Sha256Hex("a"), {}).ok());
}

TEST(CoordinatorOptionsTest, RefusesALeaseShorterThanTwoCalls) {
  TempFolder folder;
  CoordinatorOptions options;
  options.work_folder = folder / "work";
  options.lease = absl::Seconds(2);
  EXPECT_TRUE(absl::IsInvalidArgument(
      CoordinatorImpl::Create(options, ToyPipelineFactory(), *MetricsRegistry::Null()).status()));
}

}  // namespace
}  // namespace tilemend
