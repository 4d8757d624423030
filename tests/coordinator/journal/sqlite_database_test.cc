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
  auto database = OpenSqlite(folder_ / "a");
  ASSERT_TRUE(database.ok()) << database.status();
  database->exec("CREATE TABLE t(a INTEGER PRIMARY KEY, b BLOB NOT NULL)");
  SQLite::Statement insert(*database, "INSERT INTO t VALUES(?,?)");
  const std::string bytes("\0 and ' and \xff", 13);
  With(insert, int64_t{1}, bytes).exec();
  With(insert, int64_t{1} << 60, std::string_view()).exec();
  SQLite::Statement select(*database, "SELECT a, b, typeof(b) FROM t WHERE a >= ? ORDER BY a");
  for (int i = 0; i < 2; ++i) {
    With(select, int64_t{1});
    ASSERT_TRUE(select.executeStep());
    EXPECT_EQ(IntOf(select, 0), 1);
    EXPECT_EQ(BytesOf(select, 1), bytes);
    EXPECT_EQ(BytesOf(select, 2), "blob") << "text would not be equal to it in SQL";
    ASSERT_TRUE(select.executeStep());
    EXPECT_EQ(IntOf(select, 0), int64_t{1} << 60);
    EXPECT_EQ(BytesOf(select, 1), "");
    EXPECT_FALSE(select.executeStep());
  }
}

TEST_F(SqliteDatabaseTest, AStatementRunsAgainAfterAnError) {
  auto database = OpenSqlite(folder_ / "a");
  ASSERT_TRUE(database.ok()) << database.status();
  database->exec("CREATE TABLE t(a INTEGER PRIMARY KEY)");
  SQLite::Statement insert(*database, "INSERT INTO t VALUES(?)");
  const auto put = [&](int64_t value) {
    return CatchSqlite(*database, [&] {
      With(insert, value).exec();
      return absl::OkStatus();
    });
  };
  EXPECT_TRUE(put(1).ok());
  EXPECT_TRUE(absl::IsInternal(put(1)));
  EXPECT_TRUE(put(2).ok());
}

TEST_F(SqliteDatabaseTest, ErrorsNameTheFile) {
  const std::string path = folder_.Write("text", std::string(5000, 'x'));
  auto database = OpenSqlite(path);
  ASSERT_TRUE(database.ok()) << "SQLite looks when it reads";
  const auto run = [&](const char* sql) {
    return CatchSqlite(*database, [&] {
      database->exec(sql);
      return absl::OkStatus();
    });
  };
  const absl::Status status = run("SELECT * FROM sqlite_schema");
  EXPECT_TRUE(absl::IsDataLoss(status)) << status;
  EXPECT_THAT(std::string(status.message()), HasSubstr(path));
  EXPECT_TRUE(absl::IsInternal(run("SELEKT 1")));
  const absl::Status nowhere = OpenSqlite(folder_ / "no/folder").status();
  EXPECT_TRUE(absl::IsPermissionDenied(nowhere));
  EXPECT_THAT(std::string(nowhere.message()),
              HasSubstr("no/folder: unable to open database file (SQLite error 14, system error 2)"));
}

TEST_F(SqliteDatabaseTest, MissesItsFile) {
  const std::string path = folder_ / "a", away = folder_ / "b";
  auto database = OpenSqlite(path);
  database->exec("CREATE TABLE t(a)");
  EXPECT_TRUE(CheckInPlace(*database).ok());
  std::filesystem::rename(path, away);
  EXPECT_TRUE(absl::IsNotFound(CheckInPlace(*database)));
  std::filesystem::rename(away, path);
  EXPECT_TRUE(CheckInPlace(*database).ok());
}

}  // namespace
}  // namespace tilemend
