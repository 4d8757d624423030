#include "common/rpc/surface_payloads.h"

#include <cmath>

#include "absl/status/status.h"
#include "common/util/status_macros.h"

namespace tilemend {

v1::GroundTrend ToProto(const GroundTrend& trend) {
  v1::GroundTrend proto;
  proto.set_slope_x(trend.slope.x());
  proto.set_slope_y(trend.slope.y());
  proto.set_steepness(trend.steepness);
  return proto;
}

absl::StatusOr<GroundTrend> FromProto(const v1::GroundTrend& proto) {
  const GroundTrend trend{{proto.slope_x(), proto.slope_y()}, proto.steepness()};
  if (!trend.is_possible()) return absl::InvalidArgumentError("malformed ground trend");
  return trend;
}

v1::HoldOut ToProto(const HoldOut& hold_out) {
  v1::HoldOut proto;
  proto.set_tension(hold_out.tension);
  proto.set_error(hold_out.error);
  proto.set_error_at_start(hold_out.error_at_start);
  proto.set_blocks(hold_out.blocks);
  if (hold_out.walls.is_told()) *proto.mutable_walls() = ToProto(hold_out.walls);
  return proto;
}

absl::StatusOr<HoldOut> FromProto(const v1::HoldOut& proto) {
  HoldOut hold_out{proto.tension(), proto.error(), proto.error_at_start(), proto.blocks()};
  if (!(hold_out.tension >= 0) || !std::isfinite(hold_out.tension) || !std::isfinite(hold_out.error) ||
      !std::isfinite(hold_out.error_at_start) || hold_out.blocks < 0) {
    return absl::InvalidArgumentError("malformed hold-out");
  }
  if (proto.has_walls()) {
    TILEMEND_ASSIGN_OR_RETURN(hold_out.walls, FromProto(proto.walls()));
  }
  return hold_out;
}

}  // namespace tilemend
