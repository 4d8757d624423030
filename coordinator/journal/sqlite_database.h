// A thin hold on SQLite: one connection and its statements, errors as absl::Status.
#ifndef TILEMEND_COORDINATOR_JOURNAL_SQLITE_DATABASE_H_
#define TILEMEND_COORDINATOR_JOURNAL_SQLITE_DATABASE_H_

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "absl/status/statusor.h"

struct sqlite3;
struct sqlite3_stmt;

namespace tilemend {

// Columns and parameters are counted from 0. Not thread-safe, nor are two statements of one database.
class SqliteStatement {
 public:
  // Parameters keep their values over Reset. Bytes must live until the statement has been stepped.
  SqliteStatement& Bind(int parameter, int64_t value);
  SqliteStatement& Bind(int parameter, std::string_view bytes);
  // Whether there is a row. After the last row, or an error, the statement is as before its first step.
  absl::StatusOr<bool> Step();
  // Runs a statement that gives no rows.
  absl::Status Run();
  // Leaves the rows that were not read.
  void Reset();

  // Of the row. Bytes hold until the next step.
  int64_t Int(int column) const;
  std::string_view Bytes(int column) const;

 private:
  friend class SqliteDatabase;
  struct Finalizer {
    void operator()(sqlite3_stmt* statement) const;
  };
  SqliteStatement(sqlite3_stmt* statement, std::string path) : statement_(statement), path_(std::move(path)) {}
  std::unique_ptr<sqlite3_stmt, Finalizer> statement_;
  std::string path_;  // of the database, for errors
};

class SqliteDatabase {
 public:
  // Opens or makes the file. Errors, here and above, name the file. They are kResourceExhausted (disk full), kDataLoss
  // (damaged or no database), kAborted (locked by another), kInternal (a read, a write or a sync failed).
  static absl::StatusOr<SqliteDatabase> Open(const std::string& path);

  // Statements separated by semicolons, rows dropped.
  absl::Status Run(const std::string& sql);
  // Returns kNotFound if there is no file of this name any more, or another than was opened. What is written here is
  // then not found by whoever opens it next. One look at the file's name.
  absl::Status CheckInPlace();
  // Must not outlive the database.
  absl::StatusOr<SqliteStatement> Prepare(const std::string& sql);

 private:
  struct Closer {
    void operator()(sqlite3* database) const;
  };
  SqliteDatabase(sqlite3* database, std::string path) : database_(database), path_(std::move(path)) {}
  std::unique_ptr<sqlite3, Closer> database_;
  std::string path_;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOURNAL_SQLITE_DATABASE_H_
