// What the acceptance check found, kept in the output for its page.
#ifndef TILEMEND_CLIENT_SAVED_ACCEPTANCE_H_
#define TILEMEND_CLIENT_SAVED_ACCEPTANCE_H_

#include <nlohmann/json.hpp>
#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "client/acceptance.h"

namespace tilemend {

// Writes acceptance.json into the folder `out`: AcceptanceJson with the date. A later job in the folder removes it.
// Errors of WriteFileAtomically.
absl::Status SaveAcceptance(const std::string& out, const Acceptance& acceptance, absl::Time date);

// What the page shows of it: {accepted, verdict, date, faults: [[text, count, places]]}, of each fault that was found
// the first places. null if there is none. Errors of ReadFile, and kInvalidArgument if it is no such file.
absl::StatusOr<nlohmann::ordered_json> SavedAcceptance(const std::string& out);

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_SAVED_ACCEPTANCE_H_
