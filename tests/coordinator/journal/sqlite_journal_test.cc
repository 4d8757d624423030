#include "coordinator/journal/sqlite_journal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <random>
#include <thread>

#include "absl/strings/str_cat.h"
#include "common/store/digest.h"
#include "common/util/exit_codes.h"
#include "common/util/failpoint.h"
#include "coordinator/journal/sqlite_journal_file.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class SqliteJournalTest : public ::testing::Test {
 protected:
  std::unique_ptr<Journal> Open() const {
    auto journal = OpenSqliteJournal(path_);
    EXPECT_TRUE(journal.ok()) << journal.status();
    return *std::move(journal);
  }
  static JobRecord NewJob(int64_t number) {
    return {number, absl::StrCat("request ", number), absl::StrCat("job ", number)};
  }
  static TaskName Task(int32_t col, const std::string& input = "input") { return {{col, 7}, Stage::kFill, input}; }
  static ResultRecord Inside(const std::string& content) {
    return {TaskState::kCommitted, Sha256Hex(content), content, "", {}};
  }
  static ResultRecord Blob(const std::string& digest) { return {TaskState::kCommitted, digest, std::nullopt, "", {}}; }
  // Rows of `result` in the file, once nobody has it open.
  int64_t CountResults() const {
    auto database = OpenJournalFile(path_);
    return database->execAndGet("SELECT (SELECT count(*) FROM result) + (SELECT count(*) FROM content)").getInt64();
  }

  const TemporaryFolder folder_;
  const std::string path_ = folder_ / "journal.sqlite";
};

TEST_F(SqliteJournalTest, ResultsOfOneWorkerAreDroppedForGood) {
  const auto put = [](Journal& journal) {
    journal.PutJob(NewJob(1));
    ResultRecord of_liar = Inside("lie"), blob = Blob(Sha256Hex("b")), of_good = Inside("true"), lost;
    of_liar.worker = blob.worker = "liar";
    of_good.worker = "good";
    lost.state = TaskState::kPending;
    lost.lost_workers = {"liar"};
    journal.PutResult(1, Task(1), of_liar);
    journal.PutResult(1, Task(2), blob);
    journal.PutResult(1, Task(3), of_good);
    journal.PutResult(1, Task(4), lost);
    journal.PutResult(2, Task(1), of_liar);
  };
  const auto expect = [](Journal& journal) {
    for (const int col : {1, 2}) EXPECT_FALSE(journal.Find(1, Task(col)).value().has_value());
    EXPECT_EQ(journal.Find(1, Task(3)).value()->worker, "good");
    EXPECT_EQ(journal.Find(1, Task(4)).value()->lost_workers, std::vector<std::string>{"liar"});
    EXPECT_THAT(journal.Outputs(1).value(), ::testing::IsEmpty());
  };
  {
    const auto journal = Open();
    put(*journal);
    journal->Await();
    EXPECT_FALSE(journal->Find(1, Task(3)).value().has_value()) << "it is of this process";
    ASSERT_TRUE(journal->ReadAgain(1).ok());
    EXPECT_EQ(journal->Find(1, Task(1)).value()->worker, "liar");
    journal->DropResults(1, "liar");
    ASSERT_TRUE(journal->ReadAgain(1).ok());
    expect(*journal);
    ResultRecord again = Inside("true as well");
    journal->PutResult(1, Task(1), again);
    ASSERT_TRUE(journal->ReadAgain(1).ok());
    EXPECT_EQ(journal->Find(1, Task(1)).value(), again);
    journal->PutResult(1, Task(1), ResultRecord{TaskState::kCommitted, Sha256Hex("x"), "x", "", {}, "liar"});
    journal->DropResults(1, "liar");
    journal->Await();
  }
  EXPECT_EQ(Open()->Find(1, Task(1)).value()->content, "true as well") << "what was there before";
}

