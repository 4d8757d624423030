// Results of workers, computed again by other workers.
#ifndef TILEMEND_COORDINATOR_JOBS_RESULT_RECOMPUTATION_H_
#define TILEMEND_COORDINATOR_JOBS_RESULT_RECOMPUTATION_H_

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "coordinator/jobs/job_pipeline.h"
#include "coordinator/jobs/random_share.h"
#include "coordinator/store/job_notes.h"
#include "coordinator/store/scratch_file.h"

namespace tilemend {

// A worker that gives plausible but wrong results (heights 100 m up, a survey without its images) passes every check of
// a single result. So a share of the tasks is computed again by a second worker. Results are the same on all workers:
// if they differ, a third worker computes the task, and the one that differs from both others is caught.
//
// Files are the matter of OutputVerification: no task of stage ASSEMBLE is computed again. Not thread-safe.
class ResultRecomputation {
 public:
  // `share` of the tasks is computed again, 0 to 1. Their inputs lie in `scratch`.
  ResultRecomputation(double share, std::shared_ptr<ScratchFile> scratch);
  // Before anything is added: `notes` tells which results were computed again before, `key` is that of the share.
  void UseNotes(std::shared_ptr<JobNotes> notes, uint64_t key);

  // A task that is about to be given out. Errors of ScratchFile::Put.
  absl::Status AddTask(const NewTask& task);
  // The result of such a task.
  void AddResult(const TaskResult& result);

  // A task to give out now. Errors of ScratchFile::Get.
  absl::StatusOr<std::optional<NewTask>> Next();
  // Whether the result is of such a task.
  bool IsOut(const TaskResult& result) const { return out_.contains(result.input); }
  // Takes it. Returns the worker whose result is wrong, if there is one. kAborted (RESULTS_DIFFER) if results differ
  // and no third worker could decide. Precondition: IsOut.
  absl::StatusOr<std::optional<CaughtWorker>> Take(const TaskResult& result);

  // Whether every result that was added is computed again.
  bool is_over() const { return waiting_.empty() && out_.empty(); }

 private:
  struct Opinion {
    std::string worker;
    std::string digest;  // ResultDigest
  };
  struct Computed {
    CellId cell;
    Stage stage = Stage::kSurvey;
    ScratchFile::Place input;
    std::string note;               // once there is a result: that another worker came to the same
    std::vector<Opinion> opinions;  // the first is that of the result, then those of the workers that computed it again
  };
  absl::StatusOr<std::optional<CaughtWorker>> Decide(const Computed& computed) const;

  RandomShare share_;
  const std::shared_ptr<ScratchFile> scratch_;
  std::shared_ptr<JobNotes> notes_ = std::make_shared<JobNotes>();
  std::map<std::string, Computed> chosen_;  // without a result yet, by the digest of the input
  std::deque<Computed> waiting_;
  std::map<std::string, Computed> out_;  // given out, by the digest of the input of the task that verifies
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_RESULT_RECOMPUTATION_H_
