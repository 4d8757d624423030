#include "coordinator/journal/postgres_journal.h"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <set>
#include <thread>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/time/clock.h"
#include "common/store/digest.h"
#include "common/util/failpoint.h"
#include "common/util/status_macros.h"
#include "coordinator/journal/committed_journal.h"
#include "coordinator/journal/group_commit.h"
#include "coordinator/journal/journal_rows.h"
#include "coordinator/journal/postgres_connection.h"

namespace tilemend {
namespace {

constexpr std::chrono::seconds kBeat(1);
constexpr absl::Duration kPoll = absl::Milliseconds(500);
constexpr int64_t kMostDeleted = 2000;  // rows in one statement

// One row of the epoch; its beat is NULL when nobody is at work. The lock keeps two that start at once apart.
constexpr char kTables[] = R"(
BEGIN;
SELECT pg_advisory_xact_lock(8453625118);
CREATE TABLE IF NOT EXISTS tilemend_epoch(one BOOLEAN PRIMARY KEY DEFAULT true CHECK (one), value BIGINT NOT NULL,
                                          beat TIMESTAMPTZ);
INSERT INTO tilemend_epoch(value) VALUES(0) ON CONFLICT DO NOTHING;
CREATE TABLE IF NOT EXISTS tilemend_job(number BIGINT PRIMARY KEY, request_id BYTEA NOT NULL, body BYTEA NOT NULL,
                                        over BIGINT NOT NULL, released BIGINT NOT NULL);
CREATE TABLE IF NOT EXISTS tilemend_result(job BIGINT, name BYTEA, state BIGINT NOT NULL, output BYTEA NOT NULL,
                                           inside BIGINT NOT NULL, error BYTEA NOT NULL, lost_workers BYTEA NOT NULL,
                                           content BYTEA NOT NULL, PRIMARY KEY(job, name));
CREATE TABLE IF NOT EXISTS tilemend_aside(worker BYTEA PRIMARY KEY, reason BYTEA NOT NULL);
COMMIT;
SET synchronous_commit = on;
)";

absl::Status Insert(PostgresConnection& connection, const JobRecord& job) {
  return connection
      .Query(
          "INSERT INTO tilemend_job VALUES($1,$2,$3,$4,$5) ON CONFLICT (number) DO UPDATE SET "
          "request_id = $2, body = $3, over = $4, released = $5",
          {job.number, job.request_id, job.body, int64_t{job.over}, int64_t{job.released}})
      .status();
}

absl::Status Insert(PostgresConnection& connection, const NewResult& put) {
  const ResultRecord& result = put.result;
  const std::string name = NameOf(put.task), workers = WorkersOf(result);
  return connection
      .Query(
          "INSERT INTO tilemend_result VALUES($1,$2,$3,$4,$5,$6,$7,$8) ON CONFLICT (job, name) DO UPDATE SET "
          "state = $3, output = $4, inside = $5, error = $6, lost_workers = $7, content = $8",
          {put.job, name, static_cast<int64_t>(result.state), result.output, int64_t{result.content.has_value()},
           result.error, workers, result.content ? std::string_view(*result.content) : std::string_view()})
      .status();
}

absl::Status Insert(PostgresConnection& connection, const OldJob& job) {
  return connection.Query("DELETE FROM tilemend_job WHERE number = $1", {job.number}).status();
}

absl::Status Insert(PostgresConnection& connection, const FalseResults& results) {
  return connection
      .Query("DELETE FROM tilemend_result WHERE job = $1 AND lost_workers = $2 AND state = $3",
             {results.job, results.worker, static_cast<int64_t>(TaskState::kCommitted)})
      .status();
}

absl::Status Insert(PostgresConnection& connection, const SetAsideRecord& aside) {
  if (aside.reason.empty()) {
    return connection.Query("DELETE FROM tilemend_aside WHERE worker = $1", {aside.worker}).status();
  }
  return connection
      .Query("INSERT INTO tilemend_aside VALUES($1,$2) ON CONFLICT (worker) DO UPDATE SET reason = $2",
             {aside.worker, aside.reason})
      .status();
}

class PostgresJournal : public CommittedJournal {
 public:
  PostgresJournal(PostgresConnection connection, uint32_t epoch) : connection_(std::move(connection)) {
    epoch_ = epoch;
  }
  ~PostgresJournal() override {
    writer_.reset();
    {
      std::lock_guard<std::mutex> lock(mutex_);
      ending_ = true;
      end_.notify_all();
    }
    if (beat_.joinable()) beat_.join();
    // Whoever stands by need not wait.
    connection_.Query("UPDATE tilemend_epoch SET beat = NULL WHERE value = $1", {int64_t{epoch_}})
        .status()
        .IgnoreError();
  }

