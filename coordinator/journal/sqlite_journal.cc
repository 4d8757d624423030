#include "coordinator/journal/sqlite_journal.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <cstring>
#include <map>
#include <mutex>
#include <set>
#include <thread>
#include <utility>
#include <variant>

#include "absl/container/flat_hash_map.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "absl/strings/str_split.h"
#include "common/store/digest.h"
#include "common/util/exit_codes.h"
#include "common/util/failpoint.h"
#include "common/util/status_macros.h"
#include "coordinator/journal/journal_rows.h"
#include "coordinator/journal/sqlite_journal_file.h"

namespace tilemend {
namespace {

constexpr std::chrono::milliseconds kIdle(500);  // without a put, before the log is emptied and old results are deleted
constexpr int64_t kMostPages = 1000;             // given back to the disk in one transaction
constexpr int64_t kMostDeleted = 2000;           // rows looked at in one transaction: some milliseconds

struct NewResult {
  int64_t job = 0;
  TaskName task;
  ResultRecord result;
};
struct OldJob {
  int64_t number = 0;
};
using Put = std::variant<JobRecord, NewResult, OldJob, SetAsideRecord>;

// There is no going on: what was put has taken effect in memory, and whether it is on the disk nobody can know. A sync
// that is tried again may succeed without having written what the first one lost.
[[noreturn]] void EndProcess(const absl::Status& status) {
  std::fprintf(stderr,
               "tilemend-coordinator: the journal cannot be written: %s; ending. Nobody was told of what is not in it. "
               "Start the coordinator again when the cause is mended: its jobs go on.\n",
               std::string(status.message()).c_str());
  std::fflush(stderr);
  ::_exit(kExitRetryable);
}

void Require(const absl::Status& status) {
  if (!status.ok()) EndProcess(status);
}

template <class T>
T Require(absl::StatusOr<T> value) {
  Require(value.status());
  return *std::move(value);
}

class SqliteJournal : public Journal {
 public:
  SqliteJournal(std::string path, SqliteDatabase database) : path_(std::move(path)), database_(std::move(database)) {}
  ~SqliteJournal() override {
    {
      std::lock_guard<std::mutex> lock(queue_mutex_);
      ending_ = true;
      queued_.notify_all();
    }
    if (writer_.joinable()) writer_.join();
  }

  // Reads what there is and starts the writer.
  absl::Status Start();

  uint32_t epoch() const override { return epoch_; }
  std::vector<JobRecord> TakeJobs() override { return std::exchange(jobs_, {}); }
  void PutJob(JobRecord job) override { Enqueue(std::move(job)); }
  void PutResult(int64_t job, TaskName task, ResultRecord result) override {
    Enqueue(NewResult{job, std::move(task), std::move(result)});
  }
  void DropJob(int64_t job) override { Enqueue(OldJob{job}); }
  std::vector<SetAsideRecord> TakeSetAside() override { return std::exchange(set_aside_, {}); }
  void PutSetAside(SetAsideRecord record) override { Enqueue(std::move(record)); }
  void Await() override {
    std::unique_lock<std::mutex> lock(queue_mutex_);
    committed_.wait(lock, [this, wanted = put_] { return durable_ >= wanted; });
  }
  absl::StatusOr<std::optional<ResultRecord>> Find(int64_t job, const TaskName& task) override;
  absl::StatusOr<std::vector<std::string>> Outputs(int64_t job) override;
  bool is_durable() const override { return true; }

 private:
  using Index = absl::flat_hash_map<NameBytes, int64_t>;

  absl::Status Prepare();
  absl::Status NextEpoch();
  absl::Status ReadJobs();
  absl::Status ReadIndex();
  absl::Status ReadSetAside();
  absl::StatusOr<ResultRow> ReadRow(int64_t number);
  absl::Status Damaged(const std::string& what) const {
    return absl::DataLossError(absl::StrCat(path_, ": ", what, " is damaged"));
  }

  void Enqueue(Put put);
  void Write();                        // the writer's thread
  void Commit(std::vector<Put> puts);  // here and below with database_mutex_ held
  absl::Status Insert(const JobRecord& job);
  absl::Status Insert(const NewResult& result);
  absl::Status Insert(const OldJob& job);
  absl::Status Insert(const SetAsideRecord& aside);
  bool TidyUp();  // a little of it; false if there is nothing left to do
  void DeleteOldResults();
  void Shrink();

