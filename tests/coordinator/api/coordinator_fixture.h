// A coordinator that tests call as a client or as a worker, without gRPC.
#ifndef TILEMEND_TESTS_COORDINATOR_API_COORDINATOR_FIXTURE_H_
#define TILEMEND_TESTS_COORDINATOR_API_COORDINATOR_FIXTURE_H_

#include <gtest/gtest.h>

#include <memory>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "common/rpc/limits.h"
#include "tests/support/test_cluster.h"
#include "tests/support/waiting_sync.h"

namespace tilemend {

// The pipeline of toys, whose workers must see folders.
class FolderedPipeline : public JobPipeline {
 public:
  FolderedPipeline(std::unique_ptr<JobPipeline> toy, JobFolders folders)
      : toy_(std::move(toy)), folders_(std::move(folders)) {}

  absl::StatusOr<JobFolders> Folders() const override { return folders_; }
  absl::StatusOr<std::vector<NewTask>> Start() override { return toy_->Start(); }
  absl::StatusOr<std::vector<NewTask>> OnTaskDone(TaskResult result) override {
    return toy_->OnTaskDone(std::move(result));
  }
  bool Done() const override { return toy_->Done(); }
  Progress GetProgress() const override { return toy_->GetProgress(); }
  absl::StatusOr<JobOutcome> Finish() override { return toy_->Finish(); }

 private:
  const std::unique_ptr<JobPipeline> toy_;
  const JobFolders folders_;
};

inline PipelineFactory ToysWithFolders(const JobFolders& folders) {
  return [=](const JobSpec& spec, const std::stop_token& stop) -> absl::StatusOr<std::unique_ptr<JobPipeline>> {
    auto toy = ToyPipelineFactory()(spec, stop);
    if (!toy.ok()) return toy.status();
    return std::make_unique<FolderedPipeline>(*std::move(toy), folders);
  };
}

class CoordinatorTest : public ::testing::Test {
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
    auto response = SyncAndWait(cluster_.coordinator().calls().work, request);
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

  // Adds to `request` that the worker has done `task`.
  static void Finish(const v1::Task& task, v1::SyncRequest& request) {
    auto* finished = request.add_finished();
    *finished->mutable_ref() = task.ref();
    finished->set_stage(task.stage());
    finished->mutable_output()->set_content("5 ");
    finished->mutable_output()->set_size(2);
  }

  // The output of an attempt, or what the worker says it is, in chunks.
  absl::StatusOr<v1::WriteBlobResponse> Write(const v1::TaskRef& attempt, const std::string& worker,
                                              const std::string& digest, const std::vector<std::string>& chunks) {
    size_t next = 0;
    return calls_.blobs.WriteBlob([&](v1::WriteBlobRequest& message) {
      if (next >= chunks.size()) return false;
      message.Clear();
      if (next == 0) {
        *message.mutable_attempt() = attempt;
        message.set_worker(worker);
        message.set_digest(digest);
      }
      message.set_data(chunks[next++]);
      return true;
    });
  }

  explicit CoordinatorTest(const ClusterOptions& options = Options()) : cluster_(options) {}

  static ClusterOptions Options() {
    ClusterOptions options;
    options.max_running_jobs = 3;
    options.most_sent = 4 << 20;
    options.fake_clock = true;
    return options;
  }

  TestCluster cluster_;
  Coordinator& coordinator_ = cluster_.coordinator();
  CallHandlers& calls_ = coordinator_.calls();
  uint64_t sequence_ = 0;
};

}  // namespace tilemend

#endif  // TILEMEND_TESTS_COORDINATOR_API_COORDINATOR_FIXTURE_H_
