#include "coordinator/journal/sqlite_result_index.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <utility>

#include "common/util/status_macros.h"

namespace tilemend {

absl::StatusOr<int64_t> SqliteResultIndex::ReadAll(SqliteDatabase& database, const std::set<int64_t>& jobs) {
  TILEMEND_ASSIGN_OR_RETURN(SqliteStatement read,
                            database.Prepare("SELECT number, job, name, inside, length(output) FROM result"));
  std::lock_guard<std::mutex> lock(mutex_);
  int64_t last = 0;
  while (true) {
    TILEMEND_ASSIGN_OR_RETURN(const bool is_there, read.Step());
    if (!is_there) return last;
    last = read.Int(0);
    if (jobs.contains(read.Int(1))) Add(read, jobs_[read.Int(1)]);
  }
}

absl::Status SqliteResultIndex::ReadJob(SqliteDatabase& database, int64_t job) {
  TILEMEND_ASSIGN_OR_RETURN(
      SqliteStatement read,
      database.Prepare("SELECT number, job, name, inside, length(output) FROM result WHERE job = ? ORDER BY number"));
  read.Bind(0, job);
  std::lock_guard<std::mutex> lock(mutex_);
  Rows& rows = jobs_[job] = {};
  while (true) {
    TILEMEND_ASSIGN_OR_RETURN(const bool is_there, read.Step());
    if (!is_there) return absl::OkStatus();
    Add(read, rows);
  }
}

// A row of a query for number, job, name, inside and the length of the output.
void SqliteResultIndex::Add(const SqliteStatement& read, Rows& rows) {
  NameBytes name{};
  // A name of another length is that of a damaged row, which nobody finds: its task is done again.
  std::memcpy(name.data(), read.Bytes(2).data(), std::min(name.size(), read.Bytes(2).size()));
  rows.last[name] = read.Int(0);
  if (read.Int(3) == 0 && read.Int(4) > 0) rows.blobs.push_back(read.Int(0));
}

void SqliteResultIndex::Forget(int64_t job) {
  std::lock_guard<std::mutex> lock(mutex_);
  jobs_.erase(job);
}

std::optional<int64_t> SqliteResultIndex::Find(int64_t job, const TaskName& task) const {
  NameBytes name;
  std::memcpy(name.data(), NameOf(task).data(), name.size());
  std::lock_guard<std::mutex> lock(mutex_);
  const auto rows = jobs_.find(job);
  if (rows == jobs_.end()) return std::nullopt;
  const auto found = rows->second.last.find(name);
  return found == rows->second.last.end() ? std::nullopt : std::optional(found->second);
}

std::vector<int64_t> SqliteResultIndex::BlobsOf(int64_t job) const {
  std::lock_guard<std::mutex> lock(mutex_);
  const auto rows = jobs_.find(job);
  return rows == jobs_.end() ? std::vector<int64_t>() : rows->second.blobs;
}

}  // namespace tilemend
