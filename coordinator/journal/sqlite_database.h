// What the journal needs of SQLite beyond SQLiteCpp: bytes without copies, and exceptions as absl::Status.
#ifndef TILEMEND_COORDINATOR_JOURNAL_SQLITE_DATABASE_H_
#define TILEMEND_COORDINATOR_JOURNAL_SQLITE_DATABASE_H_

#include <SQLiteCpp/SQLiteCpp.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

#include "absl/status/status.h"
#include "absl/status/statusor.h"

namespace tilemend {

// Opens or makes the file.
absl::StatusOr<SQLite::Database> OpenSqlite(const std::string& path);

// An error of this database. It names the file. It is kResourceExhausted (disk full), kDataLoss (damaged or no
// database), kAborted (locked by another), kPermissionDenied, or kInternal (a read, a write or a sync failed).
absl::Status StatusOf(const SQLite::Exception& exception, const SQLite::Database& database);

// Returns what `body` returns, or the status of the SQLite::Exception that it throws.
template <class Body>
std::invoke_result_t<Body> CatchSqlite(const SQLite::Database& database, const Body& body) {
  try {
    return body();
  } catch (const SQLite::Exception& exception) {
    return StatusOf(exception, database);
  }
}

// Returns kNotFound if there is no file of this name any more, or another than was opened. What is written here is
// then not found by whoever opens it next. One look at the file's name. Throws SQLite::Exception.
absl::Status CheckInPlace(const SQLite::Database& database);

// Parameters are counted from 1. Bytes must live until the statement has been stepped.
void BindValue(SQLite::Statement& statement, int parameter, int64_t value);
void BindValue(SQLite::Statement& statement, int parameter, std::string_view bytes);

// Resets the statement and binds the values in order. Throws SQLite::Exception, as all below.
template <class... Values>
SQLite::Statement& With(SQLite::Statement& statement, const Values&... values) {
  statement.tryReset();  // repeats the error of an earlier run, which was thrown then
  int parameter = 0;
  (BindValue(statement, ++parameter, values), ...);
  return statement;
}

// Of the row; columns are counted from 0. Bytes hold until the next step.
int64_t IntOf(const SQLite::Statement& row, int column);
std::string_view BytesOf(const SQLite::Statement& row, int column);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOURNAL_SQLITE_DATABASE_H_
