#include "worker/fill/surface/free_rim.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cstdint>
#include <iterator>
#include <limits>
#include <utility>

#include "common/mesh/disjoint_sets.h"
#include "worker/fill/surface/thin_plate.h"

namespace tilemend {
namespace {

// Of the smaller variance to the larger one: below it the points lie on a line, and say nothing of the slope across.
constexpr double kOnLine = 2.5e-3;
constexpr size_t kLeastGround = 3;  // points: a plane

bool StandsOn(const std::vector<bool>& on_object, int32_t v) {
  return v < static_cast<int32_t>(on_object.size()) && on_object[v];
}

void TakeAwayBand(const std::vector<bool>& on_object, ThinPlateProblem& problem) {
  std::erase_if(problem.band, [&](const Triangle& t) {
    const bool at_object = std::any_of(t.begin(), t.end(), [&](int32_t v) { return StandsOn(on_object, v); });
    if (!at_object) return false;
    for (const int32_t v : t) {
      if (problem.known[v]) problem.has_equation[v] = false;
    }
    return true;
  });
  for (size_t v = 0; v < on_object.size(); ++v) {
    if (on_object[v]) problem.has_equation[v] = false;
  }
}

struct Plane {
  Point3 middle = Point3::Zero();
  Point2 slope{0, 0};

  double At(const Point3& p) const { return middle.z() + slope.dot((p - middle).head<2>()); }
};

// The sum over all points.
double Variance(const std::vector<Point3>& points, double mean) {
  double sum = 0;
  for (const Point3& p : points) sum += (p.z() - mean) * (p.z() - mean);
  return sum;
}

Plane PlaneThrough(const std::vector<Point3>& points) {
  Plane plane;
  for (const Point3& p : points) plane.middle += p / static_cast<double>(points.size());
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  Point2 rise(0, 0);
  for (const Point3& p : points) {
    const Point3 d = p - plane.middle;
    spread += d.head<2>() * d.head<2>().transpose();
    rise += d.head<2>() * d.z();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(spread);
  for (int k = 0; k < 2; ++k) {
    if (axes.eigenvalues()[k] <= kOnLine * axes.eigenvalues()[1]) continue;
    const Point2 axis = axes.eigenvectors().col(k);
    plane.slope += axis * (axis.dot(rise) / axes.eigenvalues()[k]);
  }
  if (const double variance = Variance(points, plane.middle.z()); variance > 0) {
    plane.slope *= plane.slope.dot(rise) / variance;
  }
  return plane;
}

// Of the points' heights over the plane. A membrane through them stays within it; what is solved for on triangles with
// obtuse angles need not.
std::pair<double, double> RangeOver(const Plane& plane, const std::vector<Point3>& points) {
  std::pair<double, double> range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const Point3& p : points) {
    const double over = p.z() - plane.At(p);
    range = {std::min(range.first, over), std::max(range.second, over)};
  }
  return range;
}

// The known points of the patch that stand on no object.
std::vector<Point3> GroundOf(const std::vector<bool>& on_object, const ThinPlateProblem& problem) {
  std::vector<int32_t> corners;
  for (const Triangle& t : problem.patch) {
    std::copy_if(t.begin(), t.end(), std::back_inserter(corners),
                 [&](int32_t v) { return problem.known[v] && !StandsOn(on_object, v); });
  }
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  std::vector<Point3> ground;
  for (const int32_t v : corners) ground.push_back(problem.points[v]);
  return ground;
}

// Those of the points on objects that hang together with ground through unknown heights and points on objects: the
// membrane has no height for others.
std::vector<bool> TiedToGround(const std::vector<bool>& on_object, const ThinPlateProblem& problem) {
  DisjointSets parts(static_cast<int32_t>(problem.points.size()));
  const auto free = [&](int32_t v) { return !problem.known[v] || StandsOn(on_object, v); };
  for (const Triangle& t : problem.patch) {
    for (int k = 0; k < 3; ++k) {
      if (free(t[k]) && free(t[(k + 1) % 3])) parts.Join(t[k], t[(k + 1) % 3]);
    }
  }
  std::vector<bool> tied(problem.points.size(), false);  // by part
  for (const Triangle& t : problem.patch) {
    if (std::all_of(t.begin(), t.end(), free)) continue;
    for (const int32_t v : t) {
      if (free(v)) tied[parts.LowestOf(v)] = true;
    }
  }
  std::vector<bool> result(on_object.size(), false);
  for (size_t v = 0; v < on_object.size(); ++v) {
    result[v] = on_object[v] && tied[parts.LowestOf(static_cast<int32_t>(v))];
  }
  return result;
}

}  // namespace

bool FreeRim(const std::vector<bool>& on_object, const std::vector<std::optional<double>>& ground,
             ThinPlateProblem& problem) {
  std::vector<bool> settled(std::max(on_object.size(), ground.size()), false), open = on_object;
  for (size_t v = 0; v < ground.size(); ++v) {
    if (!ground[v]) continue;
    problem.points[v].z() = *ground[v];
    settled[v] = true;
    if (v < open.size()) open[v] = false;
  }
  TakeAwayBand(settled, problem);
  const std::vector<bool> tied = TiedToGround(open, problem);
  if (std::find(tied.begin(), tied.end(), true) == tied.end()) return true;
  const std::vector<Point3> around = GroundOf(tied, problem);
  if (around.size() < kLeastGround) return true;
  const Plane plane = PlaneThrough(around);
  ThinPlateProblem beside;
  beside.points = problem.points;
  beside.patch = problem.patch;
  beside.known = problem.known;
  beside.is_cancelled = problem.is_cancelled;
  beside.has_equation.assign(problem.points.size(), false);
  for (size_t v = 0; v < beside.points.size(); ++v) {
    Point3& p = beside.points[v];
    p.z() -= plane.At(p);
    if (StandsOn(tied, static_cast<int32_t>(v))) beside.known[v] = false;
  }
  if (!SolveMembrane(beside)) return false;
  const auto [least, most] = RangeOver(plane, around);
  for (size_t v = 0; v < tied.size(); ++v) {
    if (!tied[v]) continue;
    problem.points[v].z() = plane.At(beside.points[v]) + std::clamp(beside.points[v].z(), least, most);
  }
  TakeAwayBand(tied, problem);
  return true;
}

}  // namespace tilemend
