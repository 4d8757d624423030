#include "coordinator/journal/sqlite_journal.h"

#include <algorithm>
#include <deque>
#include <mutex>
#include <set>
#include <utility>
#include <variant>

#include "absl/container/flat_hash_map.h"
#include "absl/strings/str_cat.h"
#include "common/store/digest.h"
#include "common/util/failpoint.h"
#include "common/util/status_macros.h"
#include "coordinator/journal/committed_journal.h"
#include "coordinator/journal/group_commit.h"
#include "coordinator/journal/journal_rows.h"
#include "coordinator/journal/sqlite_journal_file.h"
#include "coordinator/journal/sqlite_result_index.h"

namespace tilemend {
namespace {

constexpr int64_t kMostPages = 1000;     // given back to the disk in one transaction
constexpr int64_t kMostExamined = 2000;  // rows looked at in one transaction: some milliseconds
constexpr int64_t kPageRows = 64;        // results read at once: they are asked for much as they were put
constexpr size_t kMostPagesRead = 16;    // of such

class SqliteJournal : public CommittedJournal {
 public:
  SqliteJournal(std::string path, SqliteDatabase database) : path_(std::move(path)), database_(std::move(database)) {}
  // Reads what there is and starts the writer.
  absl::Status Start();

  absl::StatusOr<std::optional<ResultRecord>> Find(int64_t job, const TaskName& task) override;
  absl::StatusOr<std::vector<std::string>> Outputs(int64_t job) override;
  absl::Status ReadAgain(int64_t job) override;

 private:
  GroupCommit& Writer() override { return *writer_; }

  absl::Status Prepare();
  absl::Status NextEpoch();
  absl::Status ReadJobs();
  absl::Status ReadSetAside();
  // A result as it was put, and its content if that is inside.
  struct StoredResult {
    ResultRow row;
    std::string sum;
    std::string content;
  };
  absl::StatusOr<const StoredResult*> Read(int64_t number);  // with database_mutex_ held
  absl::Status ReadPage(int64_t page);
  absl::Status Damaged(const std::string& what) const {
    return absl::DataLossError(absl::StrCat(path_, ": ", what, " is damaged"));
  }

  void Commit(const std::vector<JournalPut>& puts);  // here and below with database_mutex_ held
  absl::Status Insert(const JobRecord& job);
  absl::Status Insert(const NewResult& put);
  absl::Status Insert(const OldJob& job);
  absl::Status Insert(const SetAsideRecord& aside);
  absl::Status Insert(const FalseResults& results);
  bool TidyUp();  // a little of it; false if there is nothing left to do
  void DeleteOldResults();
  void Shrink();

  const std::string path_;