TEST_F(SqliteJournalTest, JobsAreAsTheyWerePutLast) {
  {
    const auto journal = Open();
    EXPECT_TRUE(journal->TakeJobs().empty());
    journal->PutJob(NewJob(2));
    journal->PutJob(NewJob(1));
    JobRecord over = NewJob(2);
    over.over = true;
    over.body = std::string("\0ended", 6);
    journal->PutJob(over);
    journal->Await();
  }
  const std::vector<JobRecord> jobs = Open()->TakeJobs();
  ASSERT_EQ(jobs.size(), 2U);
  EXPECT_EQ(jobs[0].body, "job 1");
  EXPECT_EQ(jobs[0].request_id, "request 1");
  EXPECT_FALSE(jobs[0].over);
  EXPECT_EQ(jobs[1].body, std::string("\0ended", 6));
  EXPECT_TRUE(jobs[1].over);
  EXPECT_FALSE(jobs[1].released);
}

TEST_F(SqliteJournalTest, TheEpochGrowsWithEachOpening) {
  uint32_t last = 0;
  for (int i = 0; i < 3; ++i) {
    const uint32_t epoch = Open()->epoch();
    EXPECT_GT(epoch, last);
    last = epoch;
  }
}

TEST_F(SqliteJournalTest, ResultsAreFoundByWhatTheTaskWasAsked) {
  const ResultRecord failed{TaskState::kFailed, "", std::nullopt, "why", {}};
  const ResultRecord struck{TaskState::kPending, "", std::nullopt, "", {"w1", "w2"}};
  {
    const auto journal = Open();
    journal->PutJob(NewJob(1));
    journal->PutResult(1, Task(1), Inside("bytes"));
    journal->PutResult(1, Task(2), Blob("digest"));
    journal->PutResult(1, Task(3), failed);
    journal->PutResult(1, Task(4), struck);
    EXPECT_FALSE(journal->Find(1, Task(1))->has_value()) << "of this process";
  }
  const auto journal = Open();
  EXPECT_EQ(**journal->Find(1, Task(1)), Inside("bytes"));
  EXPECT_EQ(**journal->Find(1, Task(2)), Blob("digest"));
  EXPECT_EQ(**journal->Find(1, Task(3)), failed);
  EXPECT_EQ(**journal->Find(1, Task(4)), struck);
  EXPECT_FALSE(journal->Find(1, Task(5))->has_value());
  EXPECT_FALSE(journal->Find(1, Task(1, "another input"))->has_value());
  EXPECT_FALSE(journal->Find(2, Task(1))->has_value());
  EXPECT_FALSE(journal->Find(1, {{1, 7}, Stage::kAssemble, "input"})->has_value());
  EXPECT_THAT(*journal->Outputs(1), ElementsAre("digest"));
}

TEST_F(SqliteJournalTest, TheLastResultOfATaskCounts) {
  {
    const auto journal = Open();
    journal->PutJob(NewJob(1));
    journal->PutResult(1, Task(1), {TaskState::kPending, "", std::nullopt, "", {"w1"}});
    journal->PutResult(1, Task(1), Inside("done"));
  }
  EXPECT_EQ(**Open()->Find(1, Task(1)), Inside("done"));
}

