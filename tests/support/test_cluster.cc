#include "tests/support/test_cluster.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <array>
#include <atomic>
#include <system_error>
#include <utility>

#include "absl/strings/numbers.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_split.h"
#include "absl/strings/strip.h"
#include "coordinator/journal/postgres_journal.h"
#include "coordinator/journal/sqlite_journal.h"
#include "tests/support/direct_link.h"
#include "tests/support/waiting_watch.h"

namespace tilemend {
namespace {

constexpr absl::Duration kLease = absl::Seconds(10);

using IsDead = std::shared_ptr<std::atomic<bool>>;

// The call under way of a worker that dies is answered, to nobody: cut off, it could reach the coordinator later than
// what the test does next, and the dead would get a task.
class MortalLink : public WorkLink {
 public:
  MortalLink(std::unique_ptr<WorkLink> link, IsDead is_dead) : link_(std::move(link)), is_dead_(std::move(is_dead)) {}
  std::unique_ptr<SyncCall> NewSync() override { return std::make_unique<Call>(link_->NewSync(), is_dead_); }
  absl::StatusOr<std::string> ReadBlob(const std::string& job, const std::string& digest) override {
    return link_->ReadBlob(job, digest);
  }
  absl::Status WriteBlob(const v1::TaskRef& attempt, const std::string& worker, const std::string& digest,
                         const std::string& bytes) override {
    return link_->WriteBlob(attempt, worker, digest, bytes);
  }

 private:
  class Call : public SyncCall {
   public:
    Call(std::unique_ptr<SyncCall> call, IsDead is_dead) : call_(std::move(call)), is_dead_(std::move(is_dead)) {}
    absl::StatusOr<v1::SyncResponse> Run(const v1::SyncRequest& request) override { return call_->Run(request); }
    void Interrupt() override {
      if (!*is_dead_) call_->Interrupt();
    }

   private:
    const std::unique_ptr<SyncCall> call_;
    const IsDead is_dead_;
  };

  const std::unique_ptr<WorkLink> link_;
  const IsDead is_dead_;
};

}  // namespace

TempFolder::TempFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "tilemend-test-XXXXXX").string();
  EXPECT_NE(mkdtemp(name.data()), nullptr);
  path_ = name;
}

TempFolder::~TempFolder() {
  std::error_code error;
  std::filesystem::remove_all(path_, error);
}

TestCluster::TestCluster(ClusterOptions options) : options_(std::move(options)) { StartCoordinator(); }

void TestCluster::StartCoordinator() {
  CoordinatorOptions options;
  options.work_folder = folder_ / "work";
  options.lease = kLease;
  options.state = options_.state;
  options.check_result = options_.check_result;
  options.attempts_of = options_.attempts_of;
  options.max_running_jobs = options_.max_running_jobs;
  options.most_sent = options_.most_sent;
  options.log = options_.log;
  options.build = options_.build;
  if (options_.durable) {
    auto journal = options_.postgres.empty() ? OpenSqliteJournal(folder_ / "journal.sqlite")
                                             : OpenPostgresJournal(options_.postgres);
    EXPECT_TRUE(journal.ok()) << journal.status();
    options.journal = *std::move(journal);
  }
  if (options_.fake_clock) {
    options.clock = [this] { return clock_.Now(); };
    options.background_ticks = false;
  }
  auto started = Coordinator::Create(std::move(options), options_.factory, metrics_);
  EXPECT_TRUE(started.ok()) << started.status();
  coordinator_ = *std::move(started);
  if (!kHasGrpc) return;
  auto server = CoordinatorServer::Start(options_.listen, *coordinator_);
  EXPECT_TRUE(server.ok()) << server.status();
  server_ = *std::move(server);
}

TestCluster::~TestCluster() {
  workers_.clear();
  server_.reset();
}

std::unique_ptr<WorkLink> TestCluster::NewLink() {
  return kHasGrpc ? NewGrpcWorkLink(rpc().InProcessChannel()) : NewDirectLink(*coordinator_);
}

Worker& TestCluster::AddWorker(const std::string& name, int threads, StageRunner runner) {
  WorkerOptions options;
  options.id = name;
  options.threads = threads;
  options.build = options_.build;
  return AddWorker(options, std::move(runner));
}

Worker& TestCluster::AddWorker(const WorkerOptions& options, StageRunner runner) {
  auto& worker = workers_[options.id];
  worker.is_dead = std::make_shared<std::atomic<bool>>(false);
  worker.worker = std::make_unique<Worker>(options, std::make_unique<MortalLink>(NewLink(), worker.is_dead),
                                           std::move(runner), *MetricsRegistry::Null());
  return *worker.worker;
}

void TestCluster::KillWorker(const std::string& name) {
  *workers_.at(name).is_dead = true;
  workers_.at(name).worker->Abandon();
  workers_.erase(name);
}

void TestCluster::Restart(const std::function<void(const std::string&)>& meanwhile) {
  while (!workers_.empty()) KillWorker(workers_.begin()->first);
  server_.reset();
  coordinator_.reset();
  meanwhile(folder_ / "journal.sqlite");
  StartCoordinator();
}

void TestCluster::ExpireLeases() {
  clock_.AdvanceWhenSeen(2 * kLease);  // by the tick, with the lock held: a call in between would renew its lease
  coordinator_->Tick();
}

std::unique_ptr<v1::Jobs::Stub> TestCluster::NewJobsStub() { return v1::Jobs::NewStub(rpc().InProcessChannel()); }

double TestCluster::Metric(const std::string& name_and_labels) const {
  const std::string text = MetricsText();
  for (absl::string_view line : absl::StrSplit(text, '\n')) {
    double value = 0;
    if (absl::ConsumePrefix(&line, absl::StrCat(name_and_labels, " ")) && absl::SimpleAtod(line, &value)) return value;
  }
  return 0;
}

v1::Job TestCluster::Submit(const std::string& scene) {
  v1::CreateJobRequest request;
  request.mutable_spec()->set_scene(scene);
  request.mutable_spec()->set_out(folder_ / absl::StrCat("out-", ++submitted_));
  auto job = coordinator_->calls().jobs.CreateJob(request);
  EXPECT_TRUE(job.ok()) << job.status();
  return job.ok() ? *std::move(job) : v1::Job();
}

v1::Job TestCluster::Get(const std::string& name) {
  v1::GetJobRequest request;
  request.set_name(name);
  auto job = coordinator_->calls().jobs.GetJob(request);
  EXPECT_TRUE(job.ok()) << job.status();
  return job.ok() ? *std::move(job) : v1::Job();
}

v1::Job TestCluster::WaitFor(const std::string& name) {
  v1::WatchJobRequest request;
  request.set_name(name);
  v1::Job last;
  const absl::Status status = WatchAndWait(coordinator_->calls().watch, request, [&last](const v1::Job& job) {
    last = job;
    return true;
  });
  EXPECT_TRUE(status.ok()) << status;
  return last;
}

}  // namespace tilemend
