// The journal in an SQLite file.
//
// Puts are queued, and a thread commits all that are queued in one transaction: while one commit waits for the disk the
// next one gathers. So a put waits for two commits at most, and a thousand of them a second need no thousand syncs.
// Results of jobs that are over are deleted a few thousand at a time when nothing else is to do. So the start reads
// only what jobs that are not over have done.
//
// Memory: 40 bytes for each result of an earlier process, until its job is over.
#ifndef TILEMEND_COORDINATOR_JOURNAL_SQLITE_JOURNAL_H_
#define TILEMEND_COORDINATOR_JOURNAL_SQLITE_JOURNAL_H_

#include <memory>
#include <string>

#include "absl/status/statusor.h"
#include "coordinator/journal/journal.h"

namespace tilemend {

// Opens the journal `path`, or makes it. Errors as OpenJournalFile. A commit that fails later ends the process with
// kExitRetryable and a line on standard error.
absl::StatusOr<std::unique_ptr<Journal>> OpenSqliteJournal(const std::string& path);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOURNAL_SQLITE_JOURNAL_H_
