// What the threads of a worker share: the one that calls the coordinator, those that run tasks, and those that end it.
#ifndef TILEMEND_WORKER_SERVICE_WORKER_STATE_H_
#define TILEMEND_WORKER_SERVICE_WORKER_STATE_H_

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "tilemend/v1/work.pb.h"
#include "worker/service/folder_looks.h"
#include "worker/service/held_tasks.h"
#include "worker/service/work_link.h"
#include "worker/service/worker_metrics.h"

namespace tilemend {

// Thread-safe.
class WorkerState {
 public:
  enum class Mode { kRunning, kDraining, kStopping, kAbandoned };  // in the order in which they may follow

  // As in WorkerOptions.
  WorkerState(int threads, int prefetch, WorkerMetrics& metrics) : tasks_(threads, prefetch, metrics) {}

  // No effect if it is in a later mode. All tasks are dropped from kStopping on.
  void SetMode(Mode mode);
  bool is_running() const;  // kRunning

  // For the thread that calls the coordinator.

  // Adds to the request what there is to tell, and runs the call; what happens meanwhile interrupts it, unless it
  // reports results: then the answer comes at once. Before that it waits 100 ms at most while the threads are busy: so
  // that one call reports several results, and none is made to be interrupted when a task ends. None once abandoned.
  std::optional<absl::StatusOr<v1::SyncResponse>> Call(SyncCall& call, v1::SyncRequest& request);
  // Does what the answer says. False if the worker is stopping: it begins nothing any more.
  bool Take(const v1::SyncRequest& request, v1::SyncResponse response);
  // Waits before the next call, until the mode changes at most. False if there is no need of one.
  bool Pause(absl::Duration pause);
  // There are no more calls: cancels the tasks, ends the threads.
  void End();

  // For the threads that run tasks.

  struct Work {  // one of both
    std::optional<v1::JobFolders> folders;
    std::shared_ptr<HeldTask> task;
  };
  // Waits for something to do. None after End.
  std::optional<Work> NextWork();
  // `report` is null for a task that was dropped before it was begun. False if it was dropped: nobody wants the report.
  bool Finish(const HeldTask& held, const v1::FinishedTask* report);
  void Add(const std::string& job, v1::FoldersSeen seen);
  // Waits. False, maybe before, once the task's result is of no use.
  bool WaitFor(const HeldTask& held, absl::Duration pause);

 private:
  void CallNow();  // with the lock held: there is something to tell

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::condition_variable news_;  // for the thread that calls
  Mode mode_ = Mode::kRunning;
  bool ended_ = false;
  HeldTasks tasks_;
  FolderLooks looks_;
  SyncCall* waiting_call_ = nullptr;  // that may be interrupted
};

}  // namespace tilemend

#endif  // TILEMEND_WORKER_SERVICE_WORKER_STATE_H_
