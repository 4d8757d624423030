#include "worker/fill/surface/plate_over_slope.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace tilemend {
namespace {

// How often points are put to their places on the plane. Twice halves what their heights still move by on steep ground;
// more brings nothing (docs/decisions/2026-11-23-plates-over-slopes.md).
constexpr int kRounds = 2;

// The plane through the origin.
class SlopingPlane {
 public:
  explicit SlopingPlane(const Point2& slope)
      : slope_(slope), stretch_(std::sqrt(1 + slope.squaredNorm())), uphill_(slope.normalized()) {
    const Eigen::Vector3d up(uphill_.x() / stretch_, uphill_.y() / stretch_, slope.norm() / stretch_);
    const Eigen::Vector3d normal(-slope.x() / stretch_, -slope.y() / stretch_, 1 / stretch_);
    axes_.row(0) = up;
    axes_.row(1) = normal.cross(up);
    axes_.row(2) = normal;
  }

  // A point's place on the plane below or above it on its vertical line, and its distance from the plane.
  Point3 AlongVertical(const Point3& p) const {
    const Point2 place = p.head<2>() + (stretch_ - 1) * uphill_.dot(p.head<2>()) * uphill_;
    return {place.x(), place.y(), (p.z() - slope_.dot(p.head<2>())) / stretch_};
  }
  // Over the ground, of a place over the ground.
  double HeightOf(const Point3& place, double distance) const {
    return slope_.dot(place.head<2>()) + stretch_ * distance;
  }

  // The place nearest to a point, and its distance from the plane.
  Point3 AlongNormal(const Point3& p) const { return axes_ * p; }
  // How far a point's height moves with its distance from the plane.
  double stretch() const { return stretch_; }

 private:
  const Point2 slope_;
  const double stretch_;  // 1 / cosine
  const Point2 uphill_;
  Eigen::Matrix3d axes_;
};

bool AllFaceUp(const std::vector<Triangle>& triangles, const std::vector<Point3>& points) {
  return std::all_of(triangles.begin(), triangles.end(), [&](const Triangle& t) {
    return (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]).z() > 0;
  });
}

}  // namespace

bool SolveOverSlope(const Point2& slope, ThinPlateProblem& problem, const std::function<bool()>& solve) {
  if (slope.isZero(0)) return solve();
  const SlopingPlane plane(slope);
  const std::vector<bool> known = problem.known, has_equation = problem.has_equation;
  std::vector<Point3> over_ground = problem.points;
  for (Point3& p : problem.points) p = plane.AlongVertical(p);
  const bool solved = solve();
  for (size_t v = 0; v < over_ground.size(); ++v) {
    if (!known[v]) over_ground[v].z() = plane.HeightOf(over_ground[v], problem.points[v].z());
  }
  for (int round = 0; solved && round < kRounds; ++round) {
    for (size_t v = 0; v < over_ground.size(); ++v) problem.points[v] = plane.AlongNormal(over_ground[v]);
    if (!AllFaceUp(problem.patch, problem.points)) break;
    const std::vector<Point3> before = problem.points;
    problem.known = known;
    problem.has_equation = has_equation;
    if (!solve()) break;
    for (size_t v = 0; v < over_ground.size(); ++v) {
      if (!known[v]) over_ground[v].z() += plane.stretch() * (problem.points[v].z() - before[v].z());
    }
  }
  problem.points = std::move(over_ground);
  return solved;
}

}  // namespace tilemend
