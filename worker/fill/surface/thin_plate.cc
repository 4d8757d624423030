#include "worker/fill/surface/thin_plate.h"

#include <algorithm>

#include "worker/fill/surface/direct_solver.h"
#include "worker/fill/surface/height_reach.h"
#include "worker/fill/surface/two_level_solver.h"

namespace tilemend {
namespace {

constexpr int kMostTightenings = 8;  // up to 10^8 / extent^2: as good as a membrane, which never leaves its rim's range

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
  if (!heights && !problem.cancelled()) heights = SolveDirectly(problem, equations);
  if (!heights) return std::nullopt;
  StoreHeights(*heights, problem);
  const PointValues laplacians = equations.Laplacians(*heights);
  return std::vector<double>(laplacians.begin(), laplacians.end());
}

void FreeSteepRim(ThinPlateProblem& problem) {
  for (const Triangle& t : problem.band) {
    if (IsGround(problem, t)) continue;
    for (const int32_t v : t) {
      if (problem.known[v]) problem.has_equation[v] = false;
    }
  }
}

std::optional<std::vector<double>> SolveWithinReach(ThinPlateProblem& problem) {
  const HeightReach reach = ReachOfRim(problem);
  auto laplacian = SolveThinPlate(problem);
  for (int k = 0; k < kMostTightenings && laplacian && !reach.HoldsUnknown(problem); ++k) {
    problem.tension = std::max(10 * problem.tension, 10 / (reach.extent * reach.extent));
    laplacian = SolveThinPlate(problem);
  }
  return laplacian;
}

}  // namespace tilemend
