#include "coordinator/journal/sqlite_result_index.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "coordinator/journal/sqlite_journal_file.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

class SqliteResultIndexTest : public ::testing::Test {
 protected:
  static TaskName NamedBy(int32_t col) { return {{col, 0}, Stage::kFill, "input"}; }
  void Put(int64_t number, int64_t job, int32_t col, int64_t inside) {
    SQLite::Statement put(database_, "INSERT INTO result VALUES(?,?,?,1,'output',?,'','','')");
    const std::string name = NameOf(NamedBy(col));
    With(put, number, job, name, inside).exec();
  }

  const TemporaryFolder folder_;
  SQLite::Database database_ = OpenJournalFile(folder_ / "journal.sqlite").value();
  SqliteResultIndex index_;
};

TEST_F(SqliteResultIndexTest, FindsTheLastRowOfATaskOfTheJobsThatAreAskedFor) {
  Put(1, 1, 0, 1);
  Put(2, 1, 0, 0);
  Put(3, 2, 0, 0);
  EXPECT_EQ(index_.ReadAll(database_, {1}), 3);
  EXPECT_EQ(index_.Find(1, NamedBy(0)), 2);
  EXPECT_EQ(index_.Find(1, NamedBy(1)), std::nullopt);
  EXPECT_EQ(index_.Find(2, NamedBy(0)), std::nullopt);
  EXPECT_THAT(index_.BlobsOf(1), ElementsAre(2));
  index_.Forget(1);
  EXPECT_EQ(index_.Find(1, NamedBy(0)), std::nullopt);
  EXPECT_THAT(index_.BlobsOf(1), IsEmpty());
}

TEST_F(SqliteResultIndexTest, AJobIsReadAgain) {
  Put(1, 1, 0, 0);
  index_.ReadAll(database_, {1});
  database_.exec("DELETE FROM result");
  Put(7, 1, 1, 0);
  index_.ReadJob(database_, 1);
  EXPECT_EQ(index_.Find(1, NamedBy(0)), std::nullopt);
  EXPECT_EQ(index_.Find(1, NamedBy(1)), 7);
  EXPECT_THAT(index_.BlobsOf(1), ElementsAre(7));
}

}  // namespace
}  // namespace tilemend
