// The coordinator: the state machine, its lock, its clock, its journal, its blobs and the pipelines of its jobs. Every
// RPC is one call here; nothing here knows gRPC.
//
// What it told anybody is durable: events take effect in memory and are put into the journal under one lock, and every
// answer, every worker's task and every call of a pipeline waits until the journal has what was put before.
#ifndef TILEMEND_COORDINATOR_API_COORDINATOR_IMPL_H_
#define TILEMEND_COORDINATOR_API_COORDINATOR_IMPL_H_

#include <atomic>
#include <chrono>
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
#include "common/rpc/limits.h"
#include "common/util/log.h"
#include "common/util/roots.h"
#include "coordinator/api/long_calls.h"
#include "coordinator/jobs/cluster_events.h"
#include "coordinator/jobs/coordinator_metrics.h"
#include "coordinator/jobs/job_pipeline.h"
#include "coordinator/jobs/job_runner.h"
#include "coordinator/jobs/result_checks.h"
#include "coordinator/jobs/worker_trust.h"
#include "coordinator/journal/journal.h"
#include "coordinator/state/coordinator_state.h"
#include "coordinator/state/demand.h"
#include "coordinator/state/patience.h"
#include "coordinator/state/task_choice.h"
#include "coordinator/store/blob_folder.h"
#include "tilemend/v1/jobs.pb.h"
#include "tilemend/v1/work.pb.h"

namespace tilemend {

struct CoordinatorOptions {
  std::string work_folder;  // of this process alone; blobs go to work_folder/jobs/{id}; made if missing
  // Its jobs go on. Null: a journal that forgets, for a coordinator whose jobs end with it.
  std::shared_ptr<Journal> journal;
  absl::Duration lease = absl::Seconds(30);  // > 2 s: a worker calls at least once a second
  StateOptions state;                        // its epoch is that of the journal
  size_t max_running_jobs = 64;
  absl::Duration keep_jobs = absl::Hours(30 * 24);  // then a job that is over is forgotten; beyond 10,000 earlier
  // Never goes back. Default: the wall clock at construction plus a steady clock since.
  std::function<absl::Time()> clock;
  // Looks at every result before it is taken; none: all are.
  ResultCheck check_result = {};
  // BuildId(), or whatever else tells results that fit together from others: workers of another build are refused, and
  // what the journal knows of another build is not used.
  std::string build = {};
  int64_t most_sent = kMaxBlobBytes;  // bytes of blobs by one attempt
  // Looks for overdue leases in the background; without it only Tick does (tests).
  bool background_ticks = true;
  std::shared_ptr<const Roots> roots;  // that jobs may name files below; null: anywhere
  Log* log = Log::Null();              // outlives the coordinator
};

// Thread-safe. Every call is short, except Sync and WatchJob, which wait for news as their messages say.
class CoordinatorImpl {
 public:
  static absl::StatusOr<std::unique_ptr<CoordinatorImpl>> Create(CoordinatorOptions options, PipelineFactory factory,
                                                                 MetricsRegistry& metrics);
  // Leaves jobs as they are: with the journal they go on.
  ~CoordinatorImpl();

  absl::StatusOr<v1::Job> CreateJob(const v1::CreateJobRequest& request, JobOrigin origin = {});
  absl::StatusOr<v1::Job> GetJob(const v1::GetJobRequest& request);
  absl::StatusOr<v1::ListJobsResponse> ListJobs(const v1::ListJobsRequest& request);
  absl::StatusOr<v1::Job> CancelJob(const v1::CancelJobRequest& request);
  absl::StatusOr<v1::Job> RetryJob(const v1::RetryJobRequest& request, JobOrigin origin = {});
  absl::StatusOr<v1::Job> PauseJob(const v1::PauseJobRequest& request);
  absl::StatusOr<v1::Job> ResumeJob(const v1::ResumeJobRequest& request);
  absl::StatusOr<v1::Job> PrioritizeJob(const v1::PrioritizeJobRequest& request);
  absl::StatusOr<v1::ListWorkersResponse> ListWorkers(const v1::ListWorkersRequest& request);
  // Calls `send` for each state of the job as the message says, and at least once a second `alive`; ends when the job
  // is over (OK) or either returns false (kCancelled).
  absl::Status WatchJob(const v1::WatchJobRequest& request, const std::function<bool(const v1::Job&)>& send,
                        const std::function<bool()>& alive);
  // What there is for workers to do.
  Demand DemandNow();
  // As WatchJob, of whether there is anything to do: now, and after each change.
  absl::Status WatchDemand(const std::function<bool(bool)>& send, const std::function<bool()>& alive);

