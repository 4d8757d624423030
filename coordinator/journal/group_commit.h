// Puts that wait to be durable, and the thread that makes them so: as many at once as have come.
#ifndef TILEMEND_COORDINATOR_JOURNAL_GROUP_COMMIT_H_
#define TILEMEND_COORDINATOR_JOURNAL_GROUP_COMMIT_H_

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <thread>
#include <variant>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "coordinator/journal/journal.h"

namespace tilemend {

struct NewResult {
  int64_t job = 0;
  TaskName task;
  ResultRecord result;
};
struct OldJob {
  int64_t number = 0;
};
struct FalseResults {
  int64_t job = 0;
  std::string worker;
};
using JournalPut = std::variant<JobRecord, NewResult, OldJob, SetAsideRecord, FalseResults>;

// Ends the process with kExitRetryable. There is no going on: what was put has taken effect in memory, and whether it
// is on the disk nobody can know. A sync that is tried again may succeed without having written what the first one
// lost.
[[noreturn]] void EndForJournal(const absl::Status& status);

inline void RequireOfJournal(const absl::Status& status) {
  if (!status.ok()) EndForJournal(status);
}
template <class T>
T RequireOfJournal(absl::StatusOr<T> value) {
  RequireOfJournal(value.status());
  return *std::move(value);
}

// Thread-safe.
class GroupCommit {
 public:
  // Both are called on the writer's thread. `commit` makes puts durable, in order, or ends the process. `tidy`, when
  // nothing was put for a while, does a little of what can wait, and gives false if nothing is left of it.
  GroupCommit(std::function<void(std::vector<JournalPut>)> commit, std::function<bool()> tidy);
  // What was put is committed before.
  ~GroupCommit();
  GroupCommit(const GroupCommit&) = delete;
  GroupCommit& operator=(const GroupCommit&) = delete;

  void Put(JournalPut put);
  // Waits until all that was put before is committed.
  void Await();

 private:
  void Write();

  const std::function<void(std::vector<JournalPut>)> commit_;
  const std::function<bool()> tidy_;
  std::mutex mutex_;
  std::condition_variable queued_, committed_;
  std::vector<JournalPut> queue_;
  uint64_t put_ = 0, durable_ = 0;
  bool ending_ = false;
  std::thread writer_;  // last: it uses the others
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOURNAL_GROUP_COMMIT_H_
