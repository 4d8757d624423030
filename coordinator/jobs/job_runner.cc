#include "coordinator/jobs/job_runner.h"

#include <chrono>
#include <exception>
#include <utility>

#include "absl/strings/cord.h"
#include "absl/strings/str_cat.h"
#include "common/store/digest.h"
#include "common/util/error_info.h"
#include "common/util/failpoint.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

constexpr std::chrono::milliseconds kBetweenTries(500);
constexpr int kMostTries = 1200;

// A status that ends a pipeline, not the job.
constexpr char kBegunAgain[] = "begun-again";
absl::Status BegunAgain() {
  absl::Status status = absl::AbortedError("the job begins again");
  status.SetPayload(kBegunAgain, absl::Cord());
  return status;
}
bool IsBegunAgain(const absl::Status& status) { return status.GetPayload(kBegunAgain).has_value(); }

// `content` is the output unless that is a blob.
absl::StatusOr<TaskResult> ToResult(const SettledTask& task, std::optional<std::string> content,
                                    const BlobFolder& blobs) {
  TaskResult result{.cell = task.cell,
                    .stage = task.stage,
                    .output = std::string(),
                    .worker = task.worker,
                    .input = task.input,
                    .known = task.known,
                    .digest = task.output};
  if (task.state != TaskState::kCommitted) {
    result.output = task.error;
    return result;
  }
  if (content.has_value()) {
    result.output = *std::move(content);
  } else {
    TILEMEND_ASSIGN_OR_RETURN(result.output, blobs.Read(task.output));
  }
  return result;
}

// Leaves the inputs.
std::vector<TaskSpec> SpecsOf(std::vector<NewTask>& tasks) {
  std::vector<TaskSpec> specs;
  specs.reserve(tasks.size());
  for (NewTask& task : tasks) {
    if (task.digest.empty()) task.digest = Sha256Hex(task.input);
    specs.push_back({task.cell, task.stage, std::move(task.digest), {}, {}, std::move(task.avoid)});
  }
  return specs;
}

using HeldInputs = std::multimap<std::string, std::vector<std::string>>;

// The blobs of an input, whose digest it has, are held until LetGo.
absl::Status HoldInput(BlobFolder& blobs, const std::string& digest, NewTask& task, HeldInputs& held) {
  std::vector<std::string> parts;
  for (const InputPart& part : task.parts) {
    TILEMEND_RETURN_IF_ERROR(blobs.Hold(part.digest, part.read));
    parts.push_back(part.digest);
  }
  TILEMEND_RETURN_IF_ERROR(blobs.Hold(digest, [&task] { return std::move(task.input); }));
  held.emplace(digest, std::move(parts));
  return absl::OkStatus();
}

void LetGo(BlobFolder& blobs, HeldInputs& held, HeldInputs::iterator input) {
  blobs.LetGo(input->first);
  for (const std::string& part : input->second) blobs.LetGo(part);
  held.erase(input);
}

}  // namespace

JobRunner::JobRunner(JobSpec spec, PipelineFactory factory, std::shared_ptr<BlobFolder> blobs, Sink sink, Mode mode)
    : spec_(std::move(spec)),
      factory_(std::move(factory)),
      blobs_(std::move(blobs)),
      sink_(std::move(sink)),
      resumes_(mode == Mode::kResume ? std::optional(Resumption::kRestart) : std::nullopt),
      thread_([this, mode] { mode == Mode::kRelease ? ReleaseOnly() : Run(); }) {}

JobRunner::~JobRunner() {
  Cancel();
  thread_.join();
}

void JobRunner::Deliver(SettledTask task, std::optional<std::string> content) {
  std::lock_guard<std::mutex> lock(mutex_);
  if (cancel_.stop_requested()) return;
  if (content.has_value()) queued_bytes_ += content->size();
  deliveries_.push_back({std::move(task), std::move(content)});
  changed_.notify_one();
}

bool JobRunner::Cancel() {
  std::lock_guard<std::mutex> lock(mutex_);
  return TryCancel();
}

bool JobRunner::TryCancel() {
  if (cancel_.stop_requested()) return true;
  if (too_late_ || (pipeline_ != nullptr && !pipeline_->Cancel())) return false;
  cancel_.request_stop();
  changed_.notify_one();
  return true;
}

