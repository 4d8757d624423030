// A thin hold on PostgreSQL: one connection, integers and bytes, errors as absl::Status.
#ifndef TILEMEND_COORDINATOR_JOURNAL_POSTGRES_CONNECTION_H_
#define TILEMEND_COORDINATOR_JOURNAL_POSTGRES_CONNECTION_H_

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"

struct pg_conn;
struct pg_result;

namespace tilemend {

using PostgresValue = std::variant<int64_t, std::string_view>;  // BIGINT, BYTEA

class PostgresRows {
 public:
  int size() const;
  // Rows that were inserted, updated or deleted.
  int64_t changed() const;
  // Of columns of type BIGINT and BYTEA. Bytes hold as long as the rows.
  int64_t Int(int row, int column) const;
  std::string_view Bytes(int row, int column) const;

 private:
  friend class PostgresConnection;
  struct Clearer {
    void operator()(pg_result* result) const;
  };
  explicit PostgresRows(pg_result* result) : result_(result) {}
  std::unique_ptr<pg_result, Clearer> result_;
};

// Not thread-safe.
class PostgresConnection {
 public:
  // `where` as libpq takes it: a URI or "key=value ...". A server that is silent for ten seconds is gone. kUnavailable;
  // errors name no password.
  static absl::StatusOr<PostgresConnection> Open(const std::string& where);

  // Statements separated by semicolons. Errors here and below: kUnavailable (the connection is gone), kInternal.
  absl::Status Run(const std::string& sql);
  // One statement with $1, $2, ...; prepared once.
  absl::StatusOr<PostgresRows> Query(const std::string& sql, const std::vector<PostgresValue>& values);

 private:
  struct Closer {
    void operator()(pg_conn* connection) const;
  };
  explicit PostgresConnection(pg_conn* connection) : connection_(connection) {}
  absl::Status Error() const;

  std::unique_ptr<pg_conn, Closer> connection_;
  std::map<std::string, std::string> prepared_;  // names by statement
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOURNAL_POSTGRES_CONNECTION_H_
