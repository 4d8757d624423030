#include "coordinator/journal/postgres_journal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <memory>

#include "absl/strings/str_cat.h"
#include "common/store/digest.h"
#include "common/util/exit_codes.h"
#include "common/util/failpoint.h"
#include "coordinator/journal/postgres_connection.h"
#include "tests/support/postgres_server.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;

class PostgresJournalTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    if (!PostgresServer::Programs().empty()) server_ = std::make_unique<PostgresServer>();
  }
  static void TearDownTestSuite() { server_.reset(); }

  void SetUp() override {
    if (server_ == nullptr) GTEST_SKIP() << "PostgreSQL is not installed: the journal on it is not tested";
    auto connection = PostgresConnection::Open(server_->where());
    ASSERT_TRUE(connection.ok()) << connection.status();
    ASSERT_TRUE(
        connection->Run("DROP TABLE IF EXISTS tilemend_epoch, tilemend_job, tilemend_result, tilemend_aside").ok());
  }

  static std::unique_ptr<Journal> Open(const StandBy& stand_by = {}) {
    auto journal = OpenPostgresJournal(server_->where(), stand_by);
    EXPECT_TRUE(journal.ok()) << journal.status();
    return journal.ok() ? *std::move(journal) : nullptr;
  }
  static JobRecord NewJob(int64_t number) {
    return {number, absl::StrCat("request ", number), absl::StrCat("job ", number)};
  }
  static TaskName Task(int32_t col) { return {{col, 7}, Stage::kFill, "input"}; }
  static ResultRecord Inside(const std::string& content) {
    return {TaskState::kCommitted, Sha256Hex(content), content, "", {}};
  }

  // A coordinator in a process of its own, which puts a job for each byte that comes through the pipe.
  struct Child {
    pid_t pid = 0;
    int pipe = -1, answers = -1;
    void Tell() const { ASSERT_EQ(write(pipe, "x", 1), 1); }
    void AwaitAnswer() const {
      char byte = 0;
      ASSERT_EQ(read(answers, &byte, 1), 1);
    }
    int AwaitEnd() const {
      int status = 0;
      waitpid(pid, &status, 0);
      return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    }
  };
  static Child StartChild(const StandBy& stand_by = {}, const std::string& failpoint = "") {
    int orders[2], answers[2];
    EXPECT_EQ(pipe(orders), 0);
    EXPECT_EQ(pipe(answers), 0);
    const pid_t pid = fork();
    if (pid != 0) return {pid, orders[1], answers[0]};
    if (!ArmFailPoint(failpoint).ok()) _exit(1);
    const auto journal = Open(stand_by);
    char byte = 0;
    for (int64_t number = 1; read(orders[0], &byte, 1) == 1; ++number) {
      journal->PutJob(NewJob(number));
      journal->Await();
      if (write(answers[1], &byte, 1) != 1) break;
    }
    _exit(0);
  }

  static std::unique_ptr<PostgresServer> server_;
};

std::unique_ptr<PostgresServer> PostgresJournalTest::server_;

constexpr absl::Duration kSilence = absl::Seconds(3);

TEST_F(PostgresJournalTest, JobsAreAsTheyWerePutLast) {
  {
    const auto journal = Open();
    EXPECT_TRUE(journal->TakeJobs().empty());
    journal->PutJob(NewJob(2));
    journal->PutJob(NewJob(1));
    JobRecord over = NewJob(2);
    over.over = true;
    over.body = std::string("\0ended", 6);
    journal->PutJob(over);
    journal->PutJob(NewJob(3));
    journal->DropJob(3);
    journal->Await();
  }
  const std::vector<JobRecord> jobs = Open()->TakeJobs();
  ASSERT_EQ(jobs.size(), 2U);
  EXPECT_EQ(jobs[0].body, "job 1");
  EXPECT_FALSE(jobs[0].over);
  EXPECT_EQ(jobs[1].request_id, "request 2");
  EXPECT_EQ(jobs[1].body, std::string("\0ended", 6));
  EXPECT_TRUE(jobs[1].over);
}

TEST_F(PostgresJournalTest, ResultsAreFoundByTheNextProcess) {
  const ResultRecord blob{TaskState::kCommitted, Sha256Hex("blob"), std::nullopt, "", {}};
  const ResultRecord failed{TaskState::kQuarantined, "", std::nullopt, "why", {"w1", "w2"}};
  {
    const auto journal = Open();
    journal->PutJob(NewJob(1));
    journal->PutResult(1, Task(1), failed);
    journal->PutResult(1, Task(1), Inside(std::string("a\0b", 3)));
    journal->PutResult(1, Task(2), blob);
    journal->PutResult(1, Task(3), failed);
    journal->Await();
  }
  const auto journal = Open();
  EXPECT_EQ(journal->Find(1, Task(1)).value(), Inside(std::string("a\0b", 3)));
  EXPECT_EQ(journal->Find(1, Task(2)).value(), blob);
  EXPECT_EQ(journal->Find(1, Task(3)).value(), failed);
  EXPECT_EQ(journal->Find(1, Task(4)).value(), std::nullopt);
  EXPECT_EQ(journal->Find(2, Task(1)).value(), std::nullopt);
  EXPECT_THAT(journal->Outputs(1).value(), ElementsAre(blob.output));
}

