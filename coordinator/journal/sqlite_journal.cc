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

// Prepared once.
struct JournalStatements {
  explicit JournalStatements(const SQLite::Database& opened) : database(opened) {}

  const SQLite::Database& database;
  SQLite::Statement begin{database, "BEGIN IMMEDIATE"};
  SQLite::Statement commit{database, "COMMIT"};
  SQLite::Statement put_job{database, "INSERT OR REPLACE INTO job VALUES(?,?,?,?,?,?)"};
  SQLite::Statement delete_job{database, "DELETE FROM job WHERE number = ?"};
  SQLite::Statement put_result{database, "INSERT INTO result VALUES(?,?,?,?,?,?,?,?,?)"};
  SQLite::Statement put_content{database, "INSERT INTO content VALUES(?,?)"};
  SQLite::Statement put_aside{database, "INSERT OR REPLACE INTO aside VALUES(?,?,?)"};
  SQLite::Statement delete_aside{database, "DELETE FROM aside WHERE worker = ?"};
};

absl::Status Damaged(const SQLite::Database& database, const std::string& what) {
  return absl::DataLossError(absl::StrCat(database.getFilename(), ": ", what, " is damaged"));
}

// Here and below, what reads and writes throws SQLite::Exception.
std::vector<JobRecord> ReadJobs(const SQLite::Database& database) {
  std::vector<JobRecord> jobs;
  SQLite::Statement read(database, "SELECT number, request_id, body, over, released, sum FROM job ORDER BY number");
  while (read.executeStep()) {
    JobRecord job{IntOf(read, 0), std::string(BytesOf(read, 1)), std::string(BytesOf(read, 2)), IntOf(read, 3) != 0,
                  IntOf(read, 4) != 0};
    job.damaged = SumOfJob(job) != BytesOf(read, 5);
    jobs.push_back(std::move(job));
  }
  return jobs;
}

std::vector<SetAsideRecord> ReadSetAside(const SQLite::Database& database) {
  std::vector<SetAsideRecord> set_aside;
  SQLite::Statement read(database, "SELECT worker, reason, sum FROM aside");
  while (read.executeStep()) {
    SetAsideRecord aside{std::string(BytesOf(read, 0)), std::string(BytesOf(read, 1))};
    // One that is damaged is not worth more than that the worker is tried again.
    if (SumOfAside(aside) == BytesOf(read, 2)) set_aside.push_back(std::move(aside));
  }
  return set_aside;
}

absl::StatusOr<uint32_t> NextEpoch(SQLite::Database& database) {
  database.exec("UPDATE epoch SET value = value + 1");
  SQLite::Statement read(database, "SELECT value FROM epoch");
  const int64_t epoch = read.executeStep() ? IntOf(read, 0) : 0;
  if (epoch < 1 || epoch > UINT32_MAX) return Damaged(database, "its epoch");
  return static_cast<uint32_t>(epoch);
}

// A result as it was put, and its content if that is inside.
struct StoredResult {
  ResultRow row;
  std::string sum;
  std::string content;
};

// Results as they are read, many at a time.
class ResultPages {
 public:
  explicit ResultPages(const SQLite::Database& database) : database_(database) {}

  absl::StatusOr<const StoredResult*> Read(int64_t number) {
    const int64_t page = number / kPageRows;
    if (!pages_.contains(page)) ReadPage(page);
    const std::vector<StoredResult>& results = pages_.at(page);
    const auto result = std::partition_point(results.begin(), results.end(),
                                             [&](const StoredResult& r) { return r.row.number < number; });
    const bool is_there = result != results.end() && result->row.number == number;
    if (is_there && result->row.Sum() == result->sum) return &*result;
    return Damaged(database_, absl::StrCat("result ", number));
  }

  void Forget() {
    pages_.clear();
    pages_read_.clear();
  }

 private:
  void ReadPage(int64_t page) {
    std::vector<StoredResult> results;
    SQLite::Statement& read = With(get_results_, page * kPageRows, (page + 1) * kPageRows - 1);
    while (read.executeStep()) {
      results.push_back({{IntOf(read, 0), IntOf(read, 1), std::string(BytesOf(read, 2)), IntOf(read, 3),
                          std::string(BytesOf(read, 4)), IntOf(read, 5), std::string(BytesOf(read, 6)),
                          std::string(BytesOf(read, 7))},
                         std::string(BytesOf(read, 8)),
                         std::string(BytesOf(read, 9))});
    }
    if (pages_.size() >= kMostPagesRead) {
      pages_.erase(pages_read_.front());
      pages_read_.pop_front();
    }
    pages_read_.push_back(page);
    pages_[page] = std::move(results);
  }

