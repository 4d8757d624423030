// Protobuf messages in a scratch file.
#ifndef TILEMEND_COORDINATOR_JOBS_SCRATCH_MESSAGES_H_
#define TILEMEND_COORDINATOR_JOBS_SCRATCH_MESSAGES_H_

#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/util/status_macros.h"
#include "coordinator/store/scratch_file.h"
#include "google/protobuf/message_lite.h"

namespace tilemend {

template <typename Message>
absl::StatusOr<Message> ReadMessage(const ScratchFile& scratch, const ScratchFile::Place& place) {
  TILEMEND_ASSIGN_OR_RETURN(const std::string bytes, scratch.Get(place));
  Message message;
  if (!message.ParseFromString(bytes)) return absl::InvalidArgumentError("not the expected message");
  return message;
}

inline absl::StatusOr<ScratchFile::Place> WriteMessage(ScratchFile& scratch,
                                                       const google::protobuf::MessageLite& message) {
  return scratch.Put(message.SerializeAsString());
}

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_SCRATCH_MESSAGES_H_