  // `alive` tells whether the worker still waits for the answer: nothing is leased to one that does not.
  absl::StatusOr<v1::SyncResponse> Sync(const v1::SyncRequest& request, const std::function<bool()>& alive,
                                        const std::string& identity = "");
  // `stop` makes a call that stands still, here and below, end: `send` and `next` then give false.
  absl::Status ReadBlob(
      const v1::ReadBlobRequest& request, const std::function<bool(std::string_view)>& send,
      const std::function<void()>& stop = [] {});
  // `next` gives the messages of the stream and false at its end.
  absl::StatusOr<v1::WriteBlobResponse> WriteBlob(
      const std::function<bool(v1::WriteBlobRequest&)>& next, const std::function<void()>& stop = [] {});

  // Gives up overdue leases and silent workers, and lets go of what belongs to jobs that are over.
  void Tick();

  // Ends every wait: calls return at once from now on, jobs stay as they are. For a graceful end of the server.
  void StopWaiting();

 private:
  struct JobEntry {
    JobSpec spec;
    JobOrigin origin;
    std::string out_key;  // normal form of spec.out
    JobOutcome outcome;
    absl::Status error;
    std::shared_ptr<BlobFolder> blobs;
    std::unique_ptr<JobRunner> runner;
    bool completed = false;  // its output is, and its end is in the journal
    absl::Time ended;        // if it is
    bool resuming = false;   // all its tasks so far were settled by an earlier process
  };
  using Contents = std::deque<std::optional<std::string>>;
  // A result as it came, made ready without the lock.
  struct Report {
    v1::TaskRef ref;
    Stage stage;
    Event event;  // TaskCompleted or TaskFailed
    std::optional<std::string> content;
    std::string refusal = {};  // why the result is not taken, for people; else empty
    bool held = false;         // the worker held the task when its report came; else nobody looked at the result
  };
  // What a worker holds.
  struct Holding {
    CellId cell;
    Stage stage;
    std::string input;  // digest
    std::shared_ptr<BlobFolder> blobs;
    bool queue_full = false;
  };
  using Lock = std::unique_lock<std::mutex>;
  using SteadyTime = std::chrono::steady_clock::time_point;

  CoordinatorImpl(CoordinatorOptions options, PipelineFactory factory, MetricsRegistry& metrics);

  // OUTSIDE_ROOTS names the first field whose path is not below the roots. Without the lock: a mount may hang.
  absl::Status CheckRoots(const JobSpec& spec) const;
  // Two spellings of one folder give one key.
  static std::string OutKey(const JobSpec& spec);
  std::string FolderOf(const std::string& job) const;
  // Whether outputs are to be on the disk before they are committed.
  tilemend::Sync OutputSync() const { return journal_->is_durable() ? tilemend::Sync::kYes : tilemend::Sync::kNo; }

  // All below with the lock held, unless said otherwise.
  absl::StatusOr<const Job*> JobNamed(const std::string& name) const;
  // What is wrong with a request; nothing if it is one that was taken before.
  absl::Status OnlyIfNew(const std::string& request_id, const absl::Status& error) const;
  absl::StatusOr<v1::Job> StartJob(const JobSpec& spec, const std::string& request_id, int32_t priority,
                                   JobOrigin origin);
  // Starts the job's thread; if there is none to be had, the job was never there.
  absl::Status Begin(JobEntry& entry, const std::string& id);
  absl::Status CheckNewJob(const std::string& out_key) const;
  absl::StatusOr<v1::Job> Cancel(const std::string& name);
  absl::StatusOr<v1::Job> Steer(const std::string& name, JobSteered change);
  JobRunner::Sink SinkOf(const std::string& id);
  v1::Job Describe(const Job& job) const;
  v1::WorkerInfo Describe(const WorkerRecord& worker) const;
  // Why nothing of a job goes on, for people; "" if it does.
  std::string WhyWaiting(const Job& job) const;
  void ShowMetrics();
  void Changed();
  // `contents`: outputs of the tasks that the event settles, one after the other, that are not blobs.
  absl::StatusOr<Effects> Apply(const Event& event, Contents contents = {});
  // The job as it is now, or as `message` tells it.
  void PutJob(const Job& job, bool released, std::optional<v1::Job> message = std::nullopt);
  void PutResult(const SettledTask& task, const std::optional<std::string>& content);
  void PutStrike(const StruckTask& task);

  // In the journal: what one build made is nothing to another.
  TaskName NameOf(CellId cell, Stage stage, const std::string& input) const;

