// Smoothed points to payload messages and back.
#ifndef TILEMEND_COMMON_RPC_SMOOTHED_PAYLOADS_H_
#define TILEMEND_COMMON_RPC_SMOOTHED_PAYLOADS_H_

#include <cstdint>
#include <vector>

#include "absl/status/statusor.h"
#include "common/records/cell_holes.h"
#include "tilemend/v1/stages.pb.h"

namespace tilemend {

v1::SmoothedPoints ToProto(const std::vector<SmoothedPoint>& points);
// kInvalidArgument for columns of unequal length, a point that is none of the first `point_count`, or a height that is
// no number.
absl::StatusOr<std::vector<SmoothedPoint>> FromProto(const v1::SmoothedPoints& proto, int64_t point_count);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_RPC_SMOOTHED_PAYLOADS_H_
