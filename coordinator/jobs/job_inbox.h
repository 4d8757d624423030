// What others tell the thread of a job: tasks that came to their end, and that the job is to end.
#ifndef TILEMEND_COORDINATOR_JOBS_JOB_INBOX_H_
#define TILEMEND_COORDINATOR_JOBS_JOB_INBOX_H_

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "coordinator/jobs/job_pipeline.h"
#include "coordinator/state/event.h"

namespace tilemend {

// Ends a pipeline, not the job: another pipeline asks for all tasks again.
absl::Status BegunAgain();

// Thread-safe.
class JobInbox {
 public:
  struct Delivery {
    SettledTask task;
    std::optional<std::string> content;
  };

  // A task that came to its end. `content` is its output if that is not a blob.
  void Deliver(SettledTask task, std::optional<std::string> content);
  // Ends the job with this error, unless it has come to its end. BegunAgain() has no effect after an error.
  void Fail(absl::Status error);
  // False if the pipeline has come to its end before: the job ends as it was about to.
  bool Cancel();
  std::stop_token cancelled() const { return cancel_.get_token(); }
  // Bytes of content that wait for the pipeline.
  size_t queued_bytes() const { return queued_bytes_.load(); }

  // For the job's thread. kCancelled, or what Fail said.
  absl::Status Wait(std::chrono::milliseconds time);
  absl::StatusOr<std::deque<Delivery>> Next();
  // The pipeline takes the delivery now.
  absl::Status Begin(const Delivery& delivery);
  // From now on it is asked whether the job may be cancelled.
  absl::Status SetPipeline(JobPipeline& pipeline);

  // Whether the pipeline is to be followed by another. If so, it may go.
  bool BeginsAgain();
  // No task is out, so that no more come.
  void Restart();
  enum class End { kBeginsAgain, kCancelled, kDone };
  // After the pipeline. From now on it is too late to cancel, unless the job begins again.
  End Close(bool may_begin_again);

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Delivery> deliveries_;
  std::atomic<size_t> queued_bytes_{0};
  std::stop_source cancel_;  // also of the making of the pipeline
  absl::Status failure_;
  bool too_late_ = false;            // to cancel
  JobPipeline* pipeline_ = nullptr;  // while it may be cancelled
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_JOB_INBOX_H_
