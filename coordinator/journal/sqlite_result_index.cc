#include "coordinator/journal/sqlite_result_index.h"

#include <algorithm>
#include <cstring>
#include <string_view>

namespace tilemend {

int64_t SqliteResultIndex::ReadAll(const SQLite::Database& database, const std::set<int64_t>& jobs) {
  SQLite::Statement read(database, "SELECT number, job, name, inside, length(output) FROM result");
  std::lock_guard<std::mutex> lock(mutex_);
  int64_t last = 0;
  while (read.executeStep()) {
    last = IntOf(read, 0);
    if (jobs.contains(IntOf(read, 1))) Add(read, jobs_[IntOf(read, 1)]);
  }
  return last;
}

void SqliteResultIndex::ReadJob(const SQLite::Database& database, int64_t job) {
  SQLite::Statement read(database,
                         "SELECT number, job, name, inside, length(output) FROM result WHERE job = ? ORDER BY number");
  With(read, job);
  std::lock_guard<std::mutex> lock(mutex_);
  Rows& rows = jobs_[job] = {};
  while (read.executeStep()) Add(read, rows);
}

// A row of a query for number, job, name, inside and the length of the output.
void SqliteResultIndex::Add(const SQLite::Statement& read, Rows& rows) {
  NameBytes name{};
  // A name of another length is that of a damaged row, which nobody finds: its task is done again.
  const std::string_view bytes = BytesOf(read, 2);
  std::memcpy(name.data(), bytes.data(), std::min(name.size(), bytes.size()));
  rows.last[name] = IntOf(read, 0);
  if (IntOf(read, 3) == 0 && IntOf(read, 4) > 0) rows.blobs.push_back(IntOf(read, 0));
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
