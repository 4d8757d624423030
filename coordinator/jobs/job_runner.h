// Runs the pipeline of one job on a thread of its own.
#ifndef TILEMEND_COORDINATOR_JOBS_JOB_RUNNER_H_
#define TILEMEND_COORDINATOR_JOBS_JOB_RUNNER_H_

#include <atomic>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "coordinator/jobs/job_inbox.h"
#include "coordinator/jobs/job_pipeline.h"
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

  JobInbox& inbox() { return inbox_; }

  // Ends the thread soon, and the job not at all unless that has come to its end: it tells nobody, and what is on the
  // disk stays.
  void Abandon();

  // True until the pipeline has ended: the job may write to its output, even if cancelled.
  bool may_write() const { return may_write_.load(); }

  // True once nothing runs any more.
  bool ended() const { return ended_.load(); }

 private:
  void Run(std::optional<Resumption> resumes);
  void ReleaseOnly();

  const JobSpec spec_;
  const PipelineFactory factory_;
  const std::shared_ptr<BlobFolder> blobs_;
  const Sink sink_;
  JobInbox inbox_;
  std::atomic<bool> leaving_{false};  // Abandon was called
  std::atomic<bool> may_write_{true};
  std::atomic<bool> ended_{false};
  std::thread thread_;  // last: it uses the others
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_JOB_RUNNER_H_