  const SQLite::Database& database_;
  SQLite::Statement get_results_{
      database_,
      "SELECT number, job, name, state, output, inside, error, lost_workers, sum, bytes "
      "FROM result LEFT JOIN content ON content.result = number WHERE number BETWEEN ? AND ? ORDER BY number"};
  absl::flat_hash_map<int64_t, std::vector<StoredResult>> pages_;  // by number / kPageRows
  std::deque<int64_t> pages_read_;                                 // the oldest first
};

// Takes what nobody needs out of the file: results of jobs that are over, and then their room.
class Tidying {
 public:
  explicit Tidying(SQLite::Database& database) : database_(database) {}

  const std::set<int64_t>& running() const { return running_; }  // jobs that are not over
  void Put(const JobRecord& job) {
    if (!job.over) {
      running_.insert(job.number);
      return;
    }
    running_.erase(job.number);
    has_old_results_ = true;
    tidy_from_ = 0;
  }
  void Wrote() { is_log_empty_ = false; }

  // A little of it; false if there is nothing left to do.
  bool DoALittle() {
    if (!has_old_results_ && is_log_empty_) return false;
    has_old_results_ ? DeleteOldResults() : Shrink();
    return true;
  }

 private:
  void DeleteOldResults() {
    std::vector<int64_t> old;
    int64_t looked_at = 0;
    SQLite::Statement& next = With(next_results_, tidy_from_, kMostExamined);
    for (; next.executeStep(); ++looked_at) {
      tidy_from_ = IntOf(next, 0);
      if (!running_.contains(IntOf(next, 1))) old.push_back(tidy_from_);
    }
    has_old_results_ = looked_at == kMostExamined;
    if (old.empty()) return;
    SQLite::Transaction transaction(database_, SQLite::TransactionBehavior::IMMEDIATE);
    for (const int64_t number : old) {
      With(delete_result_, number).exec();
      With(delete_content_, number).exec();
    }
    FailPoint("journal.tidy");
    transaction.commit();
    is_log_empty_ = false;
  }

  void Shrink() {
    database_.exec(absl::StrCat("PRAGMA incremental_vacuum(", kMostPages, ")"));
    database_.exec("PRAGMA wal_checkpoint(TRUNCATE)");
    FailPoint("journal.checkpointed");
    is_log_empty_ = database_.execAndGet("PRAGMA freelist_count").getInt64() == 0;
  }

  SQLite::Database& database_;
  SQLite::Statement next_results_{database_, "SELECT number, job FROM result WHERE number > ? ORDER BY number LIMIT ?"};
  SQLite::Statement delete_result_{database_, "DELETE FROM result WHERE number = ?"};
  SQLite::Statement delete_content_{database_, "DELETE FROM content WHERE result = ?"};
  std::set<int64_t> running_;
  bool is_log_empty_ = true;
  bool has_old_results_ = true;  // perhaps
  int64_t tidy_from_ = 0;        // row
};

class SqliteJournal : public CommittedJournal {
 public:
  explicit SqliteJournal(SQLite::Database database) : database_(std::move(database)) {}
  // Reads what there is and starts the writer.
  absl::Status Start();

  absl::StatusOr<std::optional<ResultRecord>> Find(int64_t job, const TaskName& task) override;
  absl::StatusOr<std::vector<std::string>> Outputs(int64_t job) override;
  absl::Status ReadAgain(int64_t job) override;

 private:
  GroupCommit& Writer() override { return *writer_; }

  void Commit(const std::vector<JournalPut>& puts);  // here and below with database_mutex_ held; SQLite::Exception
  void Insert(const JobRecord& job);
  void Insert(const NewResult& put);
  void Insert(const OldJob& job);
  void Insert(const SetAsideRecord& aside);
  void Insert(const FalseResults& results);

  std::mutex database_mutex_;
  SQLite::Database database_;
  std::optional<JournalStatements> statements_;
  std::optional<ResultPages> pages_;
  std::optional<Tidying> tidying_;
  SqliteResultIndex index_;              // of the jobs that are not over
  int64_t last_number_ = 0;              // of a row of `result`
  std::unique_ptr<GroupCommit> writer_;  // last: it uses the others
};

absl::Status SqliteJournal::Start() {
  TILEMEND_RETURN_IF_ERROR(CatchSqlite(database_, [&]() -> absl::Status {
    statements_.emplace(database_);
    pages_.emplace(database_);
    tidying_.emplace(database_);
    jobs_ = ReadJobs(database_);
    for (const JobRecord& job : jobs_) tidying_->Put(job);
    last_number_ = index_.ReadAll(database_, tidying_->running());
    set_aside_ = ReadSetAside(database_);
    TILEMEND_ASSIGN_OR_RETURN(epoch_, NextEpoch(database_));
    tidying_->Wrote();
    return absl::OkStatus();
  }));
  writer_ = std::make_unique<GroupCommit>(
      [this](const std::vector<JournalPut>& puts) {
        std::lock_guard<std::mutex> lock(database_mutex_);
        RequireOfJournal(CatchSqlite(database_, [&] {
          Commit(puts);
          return CheckInPlace(database_);
        }));
        FailPoint("journal.committed");
      },
      [this] {
        std::lock_guard<std::mutex> lock(database_mutex_);
        return RequireOfJournal(
            CatchSqlite(database_, [&]() -> absl::StatusOr<bool> { return tidying_->DoALittle(); }));
      });
  return absl::OkStatus();
}

