#include "coordinator/service/job_runner.h"

#include <exception>
#include <utility>

#include "absl/cleanup/cleanup.h"
#include "absl/strings/str_cat.h"
#include "common/util/status_macros.h"

namespace tilemend {

JobRunner::JobRunner(JobSpec spec, PipelineFactory factory, std::shared_ptr<BlobFolder> blobs, Sink sink)
    : spec_(std::move(spec)),
      factory_(std::move(factory)),
      blobs_(std::move(blobs)),
      sink_(std::move(sink)),
      thread_([this] { Run(); }) {}

JobRunner::~JobRunner() {
  Cancel();
  thread_.join();
}

void JobRunner::Deliver(SettledTask task, std::optional<std::string> content) {
  std::lock_guard<std::mutex> lock(mutex_);
  if (cancelled_) return;
  if (content.has_value()) queued_bytes_ += content->size();
  deliveries_.push_back({std::move(task), std::move(content)});
  changed_.notify_one();
}

bool JobRunner::Cancel() {
  std::lock_guard<std::mutex> lock(mutex_);
  if (cancelled_) return true;
  if (too_late_ || (pipeline_ != nullptr && !pipeline_->Cancel())) return false;
  cancelled_ = true;
  changed_.notify_one();
  return true;
}

void JobRunner::Run() {
  absl::StatusOr<JobOutcome> outcome = absl::InternalError("the pipeline gave no outcome");
  try {
    outcome = RunPipeline();
  } catch (const std::bad_alloc&) {
    outcome = absl::ResourceExhaustedError("the coordinator is out of memory");
  } catch (const std::exception& error) {
    outcome = absl::InternalError(absl::StrCat("the pipeline threw: ", error.what()));
  }
  may_write_.store(false);
  bool cancelled = false;
  {
    std::lock_guard<std::mutex> lock(mutex_);
    cancelled = cancelled_;
  }
  if (cancelled) outcome = absl::CancelledError("the job was cancelled");
  sink_.finished(std::move(outcome));  // before the blobs go, which takes time in which the job could be cancelled
  blobs_->Remove();
  ended_.store(true);
}

absl::StatusOr<JobOutcome> JobRunner::RunPipeline() {
  TILEMEND_ASSIGN_OR_RETURN(const std::unique_ptr<JobPipeline> pipeline, factory_(spec_));
  {
    std::lock_guard<std::mutex> lock(mutex_);
    if (cancelled_) return absl::CancelledError("the job was cancelled");
    pipeline_ = pipeline.get();
  }
  const auto forget = absl::MakeCleanup([this] {
    std::lock_guard<std::mutex> lock(mutex_);
    pipeline_ = nullptr;
    too_late_ = !cancelled_;
  });
  return DrivePipeline(*pipeline);
}

absl::StatusOr<JobOutcome> JobRunner::DrivePipeline(JobPipeline& pipeline) {
  TILEMEND_ASSIGN_OR_RETURN(std::vector<NewTask> first, pipeline.Start());
  TILEMEND_RETURN_IF_ERROR(AddTasks(pipeline, std::move(first)));
  while (!pipeline.Done()) {
    if (outstanding_ == 0) {
      return absl::InternalError("the pipeline is not done, yet has no task left: this is a bug in tilemend");
    }
    TILEMEND_ASSIGN_OR_RETURN(Delivery delivery, NextDelivery());
    TILEMEND_ASSIGN_OR_RETURN(TaskResult result, ToResult(std::move(delivery)));
    TILEMEND_ASSIGN_OR_RETURN(std::vector<NewTask> tasks, pipeline.OnTaskDone(std::move(result)));
    TILEMEND_RETURN_IF_ERROR(AddTasks(pipeline, std::move(tasks)));
  }
  return pipeline.Finish();
}

absl::StatusOr<JobRunner::Delivery> JobRunner::NextDelivery() {
  std::unique_lock<std::mutex> lock(mutex_);
  changed_.wait(lock, [this] { return cancelled_ || !deliveries_.empty(); });
  if (cancelled_) return absl::CancelledError("the job was cancelled");
  Delivery delivery = std::move(deliveries_.front());
  deliveries_.pop_front();
  if (delivery.content.has_value()) queued_bytes_ -= delivery.content->size();
  --outstanding_;
  return delivery;
}

absl::StatusOr<TaskResult> JobRunner::ToResult(Delivery delivery) const {
  const SettledTask& task = delivery.task;
  TaskResult result{.cell = task.cell, .stage = task.stage, .output = std::string()};
  if (task.state != TaskState::kCommitted) {
    result.output = task.error;
    return result;
  }
  if (delivery.content.has_value()) {
    result.output = *std::move(delivery.content);
  } else {
    TILEMEND_ASSIGN_OR_RETURN(result.output, blobs_->Read(task.output));
  }
  return result;
}

absl::Status JobRunner::AddTasks(JobPipeline& pipeline, std::vector<NewTask> tasks) {
  std::vector<TaskSpec> specs;
  specs.reserve(tasks.size());
  for (NewTask& task : tasks) {
    TILEMEND_ASSIGN_OR_RETURN(std::string digest, blobs_->Put(task.input));
    specs.push_back({task.cell, task.stage, std::move(digest)});
    task.input = std::string();
  }
  outstanding_ += static_cast<int64_t>(specs.size());
  sink_.add_tasks(std::move(specs), pipeline.GetProgress());
  return absl::OkStatus();
}

}  // namespace tilemend
