#include "coordinator/journal/sqlite_database.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;

class SqliteDatabaseTest : public ::testing::Test {
 protected:
  const TemporaryFolder folder_;
};

TEST_F(SqliteDatabaseTest, GivesBackNumbersAndBytes) {
  auto database = SqliteDatabase::Open(folder_ / "a");
  ASSERT_TRUE(database.ok()) << database.status();
  ASSERT_TRUE(database->Run("CREATE TABLE t(a INTEGER PRIMARY KEY, b BLOB NOT NULL)").ok());
  auto insert = database->Prepare("INSERT INTO t VALUES(?,?)");
  const std::string bytes("\0 and ' and \xff", 13);
  ASSERT_TRUE(insert->Bind(0, 1).Bind(1, bytes).Run().ok());
  ASSERT_TRUE(insert->Bind(0, 1LL << 60).Bind(1, std::string_view()).Run().ok());
  auto select = database->Prepare("SELECT a, b FROM t ORDER BY a");
  ASSERT_TRUE(*select->Step());
  EXPECT_EQ(select->Int(0), 1);
  EXPECT_EQ(select->Bytes(1), bytes);
  ASSERT_TRUE(*select->Step());
  EXPECT_EQ(select->Int(0), 1LL << 60);
  EXPECT_EQ(select->Bytes(1), "");
  EXPECT_FALSE(*select->Step());
  ASSERT_TRUE(*select->Step()) << "from the beginning";
}

TEST_F(SqliteDatabaseTest, ErrorsNameTheFile) {
  const std::string path = folder_.Write("text", std::string(5000, 'x'));
  auto database = SqliteDatabase::Open(path);
  ASSERT_TRUE(database.ok()) << "SQLite looks when it reads";
  const absl::Status status = database->Run("SELECT * FROM sqlite_schema");
  EXPECT_TRUE(absl::IsDataLoss(status)) << status;
  EXPECT_THAT(std::string(status.message()), HasSubstr(path));
  EXPECT_TRUE(absl::IsPermissionDenied(SqliteDatabase::Open(folder_ / "no/folder").status()));
  auto other = SqliteDatabase::Open(folder_ / "b");
  EXPECT_TRUE(absl::IsInternal(other->Prepare("SELEKT 1").status()));
}

TEST_F(SqliteDatabaseTest, MissesItsFile) {
  const std::string path = folder_ / "a", away = folder_ / "b";
  auto database = SqliteDatabase::Open(path);
  ASSERT_TRUE(database->Run("CREATE TABLE t(a)").ok());
  EXPECT_TRUE(database->CheckInPlace().ok());
  std::filesystem::rename(path, away);
  EXPECT_TRUE(absl::IsNotFound(database->CheckInPlace()));
  std::filesystem::rename(away, path);
  EXPECT_TRUE(database->CheckInPlace().ok());
}

}  // namespace
}  // namespace tilemend
