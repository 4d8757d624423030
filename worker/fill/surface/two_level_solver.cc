#include "worker/fill/surface/two_level_solver.h"

#include <cmath>
#include <cstdint>

#include "worker/fill/surface/coarse_plate.h"
#include "worker/fill/surface/direct_solver.h"

namespace tilemend {
namespace {

constexpr int kMostIterations = 60;
constexpr double kHeightError = 1e-6;  // of the mean edge: what rounding leaves of coordinates is no less
constexpr int kPowerIterations = 8;
// Of two over the largest eigenvalue, which is where Jacobi's iteration begins to diverge; the estimate is from below.
constexpr double kJacobiShare = 0.6;

double MeanEdge(const ThinPlateProblem& problem) {
  double sum = 0;
  for (const Triangle& t : problem.patch) sum += (problem.points[t[1]] - problem.points[t[0]]).head<2>().norm();
  return sum / static_cast<double>(problem.patch.size());
}

class TwoLevelPreconditioner {
 public:
  TwoLevelPreconditioner(const PlateEquations& equations, const PlateInterpolation& interpolation,
                         const PlateFactorization& coarse)
      : equations_(equations),
        interpolation_(interpolation),
        coarse_(coarse),
        jacobi_(equations.Diagonal().cwiseInverse()) {
    jacobi_ *= 2 * kJacobiShare / LargestEigenvalue();
  }

  PointValues Apply(const PointValues& residual) const {
    PointValues z = jacobi_.cwiseProduct(residual);
    z += interpolation_.ToFine(coarse_.Solve(interpolation_.ToCoarse(residual - equations_.Apply(z))));
    z += jacobi_.cwiseProduct(residual - equations_.Apply(z));
    return z;
  }

 private:
  // Of D^-1 A, by power iteration from a rough start.
  double LargestEigenvalue() const {
    PointValues x = equations_.Diagonal();
    for (Eigen::Index v = 0; v < x.size(); ++v) x[v] = (static_cast<uint64_t>(v) * 2654435761U >> 16 & 1) == 0 ? 1 : -1;
    double length = 1;
    for (int i = 0; i < kPowerIterations; ++i) {
      x = jacobi_.cwiseProduct(equations_.Apply(x / x.norm()));
      length = x.norm();
    }
    return length;
  }

  const PlateEquations& equations_;
  const PlateInterpolation& interpolation_;
  const PlateFactorization& coarse_;
  PointValues jacobi_;  // its diagonal
};

}  // namespace

std::optional<PointValues> SolveInTwoLevels(const ThinPlateProblem& problem, const PlateEquations& equations) {
  const std::optional<CoarsePlate> coarse = CoarsenPlate(problem);
  if (!coarse) return std::nullopt;
  const PlateEquations coarse_equations(coarse->problem, true, problem.tension);
  const PlateFactorization factorization(coarse_equations, problem.is_cancelled);
  if (!factorization.ok()) return std::nullopt;
  PointValues heights = GivenHeights(coarse->problem);
  heights += factorization.Solve(coarse_equations.Residual(heights));
  heights = GivenHeights(problem) + coarse->interpolation.ToFine(heights);

  const TwoLevelPreconditioner preconditioner(equations, coarse->interpolation, factorization);
  const double least = kHeightError * MeanEdge(problem);
  const double least_error = least * least * equations.Gather(equations.Diagonal()).sum();
  const auto enough = [&] { return kLeastError * kLeastError * equations.Energy(heights) + least_error; };
  double limit = enough();
  PointValues residual = equations.Residual(heights), z = preconditioner.Apply(residual), direction = z;
  double error = residual.dot(z);
  for (int i = 0; i < kMostIterations; ++i) {
    // A start that is far off has a high energy, beside which all errors are small.
    if (error <= limit && error <= (limit = enough())) break;
    if (problem.cancelled()) return std::nullopt;
    const PointValues product = equations.Apply(direction);
    const double step = error / direction.dot(product);
    heights += step * direction;
    residual -= step * product;
    z = preconditioner.Apply(residual);
    const double before = error;
    error = residual.dot(z);
    direction = z + error / before * direction;
  }
  if (!(error <= enough()) || !heights.allFinite()) return std::nullopt;
  return heights;
}

}  // namespace tilemend
