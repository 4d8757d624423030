#include "coordinator/journal/sqlite_journal_file.h"

#include <filesystem>
#include <fstream>
#include <string_view>
#include <system_error>

#include "absl/strings/str_cat.h"
#include "common/util/failpoint.h"
#include "common/util/files.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

namespace fs = std::filesystem;

// `name` of a result: a digest of what the task is asked. `sum` of a row: a digest of its other columns.
constexpr char kSqliteTables[] = R"(
CREATE TABLE epoch(value INTEGER NOT NULL);
INSERT INTO epoch VALUES(0);
CREATE TABLE job(number INTEGER PRIMARY KEY, request_id BLOB NOT NULL, body BLOB NOT NULL, over INTEGER NOT NULL,
                 released INTEGER NOT NULL, sum BLOB NOT NULL);
CREATE TABLE result(number INTEGER PRIMARY KEY, job INTEGER NOT NULL, name BLOB NOT NULL, state INTEGER NOT NULL,
                    output BLOB NOT NULL, inside INTEGER NOT NULL, error BLOB NOT NULL, lost_workers BLOB NOT NULL,
                    sum BLOB NOT NULL);
CREATE TABLE content(result INTEGER PRIMARY KEY, bytes BLOB NOT NULL);
)";

// What the journal of an earlier release may lack.
constexpr char kLaterTables[] =
    "CREATE TABLE IF NOT EXISTS aside(worker BLOB PRIMARY KEY, reason BLOB NOT NULL, sum BLOB NOT NULL);";

// Exclusive before anything is read: then no memory is shared with other processes, and there are none.
constexpr char kSettings[] = R"(
PRAGMA locking_mode=EXCLUSIVE;
PRAGMA journal_mode=WAL;
PRAGMA synchronous=FULL;
PRAGMA mmap_size=0;
PRAGMA cell_size_check=ON;
PRAGMA journal_size_limit=67108864;
)";

// The first bytes of the file, of https://www.sqlite.org/fileformat2.html, 1.3.
constexpr std::string_view kMagic("SQLite format 3\0", 16);
constexpr size_t kVersionAt = 60, kApplicationAt = 68, kHeaderBytes = 100;

uint32_t BigEndian(std::string_view header, size_t at) {
  uint32_t value = 0;
  for (size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(header[at + i]);
  return value;
}

// Looked at before SQLite may: opening a database can change it.
absl::Status CheckHeader(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string header(kHeaderBytes, '\0');
  file.read(header.data(), kHeaderBytes);
  constexpr char kAdvice[] = "; nothing was changed. Move it away or choose another --work";
  if (!file.is_open()) return absl::PermissionDeniedError(absl::StrCat(path, ": cannot read it", kAdvice));
  if (static_cast<size_t>(file.gcount()) < kHeaderBytes) {
    return absl::DataLossError(absl::StrCat(path, ": cut off after ", file.gcount(), " bytes", kAdvice));
  }
  if (!header.starts_with(kMagic) || BigEndian(header, kApplicationAt) != kJournalApplication) {
    return absl::InvalidArgumentError(absl::StrCat(path, ": not a journal of tilemend", kAdvice));
  }
  const uint32_t version = BigEndian(header, kVersionAt);
  if (version == kJournalVersion) return absl::OkStatus();
  return absl::InvalidArgumentError(absl::StrCat(path, ": its tables have version ", version, ", this release knows ",
                                                 kJournalVersion, "; use the release that wrote it"));
}

absl::Status Make(const std::string& path) {
  const std::string made = path + "-new";
  std::error_code ignored;
  for (const char* suffix : {"", "-journal"}) fs::remove(made + suffix, ignored);
  {
    TILEMEND_ASSIGN_OR_RETURN(SQLite::Database database, OpenSqlite(made));
    TILEMEND_RETURN_IF_ERROR(CatchSqlite(database, [&] {
      database.exec(absl::StrCat(
          "PRAGMA synchronous=FULL; PRAGMA auto_vacuum=INCREMENTAL; PRAGMA application_id=", kJournalApplication,
          "; PRAGMA user_version=", kJournalVersion, "; BEGIN;", kSqliteTables, "COMMIT;"));
      return absl::OkStatus();
    }));
  }
  FailPoint("journal.make");
  // A write-ahead log without its database is of no use, and must not be taken for that of the new one.
  fs::remove(path + "-wal", ignored);
  fs::rename(made, path, ignored);
  if (ignored) return absl::PermissionDeniedError(absl::StrCat(path, ": cannot make it: ", ignored.message()));
  return SyncFolder(fs::path(path).parent_path());
}

}  // namespace

absl::StatusOr<SQLite::Database> OpenJournalFile(const std::string& path) {
  std::error_code error;
  const bool is_there = fs::exists(fs::symlink_status(path, error));
  TILEMEND_RETURN_IF_ERROR(is_there ? CheckHeader(path) : Make(path));
  TILEMEND_ASSIGN_OR_RETURN(SQLite::Database database, OpenSqlite(path));
  TILEMEND_RETURN_IF_ERROR(CatchSqlite(database, [&] {
    database.exec(kSettings);
    // What an earlier process wrote last goes from the log into the file, and is on the disk.
    database.exec("PRAGMA wal_checkpoint(TRUNCATE);");
    database.exec(kLaterTables);
    return absl::OkStatus();
  }));
  return database;
}

}  // namespace tilemend
