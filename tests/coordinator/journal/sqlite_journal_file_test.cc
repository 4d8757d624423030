#include "coordinator/journal/sqlite_journal_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "absl/strings/str_cat.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;

class SqliteJournalFileTest : public ::testing::Test {
 protected:
  // Opens what is there, which is refused and stays as it is.
  absl::Status Refusal() const {
    const std::string before = ReadFile(path_).value();
    absl::Status status = OpenJournalFile(path_).status();
    EXPECT_THAT(std::string(status.message()), HasSubstr(path_));
    EXPECT_TRUE(ReadFile(path_).value() == before) << "it was changed";
    EXPECT_FALSE(std::filesystem::exists(path_ + "-wal"));
    return status;
  }
  void Make() const { ASSERT_TRUE(OpenJournalFile(path_).ok()); }

  const TemporaryFolder folder_;
  const std::string path_ = folder_ / "journal.sqlite";
};

TEST_F(SqliteJournalFileTest, IsMadeAndOpenedAgain) {
  for (int i = 0; i < 2; ++i) {
    auto database = OpenJournalFile(path_);
    ASSERT_TRUE(database.ok()) << database.status();
    database->exec("UPDATE epoch SET value = value + 1");
  }
  auto database = OpenJournalFile(path_);
  EXPECT_EQ(database->execAndGet("SELECT value FROM epoch").getInt64(), 2);
  EXPECT_FALSE(std::filesystem::exists(path_ + "-new"));
}

TEST_F(SqliteJournalFileTest, TheRestOfOneThatWasBeingMadeIsNoHindrance) {
  folder_.Write("journal.sqlite-new", "half");
  folder_.Write("journal.sqlite-wal", "of nothing");
  auto database = OpenJournalFile(path_);
  ASSERT_TRUE(database.ok()) << database.status();
  EXPECT_EQ(database->execAndGet("SELECT count(*) FROM job").getInt64(), 0);
}

TEST_F(SqliteJournalFileTest, CommitsAreSynced) {
  auto database = OpenJournalFile(path_);
  const std::pair<const char*, std::string> settings[] = {
      {"journal_mode", "wal"}, {"locking_mode", "exclusive"}, {"synchronous", "2"}, {"mmap_size", "0"}};
  for (const auto& [name, value] : settings) {
    EXPECT_EQ(database->execAndGet(absl::StrCat("PRAGMA ", name)).getString(), value) << name;
  }
}

TEST_F(SqliteJournalFileTest, AnotherProcessIsKeptOut) {
  const auto first = OpenJournalFile(path_);
  ASSERT_TRUE(first.ok());
  EXPECT_TRUE(absl::IsAborted(OpenJournalFile(path_).status()));
}

TEST_F(SqliteJournalFileTest, RefusesAFileOfAnotherProgram) {
  folder_.Write("journal.sqlite", std::string(5000, 'x'));
  EXPECT_TRUE(absl::IsInvalidArgument(Refusal()));
}

TEST_F(SqliteJournalFileTest, RefusesADatabaseOfAnotherProgram) {
  OpenSqlite(path_)->exec("CREATE TABLE job(number)");
  EXPECT_TRUE(absl::IsInvalidArgument(Refusal()));
}

TEST_F(SqliteJournalFileTest, RefusesANewerRelease) {
  Make();
  OpenSqlite(path_)->exec("PRAGMA user_version=2; PRAGMA wal_checkpoint(TRUNCATE)");
  const absl::Status status = Refusal();
  EXPECT_TRUE(absl::IsInvalidArgument(status)) << status;
  EXPECT_THAT(std::string(status.message()), HasSubstr("version 2"));
}

TEST_F(SqliteJournalFileTest, RefusesOneThatIsCutOff) {
  folder_.Write("journal.sqlite", "");
  EXPECT_TRUE(absl::IsDataLoss(Refusal()));
}

TEST_F(SqliteJournalFileTest, RefusesDamage) {
  Make();
  std::string bytes = ReadFile(path_).value();
  bytes.replace(100, bytes.size() - 100, std::string(bytes.size() - 100, 'x'));
  folder_.Write("journal.sqlite", bytes);
  const absl::Status status = OpenJournalFile(path_).status();
  EXPECT_TRUE(absl::IsDataLoss(status)) << status;
  EXPECT_TRUE(ReadFile(path_).value() == bytes) << "it was changed";
}

}  // namespace
}  // namespace tilemend