TEST_F(PostgresJournalTest, ResultsOfOneWorkerAreDroppedForGood) {
  const auto of = [](const std::string& worker, ResultRecord result) {
    result.worker = worker;
    return result;
  };
  const ResultRecord blob{TaskState::kCommitted, Sha256Hex("blob"), std::nullopt, "", {}};
  const ResultRecord lost{TaskState::kPending, "", std::nullopt, "", {"liar"}};
  const auto expect = [&](Journal& journal) {
    for (const int col : {1, 2}) EXPECT_EQ(journal.Find(1, Task(col)).value(), std::nullopt);
    EXPECT_EQ(journal.Find(1, Task(3)).value(), of("good", Inside("true")));
    EXPECT_EQ(journal.Find(1, Task(4)).value(), lost);
    EXPECT_EQ(journal.Find(2, Task(1)).value(), of("liar", Inside("lie"))) << "of another job";
    EXPECT_THAT(journal.Outputs(1).value(), ::testing::IsEmpty());
  };
  {
    const auto journal = Open();
    for (const int64_t job : {1, 2}) journal->PutJob(NewJob(job));
    for (const int64_t job : {1, 2}) journal->PutResult(job, Task(1), of("liar", Inside("lie")));
    journal->PutResult(1, Task(2), of("liar", blob));
    journal->PutResult(1, Task(3), of("good", Inside("true")));
    journal->PutResult(1, Task(4), lost);
    journal->Await();
    EXPECT_EQ(journal->Find(1, Task(1)).value()->worker, "liar");
    journal->DropResults(1, "liar");
    ASSERT_TRUE(journal->ReadAgain(1).ok());
    expect(*journal);
  }
  expect(*Open());
}

TEST_F(PostgresJournalTest, WorkersThatAreSetAsideAreRemembered) {
  {
    const auto journal = Open();
    journal->PutSetAside({"a", "lies"});
    journal->PutSetAside({"b", "too"});
    journal->PutSetAside({"b", ""});
    journal->Await();
  }
  EXPECT_THAT(Open()->TakeSetAside(), ElementsAre(SetAsideRecord{"a", "lies"}));
}

TEST_F(PostgresJournalTest, TheEpochGrowsWithEachOpening) {
  const uint32_t first = Open()->epoch();
  EXPECT_EQ(Open()->epoch(), first + 1);
}

TEST_F(PostgresJournalTest, StandsByWhileAnotherIsAtWork) {
  const auto journal = Open();
  int waits = 0;
  StandBy stand_by;
  stand_by.waits = [&] { ++waits; };
  stand_by.ends = [&] { return true; };
  EXPECT_TRUE(absl::IsCancelled(OpenPostgresJournal(server_->where(), stand_by).status()));
  EXPECT_EQ(waits, 1);
}

TEST_F(PostgresJournalTest, TakesOverFromOneThatDied) {
  const Child child = StartChild();
  child.Tell();
  child.AwaitAnswer();
  kill(child.pid, SIGKILL);
  EXPECT_EQ(child.AwaitEnd(), -SIGKILL);
  StandBy stand_by;
  stand_by.silence = kSilence;
  const auto journal = Open(stand_by);
  EXPECT_EQ(journal->epoch(), 2U);
  const std::vector<JobRecord> jobs = journal->TakeJobs();
  ASSERT_EQ(jobs.size(), 1U);
  EXPECT_EQ(jobs[0].body, "job 1");
}

TEST_F(PostgresJournalTest, OneThatComesBackIsRefusedAtItsNextWrite) {
  const Child child = StartChild();
  child.Tell();
  child.AwaitAnswer();
  kill(child.pid, SIGSTOP);
  StandBy stand_by;
  stand_by.silence = kSilence;
  auto journal = Open(stand_by);
  EXPECT_EQ(journal->epoch(), 2U);
  child.Tell();  // it wakes with something to put
  kill(child.pid, SIGCONT);
  EXPECT_EQ(child.AwaitEnd(), kExitRetryable);
  journal->PutJob(NewJob(7));
  journal->Await();
  EXPECT_EQ(journal->TakeJobs().size(), 1U);
  journal.reset();
  const std::vector<JobRecord> jobs = Open()->TakeJobs();
  ASSERT_EQ(jobs.size(), 2U);
  EXPECT_EQ(jobs[1].number, 7) << "what the first put after it came back is not there";
}

TEST_F(PostgresJournalTest, OneThatIsStoppedWithinACommitHoldsNobodyUp) {
  StandBy stand_by;
  stand_by.silence = kSilence;
  const Child child = StartChild(stand_by, "journal.commit:1:stop");
  child.Tell();
  int status = 0;
  ASSERT_EQ(waitpid(child.pid, &status, WUNTRACED), child.pid);
  ASSERT_TRUE(WIFSTOPPED(status));
  const auto journal = Open(stand_by);
  EXPECT_EQ(journal->epoch(), 2U);
  kill(child.pid, SIGCONT);
  EXPECT_EQ(child.AwaitEnd(), kExitRetryable);
  EXPECT_TRUE(journal->TakeJobs().empty()) << "what was not committed is not there";
}

TEST_F(PostgresJournalTest, SaysThatNoServerIsThere) {
  const auto journal = OpenPostgresJournal("host=/no/such/folder dbname=x");
  EXPECT_TRUE(absl::IsUnavailable(journal.status())) << journal.status();
}

}  // namespace
}  // namespace tilemend