  // Calls of the runners; each takes the lock.
  absl::Status OnTasks(const std::string& id, std::vector<TaskSpec> tasks, const Progress& progress);
  void OnCompleted(const std::string& id, const JobOutcome& outcome, const Progress& progress);
  void OnFinished(const std::string& id, absl::StatusOr<JobOutcome> outcome);
  void OnReleased(const std::string& id);
  // Adds to `tasks` what earlier processes know of them; gives the contents of the known ones in order. Without the
  // lock.
  absl::StatusOr<Contents> Recall(const std::string& id, std::vector<TaskSpec>& tasks);
  // What `make` gives under the lock, once all that it was made from is durable. Without the lock.
  template <class Make>
  auto Answer(Make make) {
    Lock lock(mutex_);
    auto answer = make();
    lock.unlock();
    journal_->Await();
    return answer;
  }

  // The jobs of the journal go on, and what no job needs is removed. Before anything else.
  absl::Status Restore();
  absl::Status RestoreJob(JobRecord record);
  absl::Status RestoreAsFailed(int64_t number, const absl::Status& why);
  absl::Status SweepFolders();
  // With the lock held, as below.
  void ForgetOldJobs(absl::Time now);

  // Without the lock: these look at results, and at files.
  std::vector<Report> PrepareReports(const v1::SyncRequest& request);
  Report PrepareReport(const std::string& worker, const v1::FinishedTask& finished);
  void PrepareOutput(const std::string& worker, const Holding& lease, const v1::BlobRef& output, Report& report);
  absl::Status CheckOutput(const Holding& lease, const v1::BlobRef& output) const;
  void FailJobsThatAreGone(const std::vector<std::string>& jobs);
  std::optional<Holding> HoldingOf(const std::string& worker, const v1::TaskRef& ref);  // takes the lock

  // Whether another process has called itself so.
  absl::Status CheckSecret(const v1::SyncRequest& request, const std::string& identity);
  // Gives the jobs whose folders the worker does not see.
  std::vector<std::string> TakeSeen(const v1::SyncRequest& request);
  void TakeReports(const std::string& worker, std::vector<Report> reports, v1::SyncResponse& response);
  bool TakeReport(const std::string& worker, Report& report);
  // Who gets no task by what happened, and who does again.
  void TakeVerdicts(const Effects& effects);
  void Warn(const std::string& job, const std::string& warning);
  void ForgetWorker(const std::string& worker);
  void RenewHeld(const v1::SyncRequest& request);
  // Waits until there is news for the worker and writes it down; kAborted if a newer call took over.
  absl::Status AwaitNews(const v1::SyncRequest& request, const std::function<bool()>& alive, Lock& lock,
                         v1::SyncResponse& response);
  void TellState(const v1::SyncRequest& request, v1::SyncResponse& response);
  void TellToLook(const v1::SyncRequest& request, v1::SyncResponse& response) const;
  MayWork MayWorkNow() const;
  void LeaseTasks(const std::string& worker);
  std::map<std::string, std::shared_ptr<BlobFolder>> BlobsOf(const v1::SyncResponse& response);
  void InlineInputs(const std::map<std::string, std::shared_ptr<BlobFolder>>& blobs, v1::SyncResponse& response);
  absl::StatusOr<std::shared_ptr<BlobFolder>> FindBlobs(const std::string& job);  // takes the lock

  absl::Status CountSent(const v1::TaskRef& attempt, const std::string& worker, size_t bytes);  // takes the lock
  void ForgetSent();                                                                            // with the lock held
  void StopIdleStreams(absl::Time now);                                                         // likewise
  void TickLoop();

  const CoordinatorOptions options_;
  const std::shared_ptr<Journal> journal_;
  const PipelineFactory factory_;
  CoordinatorMetrics metrics_;
  ClusterEvents events_;

  std::mutex mutex_;
  std::condition_variable work_changed_;  // tasks were added or leases ended, or another call of a worker came
  std::condition_variable job_changed_;
  std::condition_variable stop_changed_;
  bool stopping_ = false;
  bool may_lose_ = true;  // silent workers are to be taken for lost
  CoordinatorState state_;
  std::map<std::string, JobEntry> entries_;
  struct Caller {
    uint64_t sequence = 0;  // of its last call
    std::string secret;
    std::string release;
    std::string identity;
    absl::Time first_seen;
  };
  std::map<std::string, Caller> callers_;  // workers
  struct Sent {
    TaskKey task;
    std::string worker;
    int64_t bytes = 0;
  };
  std::map<uint64_t, Sent> sent_;  // in blobs of attempts, by their tokens
  WorkerTrust trust_;
  LongCalls watches_{500}, streams_{250};  // threads at most
  std::atomic<bool> leaving_{false};       // this goes
  std::thread ticker_, sweeper_;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_API_COORDINATOR_IMPL_H_
