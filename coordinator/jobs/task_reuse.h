// Takes over results that earlier jobs left with an output, and leaves those of this one.
#ifndef TILEMEND_COORDINATOR_JOBS_TASK_REUSE_H_
#define TILEMEND_COORDINATOR_JOBS_TASK_REUSE_H_

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "absl/status/status.h"
#include "common/grid/scene.h"
#include "common/util/stage.h"
#include "coordinator/jobs/job_pipeline.h"
#include "coordinator/jobs/stage_output.h"
#include "coordinator/store/result_log.h"

namespace tilemend {

// A result is known by this build of the program, the stage and the task's input, which holds all that the result
// depends on:
//  - sample, fill: the result is taken without a worker.
//  - measure: never, since the input names the tile, not its content.
//  - survey: the input names the tile, not its content. A worker is told what the result was made from; it reads these
//    files, and makes the survey only if one of them has changed.
//  - assemble: a worker is told which files there were, reads them, and writes only if one is not as it was written.
// So what counts is content alone, never a time or a size. Not thread-safe.
class TaskReuse {
 public:
  // Without a log nothing is taken over, and nothing left.
  explicit TaskReuse(std::optional<ResultLog> log) : log_(std::move(log)) {}

  // Call for each task before it is given out, with a number that tells it from others of its cell and stage. The
  // result, if it needs no worker; else it may add to the task's input what is known.
  std::optional<StageResult> Recall(NewTask& task, int32_t number);
  // Call for each of the others with its result, which becomes the known one if the worker found it true. Returns
  // kAborted if that is not there any more.
  absl::Status Resolve(StageResult& result, int32_t number);
  // Call then, when the result has been taken. `digest` as of ResultLog::Put. kResourceExhausted, kUnavailable.
  absl::Status Keep(CellId cell, Stage stage, int32_t number, const std::string& bytes, const std::string& digest = "");
  // The job ended before it wrote anything, and its end was that of its input: leaves nothing either.
  void Discard();
  // The job is complete: forgets what it had no use for.
  absl::Status Finish();

  int64_t tasks() const { return tasks_; }  // so far
  int64_t taken_over() const { return taken_over_; }
  int64_t without_worker() const { return without_worker_; }  // of these: Recall gave the result
  int64_t tiles() const { return tiles_; }                    // that were to be written
  int64_t tiles_kept() const { return tiles_kept_; }          // of these: they lay there as they are to be

 private:
  using Name = std::tuple<CellId, Stage, int32_t>;

  std::optional<ResultLog> log_;
  std::map<Name, std::string> keys_;  // of the tasks that are given out
  int64_t tasks_ = 0, taken_over_ = 0, without_worker_ = 0, tiles_ = 0, tiles_kept_ = 0;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_TASK_REUSE_H_
