#include "coordinator/jobs/job_runner.h"

#include <chrono>
#include <exception>
#include <map>
#include <new>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/store/digest.h"
#include "common/util/error_info.h"
#include "common/util/failpoint.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

constexpr std::chrono::milliseconds kBetweenTries(500);
constexpr int kMostTries = 1200;

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

// The blobs of inputs of tasks that are given out and were not settled before. They are held in the folder.
class HeldInputs {
 public:
  explicit HeldInputs(BlobFolder& blobs) : blobs_(blobs) {}

  // `digest`: of the task's input.
  absl::Status Hold(const std::string& digest, NewTask& task) {
    std::vector<std::string> parts;
    for (const InputPart& part : task.parts) {
      TILEMEND_RETURN_IF_ERROR(blobs_.Hold(part.digest, part.read));
      parts.push_back(part.digest);
    }
    TILEMEND_RETURN_IF_ERROR(blobs_.Hold(digest, [&task] { return std::move(task.input); }));
    held_.emplace(digest, std::move(parts));
    return absl::OkStatus();
  }

  void LetGo(const std::string& digest) { LetGo(held_.find(digest)); }
  void LetAllGo() {
    while (!held_.empty()) LetGo(held_.begin());
  }

 private:
  using Held = std::multimap<std::string, std::vector<std::string>>;  // digests of inputs, and of their parts

  void LetGo(Held::iterator input) {
    blobs_.LetGo(input->first);
    for (const std::string& part : input->second) blobs_.LetGo(part);
    held_.erase(input);
  }

  BlobFolder& blobs_;
  Held held_;
};

// Runs the pipelines of one job, one after the other. Of the job's thread.
class PipelineRuns {
 public:
  PipelineRuns(std::function<absl::StatusOr<std::unique_ptr<JobPipeline>>()> factory, BlobFolder& blobs,
               const JobRunner::Sink& sink, std::optional<Resumption> resumes, JobInbox& inbox)
      : factory_(std::move(factory)), blobs_(blobs), inputs_(blobs), sink_(sink), resumes_(resumes), inbox_(inbox) {}

  // The end of the job's last pipeline as it counts: its outcome, or that it was cancelled before. From now on it is
  // too late for that.
  absl::StatusOr<JobOutcome> RunToTheEnd(std::unique_ptr<JobPipeline>& pipeline) {
    while (true) {
      absl::StatusOr<JobOutcome> outcome = Run(pipeline);
      absl::StatusOr<bool> again = PrepareToBeginAgain(pipeline);
      JobInbox::End end = JobInbox::End::kBeginsAgain;
      while (!(again.ok() && *again) && end == JobInbox::End::kBeginsAgain) {
        end = inbox_.Close(again.ok());
        if (end == JobInbox::End::kBeginsAgain) again = PrepareToBeginAgain(pipeline);  // told since it was looked
      }
      if (end == JobInbox::End::kCancelled) return absl::CancelledError("the job was cancelled");
      if (end == JobInbox::End::kDone) return again.ok() ? std::move(outcome) : again.status();
    }
  }

 private:
  // Makes the pipeline and runs it to its end, whatever it throws.
  absl::StatusOr<JobOutcome> Run(std::unique_ptr<JobPipeline>& pipeline) {
    try {
      TILEMEND_ASSIGN_OR_RETURN(pipeline, Make());
      TILEMEND_RETURN_IF_ERROR(inbox_.SetPipeline(*pipeline));
      TILEMEND_ASSIGN_OR_RETURN(JobFolders folders, pipeline->Folders());
      sink_.folders(std::move(folders));
      sink_.sight(pipeline->Sight());
      pipeline->Prepare(sink_.notes, resumes_);
      TILEMEND_ASSIGN_OR_RETURN(std::vector<NewTask> first, pipeline->Start());
      TILEMEND_RETURN_IF_ERROR(AddTasks(*pipeline, std::move(first)));
      while (!pipeline->Done()) {
        if (tasks_ == 0) {
          return absl::InternalError("the pipeline is not done, yet has no task left: this is a bug in tilemend");
        }
        TILEMEND_ASSIGN_OR_RETURN(auto deliveries, inbox_.Next());
        sink_.await();  // until they are durable
        for (auto& delivery : deliveries) TILEMEND_RETURN_IF_ERROR(Take(*pipeline, std::move(delivery)));
      }
      return pipeline->Finish();
    } catch (const std::bad_alloc&) {
      return absl::ResourceExhaustedError("the coordinator is out of memory");
    } catch (const std::exception& error) {
      return absl::InternalError(absl::StrCat("the pipeline threw: ", error.what()));
    }
  }

