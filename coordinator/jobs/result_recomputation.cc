#include "coordinator/jobs/result_recomputation.h"

#include <utility>

#include "absl/strings/str_cat.h"
#include "common/rpc/result_digest.h"
#include "common/store/digest.h"
#include "common/util/error_info.h"
#include "common/util/status_macros.h"
#include "common/util/text.h"
#include "tilemend/v1/stages.pb.h"
#include "tilemend/v1/verify.pb.h"

namespace tilemend {
namespace {

// The result, one to compare it with, and a third that decides.
constexpr size_t kMostOpinions = 3;

std::string NameOfTask(CellId cell, Stage stage) {
  return absl::StrCat("cell ", ToString(cell), ", stage ", std::string(StageName(stage)));
}

}  // namespace

ResultRecomputation::ResultRecomputation(double share, std::shared_ptr<ScratchFile> scratch)
    : share_(share), scratch_(std::move(scratch)) {}

void ResultRecomputation::UseNotes(std::shared_ptr<JobNotes> notes, uint64_t key) {
  notes_ = std::move(notes);
  share_.UseKey(key);
}

absl::Status ResultRecomputation::AddTask(const NewTask& task) {
  if (share_.is_none() || task.stage == Stage::kAssemble) return absl::OkStatus();
  if (!share_.Has(FileDigest(task.input))) return absl::OkStatus();
  Computed computed{task.cell, task.stage, {}, {}, {}};
  TILEMEND_ASSIGN_OR_RETURN(const std::string whole, WholeInput(task));
  TILEMEND_ASSIGN_OR_RETURN(computed.input, scratch_->Put(whole));
  chosen_[Sha256Hex(task.input)] = std::move(computed);
  return absl::OkStatus();
}

void ResultRecomputation::AddResult(const TaskResult& result) {
  auto chosen = chosen_.extract(result.input);
  if (chosen.empty() || !result.output.ok() || result.worker.empty()) return;
  Computed& computed = chosen.mapped();
  computed.opinions.push_back({result.worker, ResultDigest(result.stage, *result.output)});
  computed.note = absl::StrCat("result ", computed.opinions[0].digest, " of ", std::string(StageName(result.stage)),
                               " ", result.input);
  if (!notes_->Has(computed.note)) waiting_.push_back(std::move(computed));
}

absl::StatusOr<std::optional<NewTask>> ResultRecomputation::Next() {
  if (waiting_.empty()) return std::nullopt;
  Computed computed = std::move(waiting_.front());
  waiting_.pop_front();
  v1::VerifyInput input;
  input.set_round(share_.NextNumber());
  v1::RepeatedTask& repeated = *input.add_tasks();
  repeated.set_stage(static_cast<v1::Stage>(computed.stage));
  TILEMEND_ASSIGN_OR_RETURN(*repeated.mutable_input(), scratch_->Get(computed.input));
  NewTask task{computed.cell, Stage::kVerify, input.SerializeAsString(), {}};
  for (const Opinion& opinion : computed.opinions) task.avoid.push_back(opinion.worker);
  out_[Sha256Hex(task.input)] = std::move(computed);
  return task;
}

absl::StatusOr<std::optional<CaughtWorker>> ResultRecomputation::Take(const TaskResult& result) {
  Computed computed = std::move(out_.extract(result.input).mapped());
  v1::VerifyOutput output;
  const bool is_there = result.output.ok() && output.ParseFromString(*result.output) && output.files_size() == 1;
  if (!is_there && computed.opinions.size() == 1) return std::nullopt;  // nobody else could compute it
  computed.opinions.push_back({result.worker, is_there ? output.files(0).digest() : ""});
  if (computed.opinions[0].digest == computed.opinions[1].digest) {
    notes_->Put(computed.note, result.worker);
    return std::nullopt;
  }
  if (computed.opinions.size() == kMostOpinions) return Decide(computed);
  waiting_.push_front(std::move(computed));
  return std::nullopt;
}

// Precondition: the first two differ, and there is a third.
absl::StatusOr<std::optional<CaughtWorker>> ResultRecomputation::Decide(const Computed& computed) const {
  const Opinion &first = computed.opinions[0], &second = computed.opinions[1], &third = computed.opinions[2];
  const bool is_another = third.worker != first.worker && third.worker != second.worker;
  const bool agrees = third.digest == first.digest || third.digest == second.digest;
  const std::string task = NameOfTask(computed.cell, computed.stage);
  if (is_another && agrees) {
    const std::string& worker = third.digest == first.digest ? second.worker : first.worker;
    return CaughtWorker{worker,
                        absl::StrCat("worker ", Printable(worker), " gave another result for ", task,
                                     " than two other workers; all its results in this job are computed again")};
  }
  const absl::Status undecided = absl::AbortedError(absl::StrCat(
      "workers ", Printable(first.worker), " and ", Printable(second.worker), " gave different results for ", task,
      ", and no third worker could decide; run the job again with more workers"));
  return WithErrorInfo(undecided, {"RESULTS_DIFFER", {}});
}

}  // namespace tilemend
