#include "coordinator/jobs/task_reuse.h"

#include "absl/strings/str_cat.h"
#include "common/store/digest.h"
#include "common/util/build_id.h"
#include "common/util/status_macros.h"
#include "coordinator/jobs/result_checks.h"
#include "tilemend/v1/stages.pb.h"

namespace tilemend {
namespace {

// Precondition: the task has its digest.
std::string KeyOf(const NewTask& task) {
  return Sha256Hex(absl::StrCat(BuildId(), "\n", std::string(StageName(task.stage)), "\n", task.digest));
}

std::string WithKnownSurvey(const std::string& bytes, const std::string& known) {
  v1::SurveyInput input;
  v1::SurveyOutput output;
  if (!input.ParseFromString(bytes) || !output.ParseFromString(known)) return bytes;
  *input.mutable_known() = std::move(*output.mutable_witness());
  return input.SerializeAsString();
}

// A file that could not be carried may be there by now.
std::string WithKnownFiles(const std::string& bytes, const std::string& known) {
  v1::AssembleInput input;
  v1::AssembleOutput output;
  if (!input.ParseFromString(bytes) || !output.ParseFromString(known) || output.warnings_size() > 0) return bytes;
  *input.mutable_known() = std::move(output);
  return input.SerializeAsString();
}

}  // namespace

std::optional<StageResult> TaskReuse::Recall(NewTask& task, int32_t number) {
  ++tasks_;
  if (task.stage == Stage::kAssemble) ++tiles_;
  if (!log_ || task.stage == Stage::kMeasure) return std::nullopt;
  task.digest = Sha256Hex(task.input);
  std::string key = KeyOf(task);
  std::optional<std::string> known = log_->Find(key);
  if (known && task.stage == Stage::kSurvey) {
    task.SetInput(WithKnownSurvey(task.input, *known));
  } else if (known && task.stage == Stage::kAssemble) {
    task.SetInput(WithKnownFiles(task.input, *known));
  } else if (known) {
    auto result = DecodeResult({task.cell, task.stage, *std::move(known)});
    if (result.ok() && CheckKnownOutput(task.input, result->output).ok()) {
      ++taken_over_;
      ++without_worker_;
      return *std::move(result);
    }
  }
  keys_[{task.cell, task.stage, number}] = std::move(key);
  return std::nullopt;
}

absl::Status TaskReuse::Resolve(StageResult& result, int32_t number) {
  const auto key = keys_.find({result.cell, result.stage, number});
  if (key == keys_.end() || !IsUnchanged(result.output)) return absl::OkStatus();
  if (result.stage == Stage::kSurvey) {
    std::optional<std::string> known = log_->Find(key->second);
    if (!known) return absl::AbortedError("results of an earlier job were changed while this one ran; run it again");
    TILEMEND_ASSIGN_OR_RETURN(result, DecodeResult({result.cell, result.stage, *std::move(known)}));
  }
  if (result.stage == Stage::kAssemble) ++tiles_kept_;
  keys_.erase(key);
  ++taken_over_;
  return absl::OkStatus();
}

absl::Status TaskReuse::Keep(CellId cell, Stage stage, int32_t number, const std::string& bytes,
                             const std::string& digest) {
  const auto key = keys_.extract({cell, stage, number});
  return key.empty() ? absl::OkStatus() : log_->Put(key.mapped(), bytes, digest);
}

void TaskReuse::Discard() {
  if (log_) log_->Discard();
}

absl::Status TaskReuse::Finish() { return log_ ? log_->KeepUsed() : absl::OkStatus(); }

}  // namespace tilemend
