#include "worker/fill/surface/direct_solver.h"

namespace tilemend {

PlateFactorization::PlateFactorization(const PlateEquations& equations)
    : equations_(equations), solver_(equations.LowerMatrix()) {}

PointValues PlateFactorization::Solve(const PointValues& residual) const {
  return equations_.Spread(solver_.solve(equations_.Gather(residual)));
}

PointValues GivenHeights(const ThinPlateProblem& problem) {
  PointValues heights(static_cast<Eigen::Index>(problem.points.size()));
  for (size_t v = 0; v < problem.points.size(); ++v) {
    heights[static_cast<Eigen::Index>(v)] = problem.known[v] ? problem.points[v].z() : 0;
  }
  return heights;
}

std::optional<PointValues> SolveDirectly(const ThinPlateProblem& problem, const PlateEquations& equations) {
  const PlateFactorization factorization(equations);
  if (!factorization.ok()) return std::nullopt;
  PointValues heights = GivenHeights(problem);
  heights += factorization.Solve(equations.Residual(heights));
  if (!heights.allFinite()) return std::nullopt;
  return heights;
}

}  // namespace tilemend
