#include "common/rpc/smoothed_payloads.h"

#include <cmath>

#include "absl/status/status.h"

namespace tilemend {

v1::SmoothedPoints ToProto(const std::vector<SmoothedPoint>& points) {
  v1::SmoothedPoints proto;
  for (const SmoothedPoint& p : points) {
    proto.add_point(p.point);
    proto.add_height(p.height);
  }
  return proto;
}

absl::StatusOr<std::vector<SmoothedPoint>> FromProto(const v1::SmoothedPoints& proto, int64_t point_count) {
  if (proto.height_size() != proto.point_size()) {
    return absl::InvalidArgumentError("malformed payload: smoothed points in columns of unequal length");
  }
  std::vector<SmoothedPoint> points;
  for (int i = 0; i < proto.point_size(); ++i) {
    const SmoothedPoint p{proto.point(i), proto.height(i)};
    if (p.point < 0 || p.point >= point_count || !std::isfinite(p.height)) {
      return absl::InvalidArgumentError("malformed payload: smoothed point");
    }
    points.push_back(p);
  }
  return points;
}

}  // namespace tilemend
