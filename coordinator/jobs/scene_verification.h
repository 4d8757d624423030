// What workers verify of a scene's job, and who is caught.
#ifndef TILEMEND_COORDINATOR_JOBS_SCENE_VERIFICATION_H_
#define TILEMEND_COORDINATOR_JOBS_SCENE_VERIFICATION_H_

#include <memory>
#include <optional>
#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "coordinator/jobs/job_pipeline.h"
#include "coordinator/jobs/output_verification.h"
#include "coordinator/jobs/result_recomputation.h"
#include "coordinator/jobs/stage_output.h"
#include "coordinator/store/job_notes.h"
#include "coordinator/store/scratch_file.h"
#include "coordinator/waves/scene_waves.h"

namespace tilemend {

// What other workers verify before the report; shares from 0 to 1.
struct VerifiedShares {
  double files = 0;    // that workers write, and tiles that they read (output_verification.h)
  double results = 0;  // of tasks that are computed again (result_recomputation.h)
};

// Not thread-safe.
class SceneVerification {
 public:
  // `output` is the output's folder; empty: nothing is verified.
  SceneVerification(VerifiedShares shares, std::string output, std::shared_ptr<ScratchFile> scratch);
  // Before anything is added: what was verified before is not verified again, and the same is chosen as before.
  void UseNotes(const std::shared_ptr<JobNotes>& notes);

  // Before a task is given out. Errors of ScratchFile::Put.
  absl::Status AddTask(const NewTask& task) { return results_.AddTask(task); }
  // The result of a task that is not of stage kVerify. If it failed because a tile seems to have changed, looks for a
  // worker that reported a wrong digest of it.
  void AddResult(const TaskResult& result);
  // What the result says of files: of the tile that was surveyed, of those that were written.
  struct Report {
    CellId cell;
    std::string worker;
    bool is_known = false;  // from the journal
    v1::TileRef tile = {};
    std::string stamp = {};
    v1::AssembleOutput written = {};
  };
  static Report ReportOf(const TaskResult& result) { return {result.cell, result.worker, result.known}; }
  static void ReadOutput(const StageOutput& output, const SceneWaves& waves, Report& report);
  // Once its files have their names.
  void AddReport(Report report, const std::string& scene);

  // A task to give out now, with `all` also one that could grow. Errors of ScratchFile::Get.
  absl::StatusOr<std::optional<NewTask>> Next(bool all);
  // The result of such a task. Errors of OutputVerification and ResultRecomputation.
  absl::Status Take(const TaskResult& result);

  // By the last result.
  const std::optional<CaughtWorker>& caught() const { return caught_; }
  bool is_wanted() const { return is_wanted_; }  // some share is verified
  bool is_over() const { return files_.is_over() && results_.is_over(); }

 private:
  const std::string output_;
  const bool is_wanted_;
  OutputVerification files_;
  ResultRecomputation results_;
  std::optional<CaughtWorker> caught_;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_SCENE_VERIFICATION_H_
