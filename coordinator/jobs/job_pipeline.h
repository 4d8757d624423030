// What a job is made of: a pipeline turns its spec into tasks, takes their results and makes further tasks of them.
//
// The coordinator runs every call of one pipeline on one thread of its own, outside all locks: calls may be slow, and
// need no locking of their own. Only Cancel comes from another thread.
//
// Results come in any order and the order differs from run to run. A pipeline whose output must not depend on it keeps
// results by (stage, cell) and computes from whole sets.
//
// A coordinator that starts again runs the pipelines of its jobs again, from Start on. A task with the same cell, stage
// and input as one that was settled before gets that result. So a pipeline must not put into an input what differs from
// run to run (or its task is done again). The files that it wrote before must not trouble it.
#ifndef TILEMEND_COORDINATOR_JOBS_JOB_PIPELINE_H_
#define TILEMEND_COORDINATOR_JOBS_JOB_PIPELINE_H_

#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/grid/scene.h"
#include "common/util/stage.h"
#include "coordinator/jobs/job_folders.h"
#include "coordinator/state/job.h"
#include "coordinator/store/job_notes.h"
#include "tilemend/v1/job_spec.pb.h"

namespace tilemend {

class SceneSight;  // coordinator/report/scene_sight.h

// What is to be done: every option, checked (common/options/job_options.h).
using JobSpec = v1::JobSpec;

// The phase of a job that runs again through what it did before its coordinator ended.
inline constexpr char kResumePhase[] = "resume";
// All tiles are written, and files wait for their verification.
inline constexpr char kVerifyPhase[] = "verify";

// Why a job runs again through what it did before.
enum class Resumption {
  kRestart,     // of the coordinator
  kRevocation,  // of the results of a worker: what the job has kept for later jobs may be wrong
};

// What follows the input of a task and is a blob of its own, so that several tasks can have it.
struct InputPart {
  std::string digest;  // of its bytes (Sha256Hex)
  std::function<absl::StatusOr<std::string>()> read;
};

struct NewTask {
  CellId cell;
  Stage stage = Stage::kSurvey;
  std::string input;                    // bytes; they name the parts (common/rpc/input_parts.h)
  std::vector<std::string> avoid = {};  // workers that get the task only if no other may have it
  std::vector<InputPart> parts = {};
  std::string digest = {};  // of `input` (Sha256Hex); "" if not known

  void SetInput(std::string bytes) {
    input = std::move(bytes);
    digest.clear();
  }
};

// The bytes that a worker's stage gets: the input and its parts.
absl::StatusOr<std::string> WholeInput(const NewTask& task);

struct TaskResult {
  CellId cell;
  Stage stage = Stage::kSurvey;
  // Bytes, or why there are none: the error that the stage returned, or kAborted (QUARANTINED) for a task that was with
  // too many workers that died. Machine failures are retried before and do not come here.
  absl::StatusOr<std::string> output;
  std::string worker = {};  // who gave the output; "" if not known
  std::string input = {};   // digest of the bytes that the task was given (Sha256Hex)
  bool known = false;       // from the journal: given to an earlier pipeline of the job
  std::string digest = {};  // of the output; "" if not known
};

// A worker of which an accepted result turned out to be wrong.
struct CaughtWorker {
  std::string worker;
  std::string reason;  // for people
};

// A pipeline of very many tasks holds others back while so many are out and not done: each takes a record in the
// coordinator's memory, and mostly a file, and more than all workers can run is of no use.
inline constexpr int64_t kMostTasksOut = 8192;

// Who asked for a job, and its name in all logs (JobSpec says what).
struct JobOrigin {
  std::string owner;  // "" where nobody has a name
  std::string trace;  // 32 hexadecimal digits
};

struct JobOutcome {
  bool partial = false;                    // some holes or cells are left
  std::string message;                     // one line for people
  std::string report;                      // path of the report, "" if none was written
  std::vector<std::string> warnings = {};  // where there is no report to say them
};

class JobPipeline {
 public:
  virtual ~JobPipeline() = default;

  // What a worker must see to get tasks. Called once, first. Without any, every worker gets them.
  virtual absl::StatusOr<JobFolders> Folders() const { return JobFolders(); }

  // What may be shown of the scene, from before Start to long after the end. Called once, after Folders. Null: nothing.
  virtual std::shared_ptr<const SceneSight> Sight() const { return nullptr; }

  // `notes` are those of the job. `resumed` if the job began with another pipeline, perhaps in an earlier process.
  // Called once, before Start.
  virtual void Prepare(const std::shared_ptr<JobNotes>& /*notes*/, std::optional<Resumption> /*resumed*/) {}

  // The first tasks. Called once, then.
  virtual absl::StatusOr<std::vector<NewTask>> Start() = 0;

  // Takes one result, once for every task, and gives the tasks that it makes possible, in the order in which they
  // should run. An error here, in Start or in Finish fails the job with that status; a failed task alone does not.
  virtual absl::StatusOr<std::vector<NewTask>> OnTaskDone(TaskResult result) = 0;

  // The worker that the last OnTaskDone caught. The pipeline ends then, and the job begins again with another one, as
  // after a restart of the coordinator: the results of other workers are reused, those of this one are computed again.
  virtual std::optional<CaughtWorker> Caught() const { return std::nullopt; }

  // True when nothing is left but Finish. Must become true when all tasks that were given out are done: a job that is
  // not done and has no task left fails with kInternal.
  virtual bool Done() const = 0;

  virtual Progress GetProgress() const = 0;

  // Writes what is written at the end. Called once, last, unless the job failed or was cancelled. What it wrote is
  // complete only if no Cancel was taken.
  virtual absl::StatusOr<JobOutcome> Finish() = 0;

  // After Finish, once its outcome is durable: gives up what kept others from the output. Of a coordinator that ended
  // in between, the next one makes the pipeline anew and calls this alone.
  virtual void Release() {}

  // From another thread, at any time: the job is to be cancelled, a running call should return soon (with any status).
  // Nothing half-written may stay. False if it comes too late: then Finish has completed the output and succeeds.
  virtual bool Cancel() { return true; }
};

// Makes the pipeline of one job; runs on the job's thread, so it may read the scene. kNotFound, kInvalidArgument, ...
// fail the job. It returns soon, with any status, once a stop is requested.
using PipelineFactory =
    std::function<absl::StatusOr<std::unique_ptr<JobPipeline>>(const JobSpec&, const std::stop_token&)>;

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_JOB_PIPELINE_H_
