#include "coordinator/journal/postgres_connection.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>

#include "tests/support/postgres_server.h"

namespace tilemend {
namespace {

TEST(PostgresConnectionTest, IntegersAndBytesComeBackAsTheyWereSent) {
  if (PostgresServer::Programs().empty()) GTEST_SKIP() << "PostgreSQL is not installed";
  const PostgresServer server;
  auto connection = PostgresConnection::Open(server.where());
  ASSERT_TRUE(connection.ok()) << connection.status();
  ASSERT_TRUE(connection->Run("CREATE TABLE t(a BIGINT, b BYTEA); SELECT 1").ok());
  const std::string bytes("x\0\xff", 3);
  for (const int64_t value : {std::numeric_limits<int64_t>::min(), int64_t{-1}, std::numeric_limits<int64_t>::max()}) {
    EXPECT_EQ(connection->Query("INSERT INTO t VALUES($1, $2)", {value, bytes})->changed(), 1);
    const auto rows = connection->Query("SELECT a, b FROM t WHERE a = $1", {value});
    ASSERT_TRUE(rows.ok()) << rows.status();
    ASSERT_EQ(rows->size(), 1);
    EXPECT_EQ(rows->Int(0, 0), value);
    EXPECT_EQ(rows->Bytes(0, 1), bytes);
  }
  EXPECT_EQ(connection->Run("no statement").code(), absl::StatusCode::kInternal);
  EXPECT_TRUE(connection->Run("SELECT 1").ok()) << "an error ends no connection";
}

}  // namespace
}  // namespace tilemend