void JobRunner::Abandon() {
  leaving_.store(true);
  std::lock_guard<std::mutex> lock(mutex_);
  abandoned_ = TryCancel();
}

void JobRunner::Fail(absl::Status error) {
  std::lock_guard<std::mutex> lock(mutex_);
  failure_ = std::move(error);
  changed_.notify_one();
}

void JobRunner::BeginAgain() {
  std::lock_guard<std::mutex> lock(mutex_);
  if (failure_.ok()) failure_ = BegunAgain();
  changed_.notify_one();
}

void JobRunner::Run() {
  sink_.await();
  std::unique_ptr<JobPipeline> pipeline;
  absl::StatusOr<JobOutcome> outcome = RunToTheEnd(pipeline);
  if (outcome.ok()) {
    FailPoint("job.finished");
    sink_.completed(*outcome, pipeline->GetProgress());
    pipeline->Release();
    FailPoint("job.released");
  }
  pipeline.reset();
  may_write_.store(false);
  {
    std::lock_guard<std::mutex> lock(mutex_);
    if (abandoned_) return;
  }
  sink_.finished(std::move(outcome));  // before the blobs go, which takes time in which the job could be cancelled
  blobs_->Remove([this] { return leaving_.load(); });  // what stays then is swept by the next process
  sink_.released();
  ended_.store(true);
}

void JobRunner::ReleaseOnly() {
  // An error here says that there is nothing to release, or nothing that could be reached.
  if (const auto pipeline = factory_(spec_, cancel_.get_token()); pipeline.ok()) (*pipeline)->Release();
  may_write_.store(false);
  sink_.released();
  ended_.store(true);
}

absl::StatusOr<JobOutcome> JobRunner::RunToTheEnd(std::unique_ptr<JobPipeline>& pipeline) {
  while (true) {
    absl::StatusOr<JobOutcome> outcome = RunPipeline(pipeline);
    const absl::StatusOr<bool> again = PrepareToBeginAgain(pipeline);
    if (again.ok() && *again) continue;
    const std::lock_guard<std::mutex> lock(mutex_);
    const bool is_cancelled = cancel_.stop_requested();
    if (again.ok() && IsBegunAgain(failure_) && !is_cancelled) continue;  // told since it was looked
    pipeline_ = nullptr;
    too_late_ = !is_cancelled;
    if (is_cancelled) return absl::CancelledError("the job was cancelled");
    return again.ok() ? std::move(outcome) : again.status();
  }
}

absl::StatusOr<bool> JobRunner::PrepareToBeginAgain(std::unique_ptr<JobPipeline>& pipeline) {
  {
    std::lock_guard<std::mutex> lock(mutex_);
    if (!IsBegunAgain(failure_) || cancel_.stop_requested()) return false;
    pipeline_ = nullptr;
  }
  pipeline.reset();
  TILEMEND_RETURN_IF_ERROR(sink_.begins_again());
  while (!outstanding_.held.empty()) LetGo(*blobs_, outstanding_.held, outstanding_.held.begin());
  outstanding_.tasks = 0;
  resumes_ = Resumption::kRevocation;
  std::lock_guard<std::mutex> lock(mutex_);
  // No task is out, so that no more come.
  deliveries_.clear();
  queued_bytes_ = 0;
  if (IsBegunAgain(failure_)) failure_ = absl::OkStatus();
  return true;
}

absl::StatusOr<std::unique_ptr<JobPipeline>> JobRunner::MakePipeline() {
  absl::StatusOr<std::unique_ptr<JobPipeline>> pipeline = factory_(spec_, cancel_.get_token());
  for (int tries = 0; resumes_ && tries < kMostTries; ++tries) {
    if (ErrorReason(pipeline.status()) != "OUTPUT_IN_USE") break;
    {
      std::unique_lock<std::mutex> lock(mutex_);
      changed_.wait_for(lock, kBetweenTries, [this] { return cancel_.stop_requested() || !failure_.ok(); });
      if (cancel_.stop_requested()) return absl::CancelledError("the job was cancelled");
      TILEMEND_RETURN_IF_ERROR(failure_);
    }
    pipeline = factory_(spec_, cancel_.get_token());
  }
  return pipeline;
}