  std::mutex database_mutex_;
  SqliteDatabase database_;
  std::optional<SqliteStatement> put_job_, put_result_, put_content_, get_results_, next_results_, delete_result_,
      delete_content_, delete_job_, put_aside_, delete_aside_, free_pages_;
  absl::flat_hash_map<int64_t, std::vector<StoredResult>> pages_;  // read, by number / kPageRows
  std::deque<int64_t> pages_read_;                                 // the oldest first
  SqliteResultIndex index_;                                        // of the jobs that are not over
  std::set<int64_t> running_;                                      // those jobs
  int64_t last_number_ = 0;                                        // of a row of `result`
  bool is_log_empty_ = true;
  bool has_old_results_ = true;          // perhaps
  int64_t tidy_from_ = 0;                // row
  std::unique_ptr<GroupCommit> writer_;  // last: it uses the others
};

absl::Status SqliteJournal::Start() {
  TILEMEND_RETURN_IF_ERROR(Prepare());
  TILEMEND_RETURN_IF_ERROR(ReadJobs());
  TILEMEND_ASSIGN_OR_RETURN(last_number_, index_.ReadAll(database_, running_));
  TILEMEND_RETURN_IF_ERROR(ReadSetAside());
  TILEMEND_RETURN_IF_ERROR(NextEpoch());
  writer_ = std::make_unique<GroupCommit>(
      [this](const std::vector<JournalPut>& puts) {
        std::lock_guard<std::mutex> lock(database_mutex_);
        Commit(puts);
      },
      [this] {
        std::lock_guard<std::mutex> lock(database_mutex_);
        return TidyUp();
      });
  return absl::OkStatus();
}

absl::Status SqliteJournal::Prepare() {
  const auto prepare = [this](std::optional<SqliteStatement>& statement, const char* sql) -> absl::Status {
    TILEMEND_ASSIGN_OR_RETURN(SqliteStatement prepared, database_.Prepare(sql));
    statement.emplace(std::move(prepared));
    return absl::OkStatus();
  };
  TILEMEND_RETURN_IF_ERROR(prepare(put_job_, "INSERT OR REPLACE INTO job VALUES(?,?,?,?,?,?)"));
  TILEMEND_RETURN_IF_ERROR(prepare(put_result_, "INSERT INTO result VALUES(?,?,?,?,?,?,?,?,?)"));
  TILEMEND_RETURN_IF_ERROR(prepare(put_content_, "INSERT INTO content VALUES(?,?)"));
  TILEMEND_RETURN_IF_ERROR(
      prepare(get_results_,
              "SELECT number, job, name, state, output, inside, error, lost_workers, sum, bytes "
              "FROM result LEFT JOIN content ON content.result = number WHERE number BETWEEN ? AND ? ORDER BY number"));
  TILEMEND_RETURN_IF_ERROR(
      prepare(next_results_, "SELECT number, job FROM result WHERE number > ? ORDER BY number LIMIT ?"));
  TILEMEND_RETURN_IF_ERROR(prepare(delete_job_, "DELETE FROM job WHERE number = ?"));
  TILEMEND_RETURN_IF_ERROR(prepare(put_aside_, "INSERT OR REPLACE INTO aside VALUES(?,?,?)"));
  TILEMEND_RETURN_IF_ERROR(prepare(delete_aside_, "DELETE FROM aside WHERE worker = ?"));
  TILEMEND_RETURN_IF_ERROR(prepare(delete_result_, "DELETE FROM result WHERE number = ?"));
  TILEMEND_RETURN_IF_ERROR(prepare(free_pages_, "PRAGMA freelist_count"));
  return prepare(delete_content_, "DELETE FROM content WHERE result = ?");
}

absl::Status SqliteJournal::NextEpoch() {
  TILEMEND_RETURN_IF_ERROR(database_.Run("UPDATE epoch SET value = value + 1"));
  TILEMEND_ASSIGN_OR_RETURN(SqliteStatement read, database_.Prepare("SELECT value FROM epoch"));
  TILEMEND_ASSIGN_OR_RETURN(const bool is_there, read.Step());
  if (!is_there || read.Int(0) < 1 || read.Int(0) > UINT32_MAX) return Damaged("its epoch");
  epoch_ = static_cast<uint32_t>(read.Int(0));
  is_log_empty_ = false;
  return absl::OkStatus();
}

absl::Status SqliteJournal::ReadJobs() {
  TILEMEND_ASSIGN_OR_RETURN(
      SqliteStatement read,
      database_.Prepare("SELECT number, request_id, body, over, released, sum FROM job ORDER BY number"));
  while (true) {
    TILEMEND_ASSIGN_OR_RETURN(const bool is_there, read.Step());
    if (!is_there) return absl::OkStatus();
    JobRecord job{read.Int(0), std::string(read.Bytes(1)), std::string(read.Bytes(2)), read.Int(3) != 0,
                  read.Int(4) != 0};
    job.damaged = SumOfJob(job) != read.Bytes(5);
    if (!job.over) running_.insert(job.number);
    jobs_.push_back(std::move(job));
  }
}

absl::Status SqliteJournal::ReadSetAside() {
  TILEMEND_ASSIGN_OR_RETURN(SqliteStatement read, database_.Prepare("SELECT worker, reason, sum FROM aside"));
  while (true) {
    TILEMEND_ASSIGN_OR_RETURN(const bool is_there, read.Step());
    if (!is_there) return absl::OkStatus();
    SetAsideRecord aside{std::string(read.Bytes(0)), std::string(read.Bytes(1))};
    // One that is damaged is not worth more than that the worker is tried again.
    if (SumOfAside(aside) == read.Bytes(2)) set_aside_.push_back(std::move(aside));
  }
}

absl::StatusOr<const SqliteJournal::StoredResult*> SqliteJournal::Read(int64_t number) {
  const int64_t page = number / kPageRows;
  if (!pages_.contains(page)) TILEMEND_RETURN_IF_ERROR(ReadPage(page));
  const std::vector<StoredResult>& results = pages_.at(page);
  const auto result = std::partition_point(results.begin(), results.end(),
                                           [&](const StoredResult& r) { return r.row.number < number; });
  const bool is_there = result != results.end() && result->row.number == number;
  if (is_there && result->row.Sum() == result->sum) return &*result;
  return Damaged(absl::StrCat("result ", number));
}

absl::Status SqliteJournal::ReadPage(int64_t page) {
  std::vector<StoredResult> results;
  get_results_->Bind(0, page * kPageRows).Bind(1, (page + 1) * kPageRows - 1);
  while (true) {
    TILEMEND_ASSIGN_OR_RETURN(const bool is_there, get_results_->Step());
    if (!is_there) break;
    const SqliteStatement& read = *get_results_;
    results.push_back({{read.Int(0), read.Int(1), std::string(read.Bytes(2)), read.Int(3), std::string(read.Bytes(4)),
                        read.Int(5), std::string(read.Bytes(6)), std::string(read.Bytes(7))},
                       std::string(read.Bytes(8)),
                       std::string(read.Bytes(9))});
  }
  if (pages_.size() >= kMostPagesRead) {
    pages_.erase(pages_read_.front());
    pages_read_.pop_front();
  }
  pages_read_.push_back(page);
  pages_[page] = std::move(results);
  return absl::OkStatus();
}

absl::StatusOr<std::optional<ResultRecord>> SqliteJournal::Find(int64_t job, const TaskName& task) {
  const std::optional<int64_t> number = index_.Find(job, task);  // which waits for no disk
  if (!number) return std::nullopt;
  std::lock_guard<std::mutex> lock(database_mutex_);
  TILEMEND_ASSIGN_OR_RETURN(const StoredResult* const stored, Read(*number));
  const ResultRow& row = stored->row;
  ResultRecord result{static_cast<TaskState>(row.state), row.output, std::nullopt, row.error, {}};
  SetWorkers(row.lost_workers, result);
  if (row.inside == 0) return result;
  if (Sha256Hex(stored->content) != row.output) return Damaged(absl::StrCat("the output of result ", row.number));
  result.content = stored->content;
  return result;
}

absl::StatusOr<std::vector<std::string>> SqliteJournal::Outputs(int64_t job) {
  std::vector<std::string> outputs;
  std::lock_guard<std::mutex> lock(database_mutex_);
  for (const int64_t number : index_.BlobsOf(job)) {
    TILEMEND_ASSIGN_OR_RETURN(const StoredResult* const stored, Read(number));
    outputs.push_back(stored->row.output);
  }
  return outputs;
}

absl::Status SqliteJournal::ReadAgain(int64_t job) {
  Await();
  std::lock_guard<std::mutex> lock(database_mutex_);
  pages_.clear();  // the last one may have had room
  pages_read_.clear();
  return index_.ReadJob(database_, job);
}

void SqliteJournal::Commit(const std::vector<JournalPut>& puts) {
  RequireOfJournal(database_.Run("BEGIN IMMEDIATE"));
  for (const JournalPut& put : puts) {
    RequireOfJournal(std::visit([this](const auto& p) { return Insert(p); }, put));
  }
  if (FailPoint("journal.commit"))
    EndForJournal(absl::InternalError(absl::StrCat(path_, ": a sync failed (injected)")));
  RequireOfJournal(database_.Run("COMMIT"));
  RequireOfJournal(database_.CheckInPlace());
  FailPoint("journal.committed");
  is_log_empty_ = false;
}

absl::Status SqliteJournal::Insert(const JobRecord& job) {
  if (job.over) {
    running_.erase(job.number);
    index_.Forget(job.number);
    has_old_results_ = true;
    tidy_from_ = 0;
  } else {
    running_.insert(job.number);
  }
  const std::string sum = SumOfJob(job);
  return put_job_->Bind(0, job.number)
      .Bind(1, job.request_id)
      .Bind(2, job.body)
      .Bind(3, int64_t{job.over})
      .Bind(4, int64_t{job.released})
      .Bind(5, sum)
      .Run();
}

absl::Status SqliteJournal::Insert(const NewResult& put) {
  const ResultRecord& result = put.result;
  const ResultRow row{++last_number_,   put.job,
                      NameOf(put.task), static_cast<int64_t>(result.state),
                      result.output,    result.content.has_value() ? 1 : 0,
                      result.error,     WorkersOf(result)};
  const std::string sum = row.Sum();
  TILEMEND_RETURN_IF_ERROR(put_result_->Bind(0, row.number)
                               .Bind(1, row.job)
                               .Bind(2, row.name)
                               .Bind(3, row.state)
                               .Bind(4, row.output)
                               .Bind(5, row.inside)
                               .Bind(6, row.error)
                               .Bind(7, row.lost_workers)
                               .Bind(8, sum)
                               .Run());
  if (!result.content.has_value()) return absl::OkStatus();
  return put_content_->Bind(0, row.number).Bind(1, *result.content).Run();
}

absl::Status SqliteJournal::Insert(const FalseResults& results) {
  constexpr char kWhich[] = "FROM result WHERE job = ? AND lost_workers = ? AND state = ?";
  for (const std::string& sql : {absl::StrCat("DELETE FROM content WHERE result IN (SELECT number ", kWhich, ")"),
                                 absl::StrCat("DELETE ", kWhich)}) {
    TILEMEND_ASSIGN_OR_RETURN(SqliteStatement drop, database_.Prepare(sql));
    drop.Bind(0, results.job).Bind(1, results.worker).Bind(2, static_cast<int64_t>(TaskState::kCommitted));
    TILEMEND_RETURN_IF_ERROR(drop.Run());
  }
  return absl::OkStatus();
}

absl::Status SqliteJournal::Insert(const OldJob& job) { return delete_job_->Bind(0, job.number).Run(); }

absl::Status SqliteJournal::Insert(const SetAsideRecord& aside) {
  if (aside.reason.empty()) return delete_aside_->Bind(0, aside.worker).Run();
  const std::string sum = SumOfAside(aside);
  return put_aside_->Bind(0, aside.worker).Bind(1, aside.reason).Bind(2, sum).Run();
}

bool SqliteJournal::TidyUp() {
  if (!has_old_results_ && is_log_empty_) return false;
  has_old_results_ ? DeleteOldResults() : Shrink();
  return true;
}

void SqliteJournal::DeleteOldResults() {
  std::vector<int64_t> old;
  int64_t looked_at = 0;
  next_results_->Bind(0, tidy_from_).Bind(1, kMostExamined);
  while (RequireOfJournal(next_results_->Step())) {
    ++looked_at;
    tidy_from_ = next_results_->Int(0);
    if (!running_.contains(next_results_->Int(1))) old.push_back(tidy_from_);
  }
  has_old_results_ = looked_at == kMostExamined;
  if (old.empty()) return;
  RequireOfJournal(database_.Run("BEGIN IMMEDIATE"));
  for (const int64_t number : old) {
    RequireOfJournal(delete_result_->Bind(0, number).Run());
    RequireOfJournal(delete_content_->Bind(0, number).Run());
  }
  FailPoint("journal.tidy");
  RequireOfJournal(database_.Run("COMMIT"));
  is_log_empty_ = false;
}

void SqliteJournal::Shrink() {
  RequireOfJournal(database_.Run(absl::StrCat("PRAGMA incremental_vacuum(", kMostPages, ")")));
  RequireOfJournal(database_.Run("PRAGMA wal_checkpoint(TRUNCATE)"));
  FailPoint("journal.checkpointed");
  RequireOfJournal(free_pages_->Step());
  is_log_empty_ = free_pages_->Int(0) == 0;
  free_pages_->Reset();
}

}  // namespace

absl::StatusOr<std::unique_ptr<Journal>> OpenSqliteJournal(const std::string& path) {
  TILEMEND_ASSIGN_OR_RETURN(SqliteDatabase database, OpenJournalFile(path));
  auto journal = std::make_unique<SqliteJournal>(path, std::move(database));
  TILEMEND_RETURN_IF_ERROR(journal->Start());
  return journal;
}

}  // namespace tilemend
