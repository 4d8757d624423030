// Runs the pipeline of one job on a thread of its own.
#ifndef TILEMEND_COORDINATOR_JOBS_JOB_RUNNER_H_
#define TILEMEND_COORDINATOR_JOBS_JOB_RUNNER_H_

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "coordinator/jobs/job_pipeline.h"
#include "coordinator/state/event.h"
#include "coordinator/store/blob_folder.h"
#include "coordinator/store/job_notes.h"

namespace tilemend {

// Outputs of tasks that are settled, one after the other; none for an output that is a blob.
using TaskContents = std::deque<std::optional<std::string>>;

class JobRunner {
 public:
  // Called on the job's thread, without any lock of the runner.
  struct Sink {
    // Adds to the tasks what earlier processes know of them; returns the contents of those that are settled, in order.
    // An error fails the job, here and below.
    std::function<absl::StatusOr<TaskContents>(std::vector<TaskSpec>&)> recall = [](const std::vector<TaskSpec>&) {
      return TaskContents();
    };
    // The inputs of tasks that are not settled are held in the blob folder until the task is delivered.
    std::function<absl::Status(std::vector<TaskSpec>, TaskContents, const Progress&)> add_tasks;
    // Waits until all that was delivered, and the job itself, is durable: only then may anybody see what follows of it.
    std::function<void()> await;
    // The output is complete. Makes that durable.
    std::function<void(const JobOutcome&, const Progress&)> completed;
    std::function<void(absl::StatusOr<JobOutcome>)> finished;            // kCancelled after Cancel
    std::function<void()> released;                                      // last; the job has left nothing to take away
    std::function<void(JobFolders)> folders = [](const JobFolders&) {};  // first
    std::function<void(std::shared_ptr<const SceneSight>)> sight = [](const std::shared_ptr<const SceneSight>&) {};
    // An accepted result of a worker is wrong. An error fails the job.
    std::function<absl::Status(const CaughtWorker&)> caught = [](const CaughtWorker& worker) {
      return absl::AbortedError(worker.reason);
    };
    // The job begins again: its tasks are forgotten, and recall knows the results that stay.
    std::function<absl::Status()> begins_again = [] { return absl::OkStatus(); };
    std::shared_ptr<JobNotes> notes = std::make_shared<JobNotes>();
  };
  enum class Mode { kRun, kResume, kRelease };

  // Starts the thread. Removes the blob folder at the job's end. With kResume the job began in an earlier process. With
  // kRelease the job is over, but the coordinator ended before its output was released: nothing but that is done, and
  // `blobs` may be null.
  JobRunner(JobSpec spec, PipelineFactory factory, std::shared_ptr<BlobFolder> blobs, Sink sink,
            Mode mode = Mode::kRun);
  // Cancels and waits for the thread.
  ~JobRunner();

  // Hands over a task that came to its end. `content` is its output if that is not a blob.
  void Deliver(SettledTask task, std::optional<std::string> content);

  // Ends the pipeline and runs another, which asks for all tasks again. No effect once the job is over.
  void BeginAgain();

  // Bytes of content that wait for the pipeline.
  size_t queued_bytes() const { return queued_bytes_.load(); }

  // False if the pipeline has come to its end before: the job ends as it was about to.
  bool Cancel();

  // Ends the thread soon, and the job not at all unless that has come to its end: it tells nobody, and what is on the
  // disk stays.
  void Abandon();

  // Ends the job with this error, unless it has come to its end.
  void Fail(absl::Status error);

  // True until the pipeline has ended: the job may write to its output, even if cancelled.
  bool may_write() const { return may_write_.load(); }

  // True once nothing runs any more.
  bool ended() const { return ended_.load(); }

 private:
  struct Delivery {
    SettledTask task;
    std::optional<std::string> content;
  };

  // Tasks that are given out and not yet taken back, and inputs of those of them that were not settled before.
  struct Outstanding {
    int64_t tasks = 0;
    std::multimap<std::string, std::vector<std::string>> held;  // and their parts
  };

  bool TryCancel();  // with the lock held
  void Run();
  void ReleaseOnly();
  // Where the job resumes, an earlier coordinator that is stopped, not dead, may hold the output until it wakes and
  // ends: that is waited for, ten minutes at most.
  absl::StatusOr<std::unique_ptr<JobPipeline>> MakePipeline();
  // Makes the pipeline and runs it to its end, whatever it throws.
  absl::StatusOr<JobOutcome> RunPipeline(std::unique_ptr<JobPipeline>& pipeline);
  // After a pipeline ended. False if that is the job's end.
  absl::StatusOr<bool> PrepareToBeginAgain(std::unique_ptr<JobPipeline>& pipeline);
  // Durable ones.
  absl::StatusOr<std::deque<Delivery>> NextDeliveries();
  absl::Status TakeDelivery(JobPipeline& pipeline, Delivery delivery);
  // The end of the job's last pipeline as it counts: its outcome, or that it was cancelled before. From now on it is
  // too late for that.
  absl::StatusOr<JobOutcome> RunToTheEnd(std::unique_ptr<JobPipeline>& pipeline);
  absl::Status AddTasks(JobPipeline& pipeline, std::vector<NewTask> tasks);

  const JobSpec spec_;
  const PipelineFactory factory_;
  const std::shared_ptr<BlobFolder> blobs_;
  const Sink sink_;
  std::optional<Resumption> resumes_;  // here and below: the job's thread only
  Outstanding outstanding_;
  std::atomic<size_t> queued_bytes_{0};
  std::atomic<bool> may_write_{true};
  std::atomic<bool> ended_{false};

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Delivery> deliveries_;
  bool abandoned_ = false;
  std::stop_source cancel_;           // also of the making of the pipeline
  std::atomic<bool> leaving_{false};  // Abandon was called
  absl::Status failure_;              // of the job, or BegunAgain()
  bool too_late_ = false;             // to cancel
  JobPipeline* pipeline_ = nullptr;   // while it may be cancelled
  std::thread thread_;                // last: it uses the others
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_JOB_RUNNER_H_
