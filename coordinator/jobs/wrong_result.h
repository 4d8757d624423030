// The status of a result that no sound worker gives.
#ifndef TILEMEND_COORDINATOR_JOBS_WRONG_RESULT_H_
#define TILEMEND_COORDINATOR_JOBS_WRONG_RESULT_H_

#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"

namespace tilemend {

inline absl::Status Wrong(const std::string& what) { return absl::DataLossError(what); }

// The worker's fault, whatever the code.
inline absl::Status AsWrong(const absl::Status& status) {
  return status.ok() ? status : Wrong(std::string(status.message()));
}

template <typename Message>
absl::StatusOr<Message> ParseResult(const std::string& bytes) {
  Message message;
  if (!message.ParseFromString(bytes)) return Wrong("not the expected message");
  return message;
}

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_WRONG_RESULT_H_
