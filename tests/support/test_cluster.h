// A real coordinator and any number of real workers inside one test, over in-process channels (under ThreadSanitizer
// without gRPC, see direct_link.h).
#ifndef TILEMEND_TESTS_SUPPORT_TEST_CLUSTER_H_
#define TILEMEND_TESTS_SUPPORT_TEST_CLUSTER_H_

#include <atomic>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "absl/time/time.h"
#include "common/metrics/prometheus_registry.h"
#include "coordinator/api/coordinator.h"
#include "coordinator/api/grpc_services.h"
#include "tests/support/toy_engine.h"
#include "tilemend/v1/jobs.grpc.pb.h"
#include "worker/service/worker.h"

namespace tilemend {

// A clock that moves only when it is told to.
class FakeClock {
 public:
  absl::Time Now() {
    std::lock_guard<std::mutex> lock(mutex_);
    if (std::this_thread::get_id() == jumper_) {
      now_ += jump_;
      jumper_ = {};
    }
    return now_;
  }
  void Advance(absl::Duration by) {
    std::lock_guard<std::mutex> lock(mutex_);
    now_ += by;
  }
  // As the calling thread looks at it the next time: nobody sees the later time before it does.
  void AdvanceWhenSeen(absl::Duration by) {
    std::lock_guard<std::mutex> lock(mutex_);
    jumper_ = std::this_thread::get_id();
    jump_ = by;
  }

 private:
  std::mutex mutex_;
  absl::Time now_ = absl::FromUnixSeconds(1'000'000'000);
  std::thread::id jumper_;  // none: the time stands still
  absl::Duration jump_;
};

// A folder that is gone with the test.
class TempFolder {
 public:
  TempFolder();
  ~TempFolder();
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

#ifdef __SANITIZE_THREAD__
inline constexpr bool kHasGrpc = false;
#else
inline constexpr bool kHasGrpc = true;
#endif

struct ClusterOptions {
  std::string listen;  // "": in process only
  PipelineFactory factory = ToyPipelineFactory();
  StateOptions state;
  size_t max_running_jobs = 64;
  ResultCheck check_result;
  AttemptsOf attempts_of;
  int64_t most_sent = CoordinatorOptions().most_sent;
  Log* log = Log::Null();   // of the coordinator; outlives the cluster
  bool fake_clock = false;  // leases then run out only through clock() and Tick()
  bool durable = false;     // for Restart
  std::string postgres;     // where the journal is, if it is durable and not a file (OpenPostgresJournal)
  std::string build = {};   // of the coordinator, until it is another's
};

class TestCluster {
 public:
  explicit TestCluster(ClusterOptions options = {});
  ~TestCluster();

  // Starts a worker; the name is its id.
  Worker& AddWorker(const std::string& name, int threads = 1, StageRunner runner = ToyStageRunner());
  Worker& AddWorker(const WorkerOptions& options, StageRunner runner);
  // As if its machine had lost power.
  void KillWorker(const std::string& name);
  // The coordinator ends without a word and another one starts in its place; workers go with it. Only if durable.
  // In between comes `meanwhile`, with the path of the journal.
  void Restart(const std::function<void(const std::string&)>& meanwhile = [](const std::string&) {});
  // Of the next coordinator.
  void UseBuild(const std::string& build) { options_.build = build; }
  // Time passes until every lease has run out. A worker that is alive is known again with its next call.
  void ExpireLeases();

  Coordinator& coordinator() { return *coordinator_; }
  RpcServer& rpc() { return server_->rpc(); }  // only if kHasGrpc
  std::unique_ptr<WorkLink> NewLink();
  FakeClock& clock() { return clock_; }
  TempFolder& folder() { return folder_; }
  std::unique_ptr<v1::Jobs::Stub> NewJobsStub();
  std::string MetricsText() const { return metrics_.Text(); }
  // The value of a metric by its full text up to the value, 0 if there is none.
  double Metric(const std::string& name_and_labels) const;

  // A job on `scene`, writing to folder()/out-N.
  v1::Job Submit(const std::string& scene);
  v1::Job Get(const std::string& name);
  // Waits until the job is over.
  v1::Job WaitFor(const std::string& name);

 private:
  struct OneWorker {
    std::unique_ptr<Worker> worker;
    std::shared_ptr<std::atomic<bool>> is_dead;
  };
  void StartCoordinator();

  ClusterOptions options_;
  TempFolder folder_;
  FakeClock clock_;
  PrometheusRegistry metrics_;
  std::unique_ptr<Coordinator> coordinator_;
  std::unique_ptr<CoordinatorServer> server_;
  std::map<std::string, OneWorker> workers_;
  int submitted_ = 0;
};

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_TEST_CLUSTER_H_