absl::StatusOr<JobOutcome> JobRunner::RunPipeline(std::unique_ptr<JobPipeline>& pipeline) {
  try {
    TILEMEND_ASSIGN_OR_RETURN(pipeline, MakePipeline());
    {
      std::lock_guard<std::mutex> lock(mutex_);
      if (cancel_.stop_requested()) return absl::CancelledError("the job was cancelled");
      pipeline_ = pipeline.get();
    }
    TILEMEND_ASSIGN_OR_RETURN(JobFolders folders, pipeline->Folders());
    sink_.folders(std::move(folders));
    sink_.sight(pipeline->Sight());
    pipeline->Prepare(sink_.notes, resumes_);
    TILEMEND_ASSIGN_OR_RETURN(std::vector<NewTask> first, pipeline->Start());
    TILEMEND_RETURN_IF_ERROR(AddTasks(*pipeline, std::move(first)));
    while (!pipeline->Done()) {
      if (outstanding_.tasks == 0) {
        return absl::InternalError("the pipeline is not done, yet has no task left: this is a bug in tilemend");
      }
      TILEMEND_ASSIGN_OR_RETURN(std::deque<Delivery> deliveries, NextDeliveries());
      for (Delivery& delivery : deliveries) TILEMEND_RETURN_IF_ERROR(TakeDelivery(*pipeline, std::move(delivery)));
    }
    return pipeline->Finish();
  } catch (const std::bad_alloc&) {
    return absl::ResourceExhaustedError("the coordinator is out of memory");
  } catch (const std::exception& error) {
    return absl::InternalError(absl::StrCat("the pipeline threw: ", error.what()));
  }
}

absl::StatusOr<std::deque<JobRunner::Delivery>> JobRunner::NextDeliveries() {
  std::unique_lock<std::mutex> lock(mutex_);
  changed_.wait(lock, [this] { return cancel_.stop_requested() || !failure_.ok() || !deliveries_.empty(); });
  if (cancel_.stop_requested()) return absl::CancelledError("the job was cancelled");
  TILEMEND_RETURN_IF_ERROR(failure_);
  std::deque<Delivery> deliveries = std::exchange(deliveries_, {});
  lock.unlock();
  sink_.await();
  return deliveries;
}

absl::Status JobRunner::TakeDelivery(JobPipeline& pipeline, Delivery delivery) {
  {
    std::lock_guard<std::mutex> lock(mutex_);
    if (cancel_.stop_requested()) return absl::CancelledError("the job was cancelled");
    TILEMEND_RETURN_IF_ERROR(failure_);
  }
  if (delivery.content.has_value()) queued_bytes_ -= delivery.content->size();
  --outstanding_.tasks;
  if (!delivery.task.known) {
    LetGo(*blobs_, outstanding_.held, outstanding_.held.find(delivery.task.input));
  }
  TILEMEND_ASSIGN_OR_RETURN(TaskResult result, ToResult(delivery.task, std::move(delivery.content), *blobs_));
  TILEMEND_ASSIGN_OR_RETURN(std::vector<NewTask> tasks, pipeline.OnTaskDone(std::move(result)));
  if (const auto caught = pipeline.Caught()) {
    TILEMEND_RETURN_IF_ERROR(sink_.caught(*caught));
    BeginAgain();
    return absl::OkStatus();
  }
  return AddTasks(pipeline, std::move(tasks));
}

absl::Status JobRunner::AddTasks(JobPipeline& pipeline, std::vector<NewTask> tasks) {
  std::vector<TaskSpec> specs = SpecsOf(tasks);
  TILEMEND_ASSIGN_OR_RETURN(TaskContents contents, sink_.recall(specs));
  for (size_t i = 0; i < tasks.size(); ++i) {
    if (specs[i].known) continue;  // nobody reads its input
    TILEMEND_RETURN_IF_ERROR(HoldInput(*blobs_, specs[i].input, tasks[i], outstanding_.held));
  }
  outstanding_.tasks += static_cast<int64_t>(specs.size());
  return sink_.add_tasks(std::move(specs), std::move(contents), pipeline.GetProgress());
}

}  // namespace tilemend
