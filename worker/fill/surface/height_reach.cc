#include "worker/fill/surface/height_reach.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <vector>

#include "common/mesh/triangle_shape.h"

namespace tilemend {
namespace {

constexpr double kSteepest = 5;  // slope of the steepest ground, and of the flattest wall

// The slope of a triangle; infinite if it faces down or stands upright.
double Slope(const ThinPlateProblem& problem, const Triangle& t) {
  const Eigen::Vector3d normal = TwiceVectorArea(problem.points, t);
  return normal.z() > 0 ? normal.head<2>().norm() / normal.z() : std::numeric_limits<double>::infinity();
}

}  // namespace

bool HeightReach::HoldsUnknown(const ThinPlateProblem& problem) const {
  for (size_t v = 0; v < problem.points.size(); ++v) {
    if (!problem.known[v] && !Holds(problem.points[v].z())) return false;
  }
  return true;
}

HeightReach ReachOfRim(const ThinPlateProblem& problem) {
  HeightReach reach{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(), 0};
  Point2 lo = Point2::Constant(reach.lo), hi = -lo;
  for (const Triangle& t : problem.patch) {
    for (const int32_t v : t) {
      const Point3& p = problem.points[v];
      lo = lo.cwiseMin(p.head<2>());
      hi = hi.cwiseMax(p.head<2>());
      if (!problem.known[v]) continue;
      reach.lo = std::min(reach.lo, p.z());
      reach.hi = std::max(reach.hi, p.z());
    }
  }
  std::vector<double> slopes = {0};
  for (const Triangle& t : problem.band) {
    if (const double slope = Slope(problem, t); slope <= kSteepest) slopes.push_back(slope);
  }
  const auto middle = slopes.begin() + static_cast<std::ptrdiff_t>(slopes.size() / 2);
  std::nth_element(slopes.begin(), middle, slopes.end());
  reach.extent = (hi - lo).norm();
  const double beyond = (reach.hi - reach.lo) / 2 + *middle * reach.extent / 4;
  reach.lo -= beyond;
  reach.hi += beyond;
  return reach;
}

bool IsGround(const ThinPlateProblem& problem, const Triangle& t) { return Slope(problem, t) <= kSteepest; }

}  // namespace tilemend
