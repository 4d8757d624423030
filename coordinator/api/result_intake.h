// Results that workers report: looked at, then taken or refused.
#ifndef TILEMEND_COORDINATOR_API_RESULT_INTAKE_H_
#define TILEMEND_COORDINATOR_API_RESULT_INTAKE_H_

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "coordinator/jobs/cluster.h"
#include "coordinator/jobs/state_updates.h"
#include "coordinator/state/event.h"
#include "coordinator/store/blob_folder.h"
#include "tilemend/v1/work.pb.h"

namespace tilemend {

class ResultIntake {
 public:
  // A result as it came, made ready without the lock.
  struct Report {
    v1::TaskRef ref;
    Stage stage;
    Event event;  // TaskCompleted or TaskFailed
    std::optional<std::string> content;
    std::string refusal = {};  // why the result is not taken, for people; else empty
    bool held = false;         // the worker held the task when its report came; else nobody looked at the result
    std::vector<std::string> files = {};  // that its attempt wrote
  };
  // Files of an attempt whose result was not accepted.
  struct Discarded {
    std::string attempts;  // their folder
    std::vector<std::string> files;
  };

  // Both must outlive this.
  ResultIntake(Cluster& cluster, StateUpdates& updates) : cluster_(cluster), updates_(updates) {}

  // Checks the results that a call brings, and takes their content from it. Without the lock: it reads files.
  std::vector<Report> Prepare(v1::SyncRequest& request);
  // Takes what was prepared, and acknowledges it in `response`. Needs the lock.
  std::vector<Discarded> Take(const std::string& worker, std::vector<Report> reports, v1::SyncResponse& response);
  // Deletes them. Without the lock: large files take long.
  static void Remove(const std::vector<Discarded>& discarded);

 private:
  // What a worker holds.
  struct Holding {
    CellId cell;
    Stage stage;
    std::string input;  // digest
    std::shared_ptr<BlobFolder> blobs;
    bool queue_full = false;
  };
  Report PrepareReport(const std::string& worker, v1::FinishedTask& finished);
  std::optional<Holding> HoldingOf(const std::string& worker, const v1::TaskRef& ref);  // takes the lock
  void PrepareOutput(const std::string& worker, const Holding& lease, v1::BlobRef& output, Report& report);
  absl::Status KeepOutput(const Holding& lease, v1::BlobRef& output, Report& report) const;
  absl::Status CheckOutput(const Holding& lease, const v1::BlobRef& output) const;
  bool TakeReport(const std::string& worker, Report& report);

  Cluster& cluster_;
  StateUpdates& updates_;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_API_RESULT_INTAKE_H_
