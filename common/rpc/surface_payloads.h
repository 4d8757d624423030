// What was chosen for the surface of a hole, to messages and back.
#ifndef TILEMEND_COMMON_RPC_SURFACE_PAYLOADS_H_
#define TILEMEND_COMMON_RPC_SURFACE_PAYLOADS_H_

#include "absl/status/statusor.h"
#include "common/records/cell_holes.h"
#include "tilemend/v1/stages.pb.h"

namespace tilemend {

// Decoding gives kInvalidArgument for what no worker can have found: a number that is none, a negative tension, ground
// that is steeper than a wall.
v1::GroundTrend ToProto(const GroundTrend& trend);
absl::StatusOr<GroundTrend> FromProto(const v1::GroundTrend& proto);

v1::HoldOut ToProto(const HoldOut& hold_out);
absl::StatusOr<HoldOut> FromProto(const v1::HoldOut& proto);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_RPC_SURFACE_PAYLOADS_H_
