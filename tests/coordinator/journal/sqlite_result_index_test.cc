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
    auto put = database_.Prepare("INSERT INTO result VALUES(?,?,?,1,'output',?,'','','')").value();
    const std::string name = NameOf(NamedBy(col));
    ASSERT_TRUE(put.Bind(0, number).Bind(1, job).Bind(2, name).Bind(3, inside).Run().ok());
  }

  const TemporaryFolder folder_;
  SqliteDatabase database_ = OpenJournalFile(folder_ / "journal.sqlite").value();
  SqliteResultIndex index_;
};

TEST_F(SqliteResultIndexTest, FindsTheLastRowOfATaskOfTheJobsThatAreAskedFor) {
  Put(1, 1, 0, 1);
  Put(2, 1, 0, 0);
  Put(3, 2, 0, 0);
  EXPECT_EQ(index_.ReadAll(database_, {1}).value(), 3);
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
  ASSERT_TRUE(index_.ReadAll(database_, {1}).ok());
  ASSERT_TRUE(database_.Run("DELETE FROM result").ok());
  Put(7, 1, 1, 0);
  ASSERT_TRUE(index_.ReadJob(database_, 1).ok());
  EXPECT_EQ(index_.Find(1, NamedBy(0)), std::nullopt);
  EXPECT_EQ(index_.Find(1, NamedBy(1)), 7);
  EXPECT_THAT(index_.BlobsOf(1), ElementsAre(7));
}

}  // namespace
}  // namespace tilemend