absl::StatusOr<std::optional<ResultRecord>> SqliteJournal::Find(int64_t job, const TaskName& task) {
  const std::optional<int64_t> number = index_.Find(job, task);  // which waits for no disk
  if (!number) return std::nullopt;
  std::lock_guard<std::mutex> lock(database_mutex_);
  TILEMEND_ASSIGN_OR_RETURN(const StoredResult* const stored,
                            CatchSqlite(database_, [&] { return pages_->Read(*number); }));
  const ResultRow& row = stored->row;
  ResultRecord result{static_cast<TaskState>(row.state), row.output, std::nullopt, row.error, {}};
  SetWorkers(row.lost_workers, result);
  if (row.inside == 0) return result;
  if (Sha256Hex(stored->content) != row.output)
    return Damaged(database_, absl::StrCat("the output of result ", row.number));
  result.content = stored->content;
  return result;
}

absl::StatusOr<std::vector<std::string>> SqliteJournal::Outputs(int64_t job) {
  std::vector<std::string> outputs;
  std::lock_guard<std::mutex> lock(database_mutex_);
  for (const int64_t number : index_.BlobsOf(job)) {
    TILEMEND_ASSIGN_OR_RETURN(const StoredResult* const stored,
                              CatchSqlite(database_, [&] { return pages_->Read(number); }));
    outputs.push_back(stored->row.output);
  }
  return outputs;
}

absl::Status SqliteJournal::ReadAgain(int64_t job) {
  Await();
  std::lock_guard<std::mutex> lock(database_mutex_);
  pages_->Forget();  // the last one may have had room
  return CatchSqlite(database_, [&] {
    index_.ReadJob(database_, job);
    return absl::OkStatus();
  });
}

// If it throws, the program ends (RequireOfJournal), and SQLite takes back what is open when the file is opened again.
void SqliteJournal::Commit(const std::vector<JournalPut>& puts) {
  With(statements_->begin).exec();
  for (const JournalPut& put : puts) std::visit([this](const auto& p) { Insert(p); }, put);
  if (FailPoint("journal.commit")) throw SQLite::Exception("a sync failed (injected)");
  With(statements_->commit).exec();
  tidying_->Wrote();
}

void SqliteJournal::Insert(const JobRecord& job) {
  tidying_->Put(job);
  if (job.over) index_.Forget(job.number);
  const std::string sum = SumOfJob(job);
  With(statements_->put_job, job.number, job.request_id, job.body, int64_t{job.over}, int64_t{job.released}, sum)
      .exec();
}

void SqliteJournal::Insert(const NewResult& put) {
  const ResultRecord& result = put.result;
  const ResultRow row{++last_number_,   put.job,
                      NameOf(put.task), static_cast<int64_t>(result.state),
                      result.output,    result.content.has_value() ? 1 : 0,
                      result.error,     WorkersOf(result)};
  const std::string sum = row.Sum();
  With(statements_->put_result, row.number, row.job, row.name, row.state, row.output, row.inside, row.error,
       row.lost_workers, sum)
      .exec();
  if (result.content.has_value()) With(statements_->put_content, row.number, *result.content).exec();
}

void SqliteJournal::Insert(const FalseResults& results) {
  constexpr char kWhich[] = "FROM result WHERE job = ? AND lost_workers = ? AND state = ?";
  for (const std::string& sql : {absl::StrCat("DELETE FROM content WHERE result IN (SELECT number ", kWhich, ")"),
                                 absl::StrCat("DELETE ", kWhich)}) {
    SQLite::Statement drop(database_, sql);
    With(drop, results.job, results.worker, static_cast<int64_t>(TaskState::kCommitted)).exec();
  }
}

void SqliteJournal::Insert(const OldJob& job) { With(statements_->delete_job, job.number).exec(); }

void SqliteJournal::Insert(const SetAsideRecord& aside) {
  if (aside.reason.empty()) {
    With(statements_->delete_aside, aside.worker).exec();
    return;
  }
  const std::string sum = SumOfAside(aside);
  With(statements_->put_aside, aside.worker, aside.reason, sum).exec();
}

}  // namespace

absl::StatusOr<std::unique_ptr<Journal>> OpenSqliteJournal(const std::string& path) {
  TILEMEND_ASSIGN_OR_RETURN(SQLite::Database database, OpenJournalFile(path));
  auto journal = std::make_unique<SqliteJournal>(std::move(database));
  TILEMEND_RETURN_IF_ERROR(journal->Start());
  return journal;
}

}  // namespace tilemend
