#include "coordinator/journal/sqlite_database.h"

#include <sqlite3.h>

#include <cerrno>

#include "absl/strings/str_cat.h"
#include "common/util/text.h"

namespace tilemend {
namespace {

absl::StatusCode CodeOf(int sqlite_error) {
  switch (sqlite_error & 0xff) {
    case SQLITE_FULL:
    case SQLITE_NOMEM:
      return absl::StatusCode::kResourceExhausted;
    case SQLITE_CORRUPT:
    case SQLITE_NOTADB:
      return absl::StatusCode::kDataLoss;
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return absl::StatusCode::kAborted;
    case SQLITE_CANTOPEN:
    case SQLITE_PERM:
    case SQLITE_READONLY:
      return absl::StatusCode::kPermissionDenied;
    default:
      return absl::StatusCode::kInternal;
  }
}

// `system_error` 0: not known.
absl::Status StatusWith(const SQLite::Exception& exception, const std::string& path, int system_error) {
  const int code = exception.getExtendedErrorCode();
  std::string text = absl::StrCat(path, ": ", Printable(exception.what()), " (SQLite error ", code);
  if (system_error != 0) absl::StrAppend(&text, ", system error ", system_error);
  text += ")";
  return {CodeOf(code), text};
}

}  // namespace

absl::StatusOr<SQLite::Database> OpenSqlite(const std::string& path) {
  try {
    return SQLite::Database(path, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE | SQLite::OPEN_NOMUTEX);
  } catch (const SQLite::Exception& exception) {
    return StatusWith(exception, path, errno);  // of the open(2) that failed, since the database is closed again
  }
}

absl::Status StatusOf(const SQLite::Exception& exception, const SQLite::Database& database) {
  return StatusWith(exception, database.getFilename(), sqlite3_system_errno(database.getHandle()));
}

absl::Status CheckInPlace(const SQLite::Database& database) {
  int moved = 0;
  if (sqlite3_file_control(database.getHandle(), "main", SQLITE_FCNTL_HAS_MOVED, &moved) != SQLITE_OK) {
    throw SQLite::Exception(database.getHandle());
  }
  if (moved == 0) return absl::OkStatus();
  return absl::NotFoundError(absl::StrCat(database.getFilename(), ": the file was taken away"));
}

void BindValue(SQLite::Statement& statement, int parameter, int64_t value) { statement.bind(parameter, value); }

void BindValue(SQLite::Statement& statement, int parameter, std::string_view bytes) {
  // Null would become NULL, not a blob of no bytes.
  const void* data = bytes.data() == nullptr ? "" : bytes.data();
  statement.bindNoCopy(parameter, data, static_cast<int>(bytes.size()));
}

int64_t IntOf(const SQLite::Statement& row, int column) { return row.getColumn(column).getInt64(); }

std::string_view BytesOf(const SQLite::Statement& row, int column) {
  const SQLite::Column value = row.getColumn(column);
  const void* data = value.getBlob();
  if (data == nullptr) return {};
  return {static_cast<const char*>(data), static_cast<size_t>(value.getBytes())};
}

}  // namespace tilemend
