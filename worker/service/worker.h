// A worker: asks the coordinator for tasks, runs them on its threads and reports what came out.
//
// One thread makes Sync calls; of others at most `threads` compute at a time, beside those that read and write
// (common/util/cores.h). A call waits in the coordinator while there is room for tasks here. When a task ends it is
// interrupted and a new one reports at once. While more tasks wait than half of `prefetch`, no call is made for up to
// 100 ms. Results are kept and reported again until the coordinator acknowledges them, through any loss of connection.
#ifndef TILEMEND_WORKER_SERVICE_WORKER_H_
#define TILEMEND_WORKER_SERVICE_WORKER_H_

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "common/metrics/metrics.h"
#include "common/util/cancel_token.h"
#include "common/util/cores.h"
#include "common/util/log.h"
#include "common/util/recently_used.h"
#include "tilemend/v1/work.pb.h"
#include "worker/service/attempt_files.h"
#include "worker/service/look_at_folders.h"
#include "worker/service/stage_runner.h"
#include "worker/service/work_link.h"
#include "worker/service/worker_metrics.h"

namespace tilemend {

struct WorkerOptions {
  std::string id;          // new for each process; NewWorkerId()
  int threads = 1;         // 1 to 1024
  std::string build = {};  // BuildId(); a coordinator of another refuses this worker
  // Tasks to hold beyond one for each thread, where there are enough for all workers: so that no thread waits for the
  // next, and that one is computed while another reads or writes.
  int prefetch = 0;
  absl::Duration first_backoff = absl::Milliseconds(50);
  absl::Duration max_backoff = absl::Seconds(1);
  // How long it calls its coordinator in vain, in pauses between calls, before it ends with the error.
  absl::Duration patience = absl::InfiniteDuration();
  std::function<void()> on_end;  // on a thread of its own, once it will take no more tasks; none: nobody is told
  OutputDiscarder discard = RemoveKept;  // for outputs of tasks that were given to others meanwhile
  std::function<v1::FoldersSeen(const v1::JobFolders&)> look = LookAtFolders;  // on a thread of tasks
  Log* log = Log::Null();                                                      // outlives the worker
};

// Thread-safe.
class Worker {
 public:
  // Starts at once.
  Worker(const WorkerOptions& options, std::unique_ptr<WorkLink> link, StageRunner runner, MetricsRegistry& metrics);
  // Stops and waits.
  ~Worker();

  // Takes no more tasks, finishes and reports those it has, then ends.
  void Drain();
  // Drops what runs, tells the coordinator (once) so that it gives the tasks to others without delay, then ends.
  void Stop();
  // Drops what runs and tells nobody, as if the machine had died.
  void Abandon();

  // Why it cannot get tasks now, for people; "" if it can.
  std::string WhyNotReady();

  // Waits for the end. An error if the coordinator refuses to work with this worker, or was out of reach for too long.
  absl::Status Join();

 private:
  enum class Mode { kRunning, kDraining, kStopping, kAbandoned };  // in the order in which they may follow

  struct Held {
    v1::Task task;
    CancelToken cancel;
    bool dropped = false;  // runs on, but is no longer the coordinator's
    std::atomic<bool> begun = false;
  };

  void SyncLoop();
  bool SyncOnce(absl::Duration& backoff);  // false: the end
  // Waits 100 ms at most while there are tasks for all threads and half of those that are to wait for one: so that one
  // call reports several results, and none is made to be interrupted when a task ends.
  void RestWhileBusy(std::unique_lock<std::mutex>& lock);
  void CallNow();  // with the lock held: there is something to tell
  bool AfterFailure(const absl::Status& status, absl::Duration& backoff);
  v1::SyncRequest NextRequest();  // with the lock held
  void Take(const v1::SyncRequest& request, v1::SyncResponse response);
  void TakeLooks(const v1::SyncRequest& request, const v1::SyncResponse& response);  // with the lock held
  void DropHeld(uint64_t token);                                                     // with the lock held
  void SetConnected(const absl::Status& status);
  bool Pause(absl::Duration backoff);  // false: the end
  void SetMode(Mode mode);

  void RunTasks();
  // Waits until there is something to do, or the worker has ended.
  void AwaitTask(std::unique_lock<std::mutex>& lock);
  void RunTask(Held& held);
  // To be told to the coordinator. False if it was dropped: nobody wants it.
  bool TakeReport(const Held& held, const v1::FinishedTask& report);
  void Look(const v1::JobFolders& folders);
  // With its parts.
  absl::StatusOr<std::string> InputOf(const Held& held);
  absl::StatusOr<std::shared_ptr<const std::string>> Part(const Held& held, const std::string& digest);
  absl::StatusOr<std::string> Fetch(const Held& held, const std::string& digest);
  // Whether a call for the task that failed so is worth another try; waits before that.
  bool MayTryAgain(const Held& held, const absl::Status& status, int tried);
  std::optional<absl::StatusOr<std::string>> Compute(Held& held, const std::string& input);
  absl::StatusOr<std::string> RunStage(Stage stage, const std::string& input, const CancelToken& cancel);
  void LogFailure(const v1::Task& task, const v1::Status& error) const;
  v1::FinishedTask Report(const Held& held, absl::StatusOr<std::string> output);

  const WorkerOptions options_;
  const std::string secret_;
  const std::unique_ptr<WorkLink> link_;
  const StageRunner runner_;
  RecentlyUsed<std::string, std::string> parts_;  // of inputs, by digest
  WorkerMetrics metrics_;
  Cores cores_;

  std::mutex mutex_;
  std::condition_variable changed_;
  std::condition_variable news_;  // for the thread that calls
  Mode mode_ = Mode::kRunning;
  bool ended_ = false;
  absl::Status end_status_;
  absl::Duration in_vain_;  // since the last call that was answered
  uint64_t sequence_ = 0;
  std::map<uint64_t, std::shared_ptr<Held>> held_;  // by attempt token, dropped ones too
  std::deque<std::shared_ptr<Held>> ready_;
  std::deque<v1::JobFolders> to_look_;
  std::map<std::string, v1::FoldersSeen> seen_;    // by job, until the coordinator has it
  std::string set_aside_;                          // as it was told last
  std::string unconnected_;                        // why it is not; "" while it is
  std::map<uint64_t, v1::FinishedTask> finished_;  // by attempt token, until acknowledged
  SyncCall* waiting_call_ = nullptr;               // that may be interrupted
  std::vector<std::thread> threads_;
  std::mutex join_mutex_;
};

}  // namespace tilemend

#endif  // TILEMEND_WORKER_SERVICE_WORKER_H_