  // Reads what there is and starts the threads.
  absl::Status Start();

  absl::StatusOr<std::optional<ResultRecord>> Find(int64_t job, const TaskName& task) override;
  absl::StatusOr<std::vector<std::string>> Outputs(int64_t job) override;

 private:
  GroupCommit& Writer() override { return *writer_; }

  absl::Status ReadJobs();
  absl::Status ReadSetAside();
  absl::Status ReadOldJobs();

  // All below with the lock held.
  void Commit(const std::vector<JournalPut>& puts);
  // Ends the process unless its epoch is the last one. Within a transaction: until its end it stays so.
  void SayAtWork();
  bool DeleteOldResults();

  void Beat();  // a thread

  std::mutex mutex_;
  std::condition_variable end_;
  bool ending_ = false;
  PostgresConnection connection_;
  std::set<int64_t> old_jobs_;  // whose results are not needed any more
  std::thread beat_;
  std::unique_ptr<GroupCommit> writer_;  // last: it uses the others
};

absl::Status PostgresJournal::Start() {
  TILEMEND_RETURN_IF_ERROR(ReadJobs());
  TILEMEND_RETURN_IF_ERROR(ReadSetAside());
  TILEMEND_RETURN_IF_ERROR(ReadOldJobs());
  beat_ = std::thread([this] { Beat(); });
  writer_ = std::make_unique<GroupCommit>(
      [this](const std::vector<JournalPut>& puts) {
        std::lock_guard<std::mutex> lock(mutex_);
        Commit(puts);
      },
      [this] {
        std::lock_guard<std::mutex> lock(mutex_);
        return DeleteOldResults();
      });
  return absl::OkStatus();
}

absl::Status PostgresJournal::ReadJobs() {
  TILEMEND_ASSIGN_OR_RETURN(
      const PostgresRows rows,
      connection_.Query("SELECT number, request_id, body, over, released FROM tilemend_job ORDER BY number", {}));
  for (int i = 0; i < rows.size(); ++i) {
    jobs_.push_back({rows.Int(i, 0), std::string(rows.Bytes(i, 1)), std::string(rows.Bytes(i, 2)), rows.Int(i, 3) != 0,
                     rows.Int(i, 4) != 0});
  }
  return absl::OkStatus();
}

absl::Status PostgresJournal::ReadSetAside() {
  TILEMEND_ASSIGN_OR_RETURN(const PostgresRows rows,
                            connection_.Query("SELECT worker, reason FROM tilemend_aside ORDER BY worker", {}));
  for (int i = 0; i < rows.size(); ++i) {
    set_aside_.push_back({std::string(rows.Bytes(i, 0)), std::string(rows.Bytes(i, 1))});
  }
  return absl::OkStatus();
}

absl::Status PostgresJournal::ReadOldJobs() {
  TILEMEND_ASSIGN_OR_RETURN(
      const PostgresRows rows,
      connection_.Query("SELECT DISTINCT job FROM tilemend_result "
                        "WHERE NOT EXISTS (SELECT 1 FROM tilemend_job WHERE number = job AND over = 0)",
                        {}));
  for (int i = 0; i < rows.size(); ++i) old_jobs_.insert(rows.Int(i, 0));
  return absl::OkStatus();
}

absl::StatusOr<std::optional<ResultRecord>> PostgresJournal::Find(int64_t job, const TaskName& task) {
  const std::string name = NameOf(task);
  std::lock_guard<std::mutex> lock(mutex_);
  TILEMEND_ASSIGN_OR_RETURN(
      const PostgresRows rows,
      connection_.Query("SELECT state, output, inside, error, lost_workers, content FROM tilemend_result "
                        "WHERE job = $1 AND name = $2",
                        {job, name}));
  if (rows.size() == 0) return std::nullopt;
  ResultRecord result{static_cast<TaskState>(rows.Int(0, 0)),
                      std::string(rows.Bytes(0, 1)),
                      std::nullopt,
                      std::string(rows.Bytes(0, 3)),
                      {}};
  SetWorkers(rows.Bytes(0, 4), result);
  if (rows.Int(0, 2) == 0) return result;
  result.content = std::string(rows.Bytes(0, 5));
  if (Sha256Hex(*result.content) == result.output) return result;
  return absl::DataLossError(absl::StrCat("PostgreSQL: the output of a result of job ", job, " is damaged"));
}

absl::StatusOr<std::vector<std::string>> PostgresJournal::Outputs(int64_t job) {
  std::lock_guard<std::mutex> lock(mutex_);
  TILEMEND_ASSIGN_OR_RETURN(
      const PostgresRows rows,
      connection_.Query("SELECT output FROM tilemend_result WHERE job = $1 AND inside = 0 AND output <> ''", {job}));
  std::vector<std::string> outputs;
  for (int i = 0; i < rows.size(); ++i) outputs.emplace_back(rows.Bytes(i, 0));
  return outputs;
}

void PostgresJournal::SayAtWork() {
  const PostgresRows rows = RequireOfJournal(
      connection_.Query("UPDATE tilemend_epoch SET beat = clock_timestamp() WHERE value = $1", {int64_t{epoch_}}));
  if (rows.changed() == 0) EndForJournal(absl::AbortedError("another coordinator has taken over"));
}

void PostgresJournal::Commit(const std::vector<JournalPut>& puts) {
  RequireOfJournal(connection_.Run("BEGIN"));
  SayAtWork();
  for (const JournalPut& put : puts) {
    RequireOfJournal(std::visit([this](const auto& p) { return Insert(connection_, p); }, put));
    if (const auto* const job = std::get_if<JobRecord>(&put); job != nullptr && job->over)
      old_jobs_.insert(job->number);
    if (const auto* const job = std::get_if<OldJob>(&put)) old_jobs_.insert(job->number);
  }
  if (FailPoint("journal.commit")) EndForJournal(absl::InternalError("PostgreSQL: a commit failed (injected)"));
  RequireOfJournal(connection_.Run("COMMIT"));
  FailPoint("journal.committed");
}

bool PostgresJournal::DeleteOldResults() {
  if (old_jobs_.empty()) return false;
  RequireOfJournal(connection_.Run("BEGIN"));
  SayAtWork();
  const PostgresRows rows =
      RequireOfJournal(connection_.Query("DELETE FROM tilemend_result WHERE ctid = ANY(ARRAY(SELECT ctid FROM "
                                         "tilemend_result WHERE job = $1 LIMIT $2::bigint))",
                                         {*old_jobs_.begin(), kMostDeleted}));
  RequireOfJournal(connection_.Run("COMMIT"));
  if (rows.changed() < kMostDeleted) old_jobs_.erase(old_jobs_.begin());
  return true;
}

void PostgresJournal::Beat() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (!end_.wait_for(lock, kBeat, [this] { return ending_; })) SayAtWork();
}