  // Where the job resumes, an earlier coordinator that is stopped, not dead, may hold the output until it wakes and
  // ends: that is waited for, ten minutes at most.
  absl::StatusOr<std::unique_ptr<JobPipeline>> Make() {
    absl::StatusOr<std::unique_ptr<JobPipeline>> pipeline = factory_();
    for (int tries = 0; resumes_ && tries < kMostTries; ++tries) {
      if (ErrorReason(pipeline.status()) != "OUTPUT_IN_USE") break;
      TILEMEND_RETURN_IF_ERROR(inbox_.Wait(kBetweenTries));
      pipeline = factory_();
    }
    return pipeline;
  }

  // After a pipeline ended. False if that is the job's end.
  absl::StatusOr<bool> PrepareToBeginAgain(std::unique_ptr<JobPipeline>& pipeline) {
    if (!inbox_.BeginsAgain()) return false;
    pipeline.reset();
    TILEMEND_RETURN_IF_ERROR(sink_.begins_again());
    inputs_.LetAllGo();
    tasks_ = 0;
    resumes_ = Resumption::kRevocation;
    inbox_.Restart();
    return true;
  }

  absl::Status Take(JobPipeline& pipeline, JobInbox::Delivery delivery) {
    TILEMEND_RETURN_IF_ERROR(inbox_.Begin(delivery));
    --tasks_;
    if (!delivery.task.known) inputs_.LetGo(delivery.task.input);
    TILEMEND_ASSIGN_OR_RETURN(TaskResult result, ToResult(delivery.task, std::move(delivery.content), blobs_));
    TILEMEND_ASSIGN_OR_RETURN(std::vector<NewTask> tasks, pipeline.OnTaskDone(std::move(result)));
    if (const auto caught = pipeline.Caught()) {
      TILEMEND_RETURN_IF_ERROR(sink_.caught(*caught));
      inbox_.Fail(BegunAgain());
      return absl::OkStatus();
    }
    return AddTasks(pipeline, std::move(tasks));
  }

  absl::Status AddTasks(JobPipeline& pipeline, std::vector<NewTask> tasks) {
    std::vector<TaskSpec> specs = SpecsOf(tasks);
    TILEMEND_ASSIGN_OR_RETURN(TaskContents contents, sink_.recall(specs));
    for (size_t i = 0; i < tasks.size(); ++i) {
      if (specs[i].known) continue;  // nobody reads its input
      TILEMEND_RETURN_IF_ERROR(inputs_.Hold(specs[i].input, tasks[i]));
    }
    tasks_ += static_cast<int64_t>(specs.size());
    return sink_.add_tasks(std::move(specs), std::move(contents), pipeline.GetProgress());
  }

  const std::function<absl::StatusOr<std::unique_ptr<JobPipeline>>()> factory_;
  BlobFolder& blobs_;
  HeldInputs inputs_;
  const JobRunner::Sink& sink_;
  std::optional<Resumption> resumes_;
  JobInbox& inbox_;
  int64_t tasks_ = 0;  // that are given out and not yet taken back
};

}  // namespace

JobRunner::JobRunner(JobSpec spec, PipelineFactory factory, std::shared_ptr<BlobFolder> blobs, Sink sink, Mode mode)
    : spec_(std::move(spec)),
      factory_(std::move(factory)),
      blobs_(std::move(blobs)),
      sink_(std::move(sink)),
      thread_([this, mode] {
        if (mode == Mode::kRelease) return ReleaseOnly();
        Run(mode == Mode::kResume ? std::optional(Resumption::kRestart) : std::nullopt);
      }) {}

JobRunner::~JobRunner() {
  inbox_.Cancel();
  thread_.join();
}

void JobRunner::Abandon() {
  leaving_.store(true);
  inbox_.Cancel();
}

void JobRunner::Run(std::optional<Resumption> resumes) {
  sink_.await();
  std::unique_ptr<JobPipeline> pipeline;
  PipelineRuns runs([this] { return factory_(spec_, inbox_.cancelled()); }, *blobs_, sink_, resumes, inbox_);
  absl::StatusOr<JobOutcome> outcome = runs.RunToTheEnd(pipeline);
  if (outcome.ok()) {
    FailPoint("job.finished");
    sink_.completed(*outcome, pipeline->GetProgress());
    pipeline->Release();
    FailPoint("job.released");
  }
  pipeline.reset();
  may_write_.store(false);
  if (leaving_.load() && inbox_.cancelled().stop_requested()) return;  // abandoned before its end
  sink_.finished(std::move(outcome));  // before the blobs go, which takes time in which the job could be cancelled
  blobs_->Remove([this] { return leaving_.load(); });  // what stays then is swept by the next process
  sink_.released();
  ended_.store(true);
}

void JobRunner::ReleaseOnly() {
  // An error here says that there is nothing to release, or nothing that could be reached.
  if (const auto pipeline = factory_(spec_, inbox_.cancelled()); pipeline.ok()) (*pipeline)->Release();
  may_write_.store(false);
  sink_.released();
  ended_.store(true);
}

}  // namespace tilemend
