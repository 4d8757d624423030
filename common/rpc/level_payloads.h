// What became of the levels of detail of a tile, to payload messages and back.
#ifndef TILEMEND_COMMON_RPC_LEVEL_PAYLOADS_H_
#define TILEMEND_COMMON_RPC_LEVEL_PAYLOADS_H_

#include <vector>

#include "absl/status/statusor.h"
#include "common/records/level_counts.h"
#include "google/protobuf/repeated_field.h"
#include "tilemend/v1/stages.pb.h"

namespace tilemend {

// Without the number of nodes, which the survey tells.
inline v1::LevelChange ToProto(const LevelCounts& level) {
  v1::LevelChange proto;
  proto.set_filled(level.filled);
  proto.set_added(level.added);
  proto.set_removed(level.removed);
  return proto;
}

// kInvalidArgument for counts below 0.
inline absl::StatusOr<std::vector<LevelCounts>> FromProto(
    const google::protobuf::RepeatedPtrField<v1::LevelChange>& protos) {
  std::vector<LevelCounts> levels;
  for (const v1::LevelChange& proto : protos) {
    if (proto.filled() < 0 || proto.added() < 0 || proto.removed() < 0) {
      return absl::InvalidArgumentError("malformed payload: counts of a level below 0");
    }
    levels.push_back({0, proto.filled(), proto.added(), proto.removed()});
  }
  return levels;
}

}  // namespace tilemend

#endif  // TILEMEND_COMMON_RPC_LEVEL_PAYLOADS_H_
