#include "coordinator/jobs/scene_verification.h"

#include <cstdint>
#include <utility>
#include <variant>

#include "absl/strings/numbers.h"
#include "absl/strings/str_cat.h"
#include "common/util/error_info.h"
#include "common/util/status_macros.h"
#include "coordinator/jobs/random_share.h"
#include "coordinator/jobs/tile_tasks.h"

namespace tilemend {
namespace {

// What chooses the shares, the same in all processes of a job.
uint64_t KeyIn(JobNotes& notes) {
  constexpr char kName[] = "key of the shares";
  uint64_t key = 0;
  if (const auto known = notes.Find(kName); known && absl::SimpleAtoi(*known, &key)) return key;
  key = RandomShare::NewKey();
  notes.Put(kName, "", absl::StrCat(key));
  return key;
}

}  // namespace

SceneVerification::SceneVerification(VerifiedShares shares, std::string output, std::shared_ptr<ScratchFile> scratch)
    : output_(std::move(output)),
      is_wanted_(!output_.empty() && shares.files + shares.results > 0),
      files_(output_.empty() ? 0 : shares.files),
      results_(output_.empty() ? 0 : shares.results, std::move(scratch)) {}

void SceneVerification::UseNotes(const std::shared_ptr<JobNotes>& notes) {
  const uint64_t key = KeyIn(*notes);
  results_.UseNotes(notes, key);
  files_.UseNotes(notes, key);
}

void SceneVerification::AddResult(const TaskResult& result) {
  results_.AddResult(result);
  const absl::Status& status = result.output.status();
  const bool seems_changed = absl::IsAborted(status) && ErrorReason(status).empty();
  if (seems_changed) caught_ = files_.WhoIsWrongNear(result.cell);
}

void SceneVerification::ReadOutput(const StageOutput& output, const SceneWaves& waves, Report& report) {
  if (const auto* const survey = std::get_if<v1::SurveyOutput>(&output)) {
    report.tile = TileRefOf(waves.survey().tile(report.cell), waves.scene().root);
    report.tile.set_digest(survey->digest());
    report.stamp = survey->stamp();
  }
  if (const auto* const assembled = std::get_if<v1::AssembleOutput>(&output)) report.written = *assembled;
}

void SceneVerification::AddReport(Report report, const std::string& scene) {
  if (!report.tile.path().empty())
    files_.AddTile(report.cell, report.worker, std::move(report.tile), std::move(report.stamp));
  files_.AddWritten({report.cell, std::move(report.worker), report.is_known, std::move(report.written)}, output_,
                    scene);
}

absl::StatusOr<std::optional<NewTask>> SceneVerification::Next(bool all) {
  TILEMEND_ASSIGN_OR_RETURN(std::optional<NewTask> task, results_.Next());
  if (!task) task = files_.Next(all);
  return task;
}

absl::Status SceneVerification::Take(const TaskResult& result) {
  TILEMEND_ASSIGN_OR_RETURN(caught_, results_.IsOut(result) ? results_.Take(result) : files_.Take(result));
  return absl::OkStatus();
}

}  // namespace tilemend
