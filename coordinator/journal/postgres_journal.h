// A journal in PostgreSQL, for coordinators of which one is at work and the others stand by.
//
// The one that is at work says so every second. When it has been silent for some time, one of the others takes the next
// epoch and goes on with what is there. Every commit reads the epoch in the same transaction. So a coordinator that was
// stopped, or cut off, and comes back is refused at its next write and ends. One that is stopped within a commit loses
// its connection, and with it the commit, after the same time.
#ifndef TILEMEND_COORDINATOR_JOURNAL_POSTGRES_JOURNAL_H_
#define TILEMEND_COORDINATOR_JOURNAL_POSTGRES_JOURNAL_H_

#include <functional>
#include <memory>
#include <string>

#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "coordinator/journal/journal.h"

namespace tilemend {

struct StandBy {
  absl::Duration silence = absl::Seconds(10);         // > 2 s, of the one at work, by the server's clock
  std::function<void()> waits = [] {};                // called once, if another is at work
  std::function<bool()> ends = [] { return false; };  // asked twice a second meanwhile
};

// Makes missing tables (tilemend_...) in the database `where`, as PostgresConnection::Open takes it, and waits until no
// other is at work. Errors: kCancelled if `ends`; kUnavailable, kInternal. A commit that fails later, or is refused,
// ends the process with kExitRetryable and a line on standard error.
//
// Looking a result up takes one round trip. The database's own checksums stand for those of the file of
// sqlite_journal.h.
absl::StatusOr<std::unique_ptr<Journal>> OpenPostgresJournal(const std::string& where, const StandBy& stand_by = {});

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOURNAL_POSTGRES_JOURNAL_H_
