#include "coordinator/check/ground_check.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

namespace tilemend {
namespace {

// Sides: workers tell whole blocks of a raster, up to 17 of its squares beyond kSurroundingsReach.
constexpr double kFarther = 7;

}  // namespace

absl::Status CheckRimGround(const RimGround& rim, std::span<const Point3> vertices) {
  if (rim.around.empty()) return absl::OkStatus();
  if (!(rim.side >= 1)) return absl::InvalidArgumentError("squares around holes of no size");
  const auto not_before = [](const GroundSquare& a, const GroundSquare& b) {
    return std::pair(a.row, a.col) >= std::pair(b.row, b.col);
  };
  if (std::ranges::adjacent_find(rim.around, not_before) != rim.around.end()) {
    return absl::InvalidArgumentError("squares around holes in no order");
  }
  Eigen::AlignedBox2d box;
  for (const Point3& v : vertices) box.extend(v.head<2>());
  box.min().array() -= kSurroundingsReach + kFarther * rim.side;
  box.max().array() += kSurroundingsReach + kFarther * rim.side;
  const auto is_near = [&](const GroundSquare& square) {
    return box.contains(Point2((square.col + 0.5) * rim.side, (square.row + 0.5) * rim.side));
  };
  if (std::ranges::all_of(rim.around, is_near)) return absl::OkStatus();
  return absl::InvalidArgumentError("squares with ground far from the tile");
}

}  // namespace tilemend
