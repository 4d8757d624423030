// Where the results of tasks are in a journal of SQLite.
#ifndef TILEMEND_COORDINATOR_JOURNAL_SQLITE_RESULT_INDEX_H_
#define TILEMEND_COORDINATOR_JOURNAL_SQLITE_RESULT_INDEX_H_

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <vector>

#include "absl/container/flat_hash_map.h"
#include "coordinator/journal/journal.h"
#include "coordinator/journal/journal_rows.h"
#include "coordinator/journal/sqlite_database.h"

namespace tilemend {

// Numbers of rows of the table `result`. In memory: 24 bytes a result. Thread-safe; Find waits for no disk, but for
// ReadJob. Those that read throw SQLite::Exception.
class SqliteResultIndex {
 public:
  // The rows of these jobs. Returns the last number of all rows.
  int64_t ReadAll(const SQLite::Database& database, const std::set<int64_t>& jobs);
  // The rows of a job, in place of what is known of it. Cost O(all rows).
  void ReadJob(const SQLite::Database& database, int64_t job);
  void Forget(int64_t job);

  // The last row of the task.
  std::optional<int64_t> Find(int64_t job, const TaskName& task) const;
  // Rows whose output is a blob.
  std::vector<int64_t> BlobsOf(int64_t job) const;

 private:
  struct Rows {
    absl::flat_hash_map<NameBytes, int64_t> last;  // by name
    std::vector<int64_t> blobs;
  };
  static void Add(const SQLite::Statement& read, Rows& rows);

  mutable std::mutex mutex_;
  std::map<int64_t, Rows> jobs_;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOURNAL_SQLITE_RESULT_INDEX_H_
