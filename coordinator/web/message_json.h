// JSON of the protocol's messages.
#ifndef TILEMEND_COORDINATOR_WEB_MESSAGE_JSON_H_
#define TILEMEND_COORDINATOR_WEB_MESSAGE_JSON_H_

#include <google/protobuf/message.h>

#include <string>

#include "absl/status/statusor.h"

namespace tilemend {

// As protobuf's JSON mapping has it, with all fields. An error's details are a google.rpc.ErrorInfo, which the program
// knows as tilemend.v1.ErrorInfo alone (status_proto.h). kInternal if it holds an Any of another type. Thread-safe.
absl::StatusOr<std::string> MessageJson(const google::protobuf::Message& message);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_WEB_MESSAGE_JSON_H_