TEST_F(SqliteJournalTest, ResultsOfJobsThatAreOverGo) {
  const std::string filler(3000, 'x');
  {
    const auto journal = Open();
    for (const int64_t number : {1, 2}) {
      journal->PutJob(NewJob(number));
      for (int i = 0; i < 3000; ++i) journal->PutResult(number, Task(i), Inside(absl::StrCat(i, filler)));
    }
    JobRecord over = NewJob(1);
    over.over = true;
    journal->PutJob(over);
  }
  const auto before = std::filesystem::file_size(path_);
  {
    // What is tidied up when nothing else is to do takes half a second to begin.
    const auto journal = Open();
    EXPECT_FALSE(journal->Find(1, Task(1))->has_value());
    for (int i = 0; i < 200 && std::filesystem::file_size(path_) >= before * 6 / 10; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    EXPECT_EQ(**journal->Find(2, Task(2999)), Inside(absl::StrCat(2999, filler)));
  }
  EXPECT_LT(std::filesystem::file_size(path_), before * 6 / 10);
  EXPECT_EQ(CountResults(), 2 * 3000);
}

TEST_F(SqliteJournalTest, WhatWasAwaitedOutlivesTheProcess) {
  const auto put_and_die = [this] {
    const auto journal = Open();
    journal->PutJob(NewJob(1));
    for (int i = 0; i < 100; ++i) journal->PutResult(1, Task(i), Inside(absl::StrCat(i)));
    journal->Await();
    ::raise(SIGKILL);
  };
  EXPECT_EXIT(put_and_die(), ::testing::KilledBySignal(SIGKILL), "");
  const auto journal = Open();
  EXPECT_EQ(journal->TakeJobs().size(), 1U);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(**journal->Find(1, Task(i)), Inside(absl::StrCat(i)));
}

// The log ends anywhere: what was committed before that place is there, in order and whole, and nothing else.
TEST_F(SqliteJournalTest, ATornTailLosesOnlyWhatWasNotCommitted) {
  const auto put_and_die = [this] {
    const auto journal = Open();
    journal->PutJob(NewJob(1));
    for (int i = 0; i < 20; ++i) {
      journal->PutResult(1, Task(i), Inside(absl::StrCat(i)));
      journal->Await();
    }
    ::raise(SIGKILL);
  };
  EXPECT_EXIT(put_and_die(), ::testing::KilledBySignal(SIGKILL), "");
  const std::string file = ReadFile(path_).value(), log = ReadFile(path_ + "-wal").value();
  std::mt19937 random(1);
  for (int cut = 0; cut < 40; ++cut) {
    folder_.Write("journal.sqlite", file);
    std::string torn = log.substr(0, random() % log.size());
    if (cut % 2 == 1) torn += std::string(random() % 5000, 'x');
    folder_.Write("journal.sqlite-wal", torn);
    const auto journal = Open();
    int known = 0;
    while (known < 20 && journal->Find(1, Task(known))->has_value()) ++known;
    for (int i = 0; i < 20; ++i) {
      const auto found = journal->Find(1, Task(i));
      ASSERT_EQ(found->has_value(), i < known);
      if (i < known) {
        EXPECT_EQ(**found, Inside(absl::StrCat(i)));
      }
    }
    EXPECT_TRUE(known == 0 || journal->TakeJobs().size() == 1);
  }
}

TEST_F(SqliteJournalTest, DamageInAResultIsFound) {
  {
    const auto journal = Open();
    journal->PutJob(NewJob(1));
    journal->PutResult(1, Task(1), Inside("the content of the first"));
    journal->PutResult(1, Task(2), {TaskState::kFailed, "", std::nullopt, "the error of the second", {}});
  }
  std::string bytes = ReadFile(path_).value();
  for (const char* part : {"content of", "error of"}) bytes.replace(bytes.find(part), 3, "???");
  folder_.Write("journal.sqlite", bytes);
  const auto journal = Open();
  for (const int task : {1, 2}) {
    const absl::Status status = journal->Find(1, Task(task)).status();
    EXPECT_TRUE(absl::IsDataLoss(status)) << status;
    EXPECT_THAT(std::string(status.message()), HasSubstr(path_));
  }
}

TEST_F(SqliteJournalTest, DamageInAJobIsToldOfThatJob) {
  {
    const auto journal = Open();
    journal->PutJob(NewJob(1));
    journal->PutJob(NewJob(3));
  }
  std::string bytes = ReadFile(path_).value();
  bytes.replace(bytes.find("job 1"), 5, "job 2");
  folder_.Write("journal.sqlite", bytes);
  const std::vector<JobRecord> jobs = Open()->TakeJobs();
  ASSERT_EQ(jobs.size(), 2U);
  EXPECT_EQ(jobs[0].number, 1);
  EXPECT_TRUE(jobs[0].damaged);
  EXPECT_FALSE(jobs[1].damaged);
}

TEST_F(SqliteJournalTest, ADroppedJobIsGone) {
  {
    const auto journal = Open();
    journal->PutJob(NewJob(1));
    journal->PutJob(NewJob(2));
    journal->DropJob(1);
  }
  const std::vector<JobRecord> jobs = Open()->TakeJobs();
  ASSERT_EQ(jobs.size(), 1U);
  EXPECT_EQ(jobs[0].number, 2);
}

TEST_F(SqliteJournalTest, KeepsWhoIsSetAside) {
  {
    const auto journal = Open();
    for (const char* worker : {"a", "b"}) journal->PutSetAside({worker, "lied"});
    journal->PutSetAside({"b", "lied again"});
    journal->PutSetAside({"a", ""});
  }
  EXPECT_THAT(Open()->TakeSetAside(), ElementsAre(SetAsideRecord{"b", "lied again"}));
}

TEST_F(SqliteJournalTest, AJournalOfBeforeGetsTheTablesItLacks) {
  { Open()->PutJob(NewJob(1)); }
  OpenJournalFile(path_)->exec("DROP TABLE aside");
  const auto journal = Open();
  EXPECT_EQ(journal->TakeJobs().size(), 1U);
  EXPECT_TRUE(journal->TakeSetAside().empty());
}

TEST_F(SqliteJournalTest, ACommitThatFailsEndsTheProcess) {
  const auto fail = [this] {
    const auto journal = Open();
    if (!ArmFailPoint("journal.commit:1:error").ok()) return;
    journal->PutJob(NewJob(1));
    journal->Await();
    std::fprintf(stderr, "went on\n");
    ::_exit(0);
  };
  EXPECT_EXIT(fail(), ::testing::ExitedWithCode(kExitRetryable), "cannot be written: .*journal.sqlite: a sync failed");
  EXPECT_TRUE(Open()->TakeJobs().empty());
}

// Whoever deletes the work folder under a coordinator, or moves it away: no restart finds what would go on there.
TEST_F(SqliteJournalTest, ACommitToAFileThatWasTakenAwayEndsTheProcess) {
  const auto put_after = [](const std::string& folder, const std::function<void()>& taken_away) {
    std::filesystem::create_directories(folder);
    const auto journal = OpenSqliteJournal(folder + "/journal.sqlite");
    if (!journal.ok()) return;
    (*journal)->PutJob(NewJob(1));
    (*journal)->Await();
    taken_away();
    (*journal)->PutJob(NewJob(2));
    (*journal)->Await();
    std::fprintf(stderr, "went on\n");
    ::_exit(0);
  };
  const auto ends = ::testing::ExitedWithCode(kExitRetryable);
  const char* const reason = "cannot be written: .*journal.sqlite: the file was taken away";
  const std::string moved = folder_ / "moved", deleted = folder_ / "deleted", replaced = folder_ / "replaced";
  EXPECT_EXIT(put_after(moved, [&] { std::filesystem::rename(moved, moved + ".away"); }), ends, reason);
  EXPECT_EXIT(put_after(deleted, [&] { std::filesystem::remove_all(deleted); }), ends, reason);
  const auto replace = [&] {
    std::filesystem::rename(replaced, replaced + ".away");
    std::filesystem::create_directories(replaced);
    std::ofstream(replaced + "/journal.sqlite") << "another";
  };
  EXPECT_EXIT(put_after(replaced, replace), ends, reason);
}

TEST_F(SqliteJournalTest, ManyThreadsShareCommits) {
  {
    const auto journal = Open();
    journal->PutJob(NewJob(1));
    std::vector<std::thread> threads;
    for (int t = 0; t < 8; ++t) {
      threads.emplace_back([&journal, t] {
        for (int i = 0; i < 50; ++i) {
          journal->PutResult(1, Task(100 * t + i), Blob("d"));
          journal->Await();
        }
      });
    }
    for (std::thread& thread : threads) thread.join();
  }
  const auto journal = Open();
  for (int t = 0; t < 8; ++t) {
    for (int i = 0; i < 50; ++i) EXPECT_TRUE(journal->Find(1, Task(100 * t + i))->has_value());
  }
}

}  // namespace
}  // namespace tilemend