  const std::string path_;

  std::mutex queue_mutex_;
  std::condition_variable queued_, committed_;
  std::vector<Put> queue_;
  uint64_t put_ = 0, durable_ = 0;
  bool ending_ = false;

  std::mutex database_mutex_;
  SqliteDatabase database_;
  std::optional<SqliteStatement> put_job_, put_result_, put_content_, get_result_, get_content_, next_results_,
      delete_result_, delete_content_, delete_job_, put_aside_, delete_aside_, free_pages_;
  uint32_t epoch_ = 0;
  std::vector<JobRecord> jobs_;
  std::vector<SetAsideRecord> set_aside_;
  std::mutex index_mutex_;
  std::map<int64_t, Index> indexes_;  // of the jobs that are not over: number of the last row of each name
  std::set<int64_t> running_;         // jobs that are not over
  int64_t last_number_ = 0;           // of a row of `result`
  bool is_log_empty_ = true;
  bool has_old_results_ = true;  // perhaps
  int64_t tidy_from_ = 0;        // row
  std::thread writer_;
};

absl::Status SqliteJournal::Start() {
  TILEMEND_RETURN_IF_ERROR(Prepare());
  TILEMEND_RETURN_IF_ERROR(ReadJobs());
  TILEMEND_RETURN_IF_ERROR(ReadIndex());
  TILEMEND_RETURN_IF_ERROR(ReadSetAside());
  TILEMEND_RETURN_IF_ERROR(NextEpoch());
  writer_ = std::thread([this] { Write(); });
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
  TILEMEND_RETURN_IF_ERROR(prepare(
      get_result_, "SELECT job, name, state, output, inside, error, lost_workers, sum FROM result WHERE number = ?"));
  TILEMEND_RETURN_IF_ERROR(prepare(get_content_, "SELECT bytes FROM content WHERE result = ?"));
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

absl::Status SqliteJournal::ReadIndex() {
  TILEMEND_ASSIGN_OR_RETURN(SqliteStatement read, database_.Prepare("SELECT number, job, name FROM result"));
  while (true) {
    TILEMEND_ASSIGN_OR_RETURN(const bool is_there, read.Step());
    if (!is_there) return absl::OkStatus();
    last_number_ = read.Int(0);
    if (!running_.contains(read.Int(1))) continue;
    NameBytes name{};
    // A name of another length is that of a damaged row, which Outputs tells.
    std::memcpy(name.data(), read.Bytes(2).data(), std::min(name.size(), read.Bytes(2).size()));
    indexes_[read.Int(1)][name] = last_number_;
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

absl::StatusOr<ResultRow> SqliteJournal::ReadRow(int64_t number) {
  TILEMEND_ASSIGN_OR_RETURN(const bool is_there, get_result_->Bind(0, number).Step());
  if (!is_there) return Damaged(absl::StrCat("result ", number));
  const SqliteStatement& read = *get_result_;
  ResultRow row{number,
                read.Int(0),
                std::string(read.Bytes(1)),
                read.Int(2),
                std::string(read.Bytes(3)),
                read.Int(4),
                std::string(read.Bytes(5)),
                std::string(read.Bytes(6))};
  const bool is_whole = row.Sum() == read.Bytes(7);
  get_result_->Reset();
  if (!is_whole) return Damaged(absl::StrCat("result ", number));
  return row;
}

absl::StatusOr<std::optional<ResultRecord>> SqliteJournal::Find(int64_t job, const TaskName& task) {
  NameBytes name;
  std::memcpy(name.data(), NameOf(task).data(), name.size());
  int64_t number = 0;
  {
    std::lock_guard<std::mutex> lock(index_mutex_);  // which nobody holds while the disk is at work
    const auto index = indexes_.find(job);
    if (index == indexes_.end()) return std::nullopt;
    const auto found = index->second.find(name);
    if (found == index->second.end()) return std::nullopt;
    number = found->second;
  }
  std::lock_guard<std::mutex> lock(database_mutex_);
  TILEMEND_ASSIGN_OR_RETURN(ResultRow row, ReadRow(number));
  ResultRecord result;
  result.state = static_cast<TaskState>(row.state);
  result.output = std::move(row.output);
  result.error = std::move(row.error);
  if (!row.lost_workers.empty()) result.lost_workers = absl::StrSplit(row.lost_workers, '\n');
  if (row.inside == 0) return result;
  TILEMEND_ASSIGN_OR_RETURN(const bool is_there, get_content_->Bind(0, row.number).Step());
  if (is_there) result.content = std::string(get_content_->Bytes(0));
  get_content_->Reset();
  if (!is_there || Sha256Hex(*result.content) != result.output) {
    return Damaged(absl::StrCat("the output of result ", row.number));
  }
  return result;
}

absl::StatusOr<std::vector<std::string>> SqliteJournal::Outputs(int64_t job) {
  std::vector<int64_t> numbers;
  {
    std::lock_guard<std::mutex> lock(index_mutex_);
    const auto index = indexes_.find(job);
    if (index == indexes_.end()) return std::vector<std::string>();
    for (const auto& [name, number] : index->second) numbers.push_back(number);
  }
  std::sort(numbers.begin(), numbers.end());  // the order on the disk
  std::vector<std::string> outputs;
  std::lock_guard<std::mutex> lock(database_mutex_);
  for (const int64_t number : numbers) {
    TILEMEND_ASSIGN_OR_RETURN(ResultRow row, ReadRow(number));
    if (row.inside == 0 && !row.output.empty()) outputs.push_back(std::move(row.output));
  }
  return outputs;
}

void SqliteJournal::Enqueue(Put put) {
  std::lock_guard<std::mutex> lock(queue_mutex_);
  queue_.push_back(std::move(put));
  ++put_;
  queued_.notify_one();
}

void SqliteJournal::Write() {
  const auto is_news = [this] { return ending_ || !queue_.empty(); };
  std::unique_lock<std::mutex> lock(queue_mutex_);
  bool is_tidy = false;
  std::chrono::milliseconds pause = kIdle;
  while (true) {
    if (is_tidy) {
      queued_.wait(lock, is_news);
    } else if (!queued_.wait_for(lock, pause, is_news)) {
      lock.unlock();
      {
        std::lock_guard<std::mutex> database_lock(database_mutex_);
        is_tidy = !TidyUp();
      }
      lock.lock();
      pause = std::chrono::milliseconds(0);
      continue;
    }
    if (queue_.empty()) return;
    std::vector<Put> puts = std::exchange(queue_, {});
    const uint64_t until = put_;
    lock.unlock();
    {
      std::lock_guard<std::mutex> database_lock(database_mutex_);
      Commit(std::move(puts));
    }
    lock.lock();
    durable_ = until;
    is_tidy = false;
    pause = kIdle;
    committed_.notify_all();
  }
}

void SqliteJournal::Commit(std::vector<Put> puts) {
  Require(database_.Run("BEGIN IMMEDIATE"));
  for (const Put& put : puts) {
    Require(std::visit([this](const auto& p) { return Insert(p); }, put));
  }
  if (FailPoint("journal.commit")) EndProcess(absl::InternalError(absl::StrCat(path_, ": a sync failed (injected)")));
  Require(database_.Run("COMMIT"));
  FailPoint("journal.committed");
  is_log_empty_ = false;
}

absl::Status SqliteJournal::Insert(const JobRecord& job) {
  if (job.over) {
    running_.erase(job.number);
    {
      std::lock_guard<std::mutex> lock(index_mutex_);
      indexes_.erase(job.number);
    }
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
                      result.error,     absl::StrJoin(result.lost_workers, "\n")};
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
  next_results_->Bind(0, tidy_from_).Bind(1, kMostDeleted);
  while (Require(next_results_->Step())) {
    ++looked_at;
    tidy_from_ = next_results_->Int(0);
    if (!running_.contains(next_results_->Int(1))) old.push_back(tidy_from_);
  }
  has_old_results_ = looked_at == kMostDeleted;
  if (old.empty()) return;
  Require(database_.Run("BEGIN IMMEDIATE"));
  for (const int64_t number : old) {
    Require(delete_result_->Bind(0, number).Run());
    Require(delete_content_->Bind(0, number).Run());
  }
  FailPoint("journal.tidy");
  Require(database_.Run("COMMIT"));
  is_log_empty_ = false;
}

void SqliteJournal::Shrink() {
  Require(database_.Run(absl::StrCat("PRAGMA incremental_vacuum(", kMostPages, ")")));
  Require(database_.Run("PRAGMA wal_checkpoint(TRUNCATE)"));
  FailPoint("journal.checkpointed");
  Require(free_pages_->Step());
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
