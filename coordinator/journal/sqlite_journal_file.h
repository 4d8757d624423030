// The file of a journal: its form, and how it is made and opened.
#ifndef TILEMEND_COORDINATOR_JOURNAL_SQLITE_JOURNAL_FILE_H_
#define TILEMEND_COORDINATOR_JOURNAL_SQLITE_JOURNAL_FILE_H_

#include <cstdint>
#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "coordinator/journal/sqlite_database.h"

namespace tilemend {

inline constexpr uint32_t kJournalApplication = 0x746d4a31;  // "tmJ1", the application id of the file
inline constexpr uint32_t kJournalVersion = 1;               // of its tables

// Opens the journal `path` for this process alone, or makes it: it then appears whole or not at all. A commit is on the
// disk when it returns. A file that is not a journal of this release is left as it is:
//   kInvalidArgument   of another program, or of a newer release
//   kDataLoss          damaged, cut off
//   kAborted           another process has it open
// and the errors of StatusOf.
absl::StatusOr<SQLite::Database> OpenJournalFile(const std::string& path);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOURNAL_SQLITE_JOURNAL_FILE_H_
