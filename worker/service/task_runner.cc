#include "worker/service/task_runner.h"

#include <chrono>
#include <exception>
#include <new>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/rpc/status_proto.h"

namespace tilemend {
namespace {

absl::StatusOr<std::string> RunStage(const StageRunner& runner, Stage stage, const std::string& input,
                                     const CancelToken& cancel) {
  try {
    return runner(stage, input, cancel);
  } catch (const std::bad_alloc&) {
    return absl::ResourceExhaustedError("the worker is out of memory");
  } catch (const std::exception& error) {
    return absl::InternalError(absl::StrCat("stage ", std::string(StageName(stage)), " threw: ", error.what()));
  }
}

void LogFailure(Log& log, const v1::Task& task, const v1::Status& error) {
  log.Warn("task failed", {{"job", task.ref().job()},
                           {"trace", task.trace()},
                           {"task", task.ref().task()},
                           {"cell", absl::StrCat(task.cell().col(), ",", task.cell().row())},
                           {"stage", StageName(static_cast<Stage>(task.stage()))},
                           {"attempt", task.attempt()},
                           {"error", error.message()}});
}

}  // namespace

TaskRunner::TaskRunner(const WorkerOptions& options, StageRunner runner, TaskBlobs& blobs, WorkerState& state,
                       WorkerMetrics& metrics)
    : options_(options),
      runner_(std::move(runner)),
      blobs_(blobs),
      state_(state),
      metrics_(metrics),
      cores_(options.threads) {}

void TaskRunner::RunAll() {
  while (const auto work = state_.NextWork()) {
    if (work->folders) {
      state_.Add(work->folders->job(), options_.look(*work->folders));
    } else {
      Run(*work->task);
    }
  }
}

void TaskRunner::Run(HeldTask& held) {
  const absl::StatusOr<std::string> input = blobs_.Input(held);
  std::optional<absl::StatusOr<std::string>> output = input.ok() ? Compute(held, *input) : input.status();
  if (!output) {
    state_.Finish(held, nullptr);
    return;
  }
  const v1::FinishedTask report = Report(held, *std::move(output));
  if (report.has_error() && !held.cancel.cancelled()) LogFailure(*options_.log, held.task, report.error());
  if (!state_.Finish(held, &report) && report.has_output()) {
    options_.discard(static_cast<Stage>(held.task.stage()), *input, report.output().content());
  }
}

std::optional<absl::StatusOr<std::string>> TaskRunner::Compute(HeldTask& held, const std::string& input) {
  const Cores::Held core(cores_);
  if (held.cancel.cancelled()) return std::nullopt;
  held.begun = true;
  const Stage stage = static_cast<Stage>(held.task.stage());
  WorkerMetrics::PerStage& metrics = metrics_.Of(stage);
  metrics.started->Increment();
  metrics.bytes_in->Increment(static_cast<double>(input.size()));
  const auto start = std::chrono::steady_clock::now();
  absl::StatusOr<std::string> output = RunStage(runner_, stage, input, held.cancel);
  metrics.seconds->Observe(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  return output;
}

v1::FinishedTask TaskRunner::Report(const HeldTask& held, absl::StatusOr<std::string> output) {
  v1::FinishedTask report;
  *report.mutable_ref() = held.task.ref();
  report.set_stage(held.task.stage());
  absl::Status failure = output.status();
  if (output.ok()) {
    const Stage stage = static_cast<Stage>(held.task.stage());
    metrics_.Of(stage).bytes_out->Increment(static_cast<double>(output->size()));
    absl::StatusOr<v1::BlobRef> blob = blobs_.Store(held, *std::move(output));
    if (blob.ok()) *report.mutable_output() = *std::move(blob);
    failure = blob.status();
  }
  if (!failure.ok()) *report.mutable_error() = StatusToProto(failure);
  return report;
}

}  // namespace tilemend
