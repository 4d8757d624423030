#include "worker/fill/surface/plate_over_slope.h"

#include <cmath>
#include <utility>

#include "worker/fill/surface/thin_plate.h"

namespace tilemend {
namespace {

// The plane through the origin.
class SlopingPlane {
 public:
  explicit SlopingPlane(const Point2& slope)
      : slope_(slope), stretch_(std::sqrt(1 + slope.squaredNorm())), uphill_(slope.normalized()) {}

  // A point's place on the plane below or above it, and its distance from the plane.
  Point3 ToPlane(const Point3& p) const {
    const Point2 place = p.head<2>() + (stretch_ - 1) * uphill_.dot(p.head<2>()) * uphill_;
    return {place.x(), place.y(), (p.z() - HeightAt(p)) / stretch_};
  }

  // Over the ground, of a place over the ground.
  double HeightOf(const Point3& place, double distance) const { return HeightAt(place) + stretch_ * distance; }

 private:
  double HeightAt(const Point3& place) const { return slope_.dot(place.head<2>()); }

  const Point2 slope_;
  const double stretch_;  // 1 / cosine
  const Point2 uphill_;
};

}  // namespace

std::optional<std::vector<double>> SolveOverSlope(const Point2& slope, ThinPlateProblem& problem,
                                                  const PlateSolver& solve) {
  if (slope.isZero(0)) return solve();
  const SlopingPlane plane(slope);
  const std::vector<bool> known = problem.known;
  std::vector<Point3> over_ground = problem.points;
  for (Point3& p : problem.points) p = plane.ToPlane(p);
  const auto take_heights = [&] {
    for (size_t v = 0; v < over_ground.size(); ++v) {
      if (!known[v]) over_ground[v].z() = plane.HeightOf(over_ground[v], problem.points[v].z());
    }
  };
  std::optional<std::vector<double>> laplacian = solve();
  if (laplacian) {
    take_heights();
    problem.along = over_ground;
    laplacian = SolveThinPlate(problem);
    problem.along.clear();
  }
  take_heights();
  problem.points = std::move(over_ground);
  return laplacian;
}

}  // namespace tilemend
