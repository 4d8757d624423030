// Verification of files by other workers than those that reported their digests.
#ifndef TILEMEND_COORDINATOR_JOBS_OUTPUT_VERIFICATION_H_
#define TILEMEND_COORDINATOR_JOBS_OUTPUT_VERIFICATION_H_

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/store/file_receipt.h"
#include "coordinator/jobs/job_pipeline.h"
#include "coordinator/jobs/random_share.h"
#include "coordinator/store/job_notes.h"
#include "tilemend/v1/stages.pb.h"
#include "tilemend/v1/verify.pb.h"

namespace tilemend {

// Workers report digests of the tiles that they survey and of the files that they write. Another worker reads these
// files again, in tasks of several files that one worker reported. The coordinator compares both digests and both
// receipts with what it sees of the file, without reading it. It reads a file itself only if they disagree or no worker
// could read it. Then it decides which worker is wrong.
//
//   verification.AddWritten(...), verification.AddTile(...);
//   while (std::optional<NewTask> task = verification.Next(/*all=*/false)) ...;
//   verification.Take(...);  // once for each task
//
// Not thread-safe. Memory: about 300 bytes for each file until it is verified, and
// 200 bytes for each tile.
class OutputVerification {
 public:
  // `share` of the files is verified, 0 to 1.
  explicit OutputVerification(double share);
  // Before anything is added: `notes` tells which files were verified before, `key` is that of the share. With the same
  // key the same files are chosen.
  void UseNotes(std::shared_ptr<JobNotes> notes, uint64_t key);
  // Files that were written for a cell.
  struct Written {
    CellId cell;
    std::string worker;     // "" if not known, here and below
    bool is_known = false;  // from the journal: the files may have changed since
    v1::AssembleOutput files;
  };
  // The files have their final names in `output`. Carried files are compared with those of the scene's folder.
  void AddWritten(const Written& written, const std::string& output, const std::string& scene);
  // A tile with the digest that `worker` reported. `stamp` is that of its files before they were read; may be empty.
  void AddTile(CellId cell, const std::string& worker, v1::TileRef tile, std::string stamp);

  // A task to give out now: a full one, or with `all` any that is left.
  std::optional<NewTask> Next(bool all);

  // Takes the result of a task. Returns the worker that reported a wrong digest, if there is one. kAborted
  // (OUTPUT_CHANGED) if a file changed since it was written, kAborted if a tile changed since it was surveyed,
  // kInternal for a task that was not given out.
  absl::StatusOr<std::optional<CaughtWorker>> Take(const TaskResult& result);

  // The worker that reported the digest of the tile of the cell, or of one beside it, if that digest is wrong and the
  // tile did not change. Reads these tiles.
  std::optional<CaughtWorker> WhoIsWrongNear(CellId cell) const;

  // Whether everything that was added is verified.
  bool is_over() const { return waiting_.empty() && full_.empty() && out_.empty(); }

 private:
  struct Target {
    CellId cell;
    std::string digest;
    std::string path = {};      // of a file of the output; empty: the tile of the cell
    FileReceipt receipt = {};   // of `path`, as expected
    std::string original = {};  // the scene's file, if it was carried
    bool is_tile = false;       // its digest is that of the survey
    // The digest of a carried tile comes from its survey. That of another carried file comes from its writer alone.
    bool ComparesOriginal() const { return !original.empty() && !is_tile; }
  };
  struct Doubt {
    const Target* target;
    bool is_contradicted;  // a worker read the file and found another digest; else no worker could tell
  };
  struct Comparison {
    std::vector<Doubt> doubts;
    std::vector<std::string> notes;  // of all targets, as they are now
  };
  struct Batch {
    std::string told_by;
    std::vector<Target> targets;
    int64_t bytes = 0;
  };
  struct Surveyed {
    const std::string* worker;  // one of workers_
    v1::TileRef tile;
    std::string stamp;
  };
  void Add(const std::string& worker, Target target, int64_t bytes);
  std::string PathOf(const Target& target) const;
  NewTask TaskOf(const Batch& batch);
  // With what a worker read; null: it could not.
  Comparison Compare(const Batch& batch, const v1::VerifyOutput* output) const;
  // Reads the file and decides whether `told_by` is wrong. Errors of Take.
  absl::StatusOr<std::optional<CaughtWorker>> Judge(const std::string& told_by, const Target& target) const;

  RandomShare share_;
  std::shared_ptr<JobNotes> notes_ = std::make_shared<JobNotes>();
  std::map<std::string, Batch> waiting_;  // by who reported
  std::deque<Batch> full_;
  std::map<std::string, Batch> out_;  // given out, by the digest of the input of the task
  std::set<std::string> workers_;     // that surveyed tiles
  std::map<CellId, Surveyed> surveyed_;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_OUTPUT_VERIFICATION_H_