// The next epoch, once nobody is at work.
absl::StatusOr<uint32_t> TakeOver(PostgresConnection& connection, const StandBy& stand_by) {
  for (bool first = true; true; first = false) {
    TILEMEND_ASSIGN_OR_RETURN(
        const PostgresRows rows,
        connection.Query("UPDATE tilemend_epoch SET value = value + 1, beat = clock_timestamp() "
                         "WHERE beat IS NULL OR clock_timestamp() - beat > $1::bigint * interval '1 millisecond' "
                         "RETURNING value",
                         {absl::ToInt64Milliseconds(stand_by.silence)}));
    if (rows.size() > 0) return static_cast<uint32_t>(rows.Int(0, 0));
    if (first) stand_by.waits();
    if (stand_by.ends()) return absl::CancelledError("asked to end while another coordinator was at work");
    absl::SleepFor(kPoll);
  }
}

}  // namespace

absl::StatusOr<std::unique_ptr<Journal>> OpenPostgresJournal(const std::string& where, const StandBy& stand_by) {
  TILEMEND_ASSIGN_OR_RETURN(PostgresConnection connection, PostgresConnection::Open(where));
  TILEMEND_RETURN_IF_ERROR(connection.Run(kTables));
  // One that is stopped within a transaction holds the row of the epoch: the server lets go of it.
  TILEMEND_RETURN_IF_ERROR(connection.Run(
      absl::StrCat("SET idle_in_transaction_session_timeout = ", absl::ToInt64Milliseconds(stand_by.silence))));
  TILEMEND_ASSIGN_OR_RETURN(const uint32_t epoch, TakeOver(connection, stand_by));
  auto journal = std::make_unique<PostgresJournal>(std::move(connection), epoch);
  TILEMEND_RETURN_IF_ERROR(journal->Start());
  return journal;
}

}  // namespace tilemend
