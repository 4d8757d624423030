#include "worker/fill/surface/thin_plate.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "common/mesh/triangle_shape.h"
#include "worker/fill/surface/direct_solver.h"
#include "worker/fill/surface/two_level_solver.h"

namespace tilemend {
namespace {

constexpr double kSteepest = 5;      // slope of the steepest ground, and of the flattest wall
constexpr int kMostTightenings = 8;  // up to 10^8 / extent^2: as good as a membrane, which never leaves its rim's range

// The slope of a triangle; infinite if it faces down or stands upright.
double Slope(const ThinPlateProblem& problem, const Triangle& t) {
  const Eigen::Vector3d normal = TwiceVectorArea(problem.points, t);
  return normal.z() > 0 ? normal.head<2>().norm() / normal.z() : std::numeric_limits<double>::infinity();
}

// Between which heights a surface over the patch is to stay.
struct Reach {
  double lo = 0, hi = 0;
  double extent = 0;  // of the patch, metres
};

Reach ReachOf(const ThinPlateProblem& problem) {
  Reach reach{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(), 0};
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

bool IsWithin(const ThinPlateProblem& problem, const Reach& reach) {
  for (size_t v = 0; v < problem.points.size(); ++v) {
    const double z = problem.points[v].z();
    if (!problem.known[v] && !(z >= reach.lo && z <= reach.hi)) return false;
  }
  return true;
}

// From about here on two levels take less time than one factorisation: with this many unknowns, and this many for each
// edge of the boundary. Graded meshes have fewer, and small separators, so that their factorisation is near-linear.
constexpr int64_t kFewUnknowns = 2000;
constexpr int64_t kFewPerBoundaryEdge = 4;

bool IsLarge(const ThinPlateProblem& problem, int64_t unknowns) {
  // Euler: a triangulated region has a triangle for each boundary edge and two for each point inside, but for a few.
  const int64_t boundary_edges = static_cast<int64_t>(problem.patch.size()) - 2 * unknowns;
  return unknowns > kFewUnknowns && unknowns > kFewPerBoundaryEdge * boundary_edges;
}

void StoreHeights(const PointValues& heights, ThinPlateProblem& problem) {
  for (size_t v = 0; v < problem.points.size(); ++v) {
    if (!problem.known[v]) problem.points[v].z() = heights[static_cast<Eigen::Index>(v)];
  }
}

}  // namespace

bool SolveMembrane(ThinPlateProblem& problem) {
  const PlateEquations equations(problem, false, 1.0);
  const std::optional<PointValues> heights = SolveDirectly(problem, equations);
  if (heights) StoreHeights(*heights, problem);
  return heights.has_value();
}

std::optional<std::vector<double>> SolveThinPlate(ThinPlateProblem& problem) {
  if (std::find(problem.known.begin(), problem.known.end(), false) == problem.known.end()) {
    return std::vector<double>(problem.points.size(), 0.0);
  }
  const PlateEquations equations(problem, true, problem.tension);
  std::optional<PointValues> heights;
  if (IsLarge(problem, equations.unknown_count())) heights = SolveInTwoLevels(problem, equations);
  if (!heights) heights = SolveDirectly(problem, equations);
  if (!heights) return std::nullopt;
  StoreHeights(*heights, problem);
  const PointValues laplacians = equations.Laplacians(*heights);
  return std::vector<double>(laplacians.begin(), laplacians.end());
}

void FreeSteepRim(ThinPlateProblem& problem) {
  for (const Triangle& t : problem.band) {
    if (Slope(problem, t) <= kSteepest) continue;
    for (const int32_t v : t) {
      if (problem.known[v]) problem.has_equation[v] = false;
    }
  }
}

std::optional<std::vector<double>> SolveWithinReach(ThinPlateProblem& problem) {
  const Reach reach = ReachOf(problem);
  auto laplacian = SolveThinPlate(problem);
  for (int k = 0; k < kMostTightenings && laplacian && !IsWithin(problem, reach); ++k) {
    problem.tension = std::max(10 * problem.tension, 10 / (reach.extent * reach.extent));
    laplacian = SolveThinPlate(problem);
  }
  return laplacian;
}

}  // namespace tilemend
