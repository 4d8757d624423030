#include "worker/fill/surface/linear_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

#include "common/mesh/triangle_shape.h"
#include "common/mesh/triangulation/point_triangulation.h"
#include "worker/fill/surface/direct_solver.h"
#include "worker/fill/surface/plate_equations.h"

namespace tilemend {
namespace {

constexpr double kSoftness = 0.7;  // metres: edges are rounded off about so far

// The ground, triangulated.
class LinearSurface {
 public:
  LinearSurface(const std::vector<Point3>& ground, const Eigen::AlignedBox2d& places)
      : ground_(ground), triangulation_(TriangulatePoints(ground, places)) {}

  double HeightAt(const Point2& p) {
    last_ = TriangleAt(triangulation_.window.Round(p));
    std::vector<Point3> corners;
    for (const int32_t v : triangles()[last_]) {
      if (v < std::ssize(ground_)) corners.push_back(ground_[v]);
    }
    if (corners.size() == 3) return HeightIn(corners, p);
    if (corners.size() == 2) return HeightBeside(corners[0], corners[1], p);
    return corners.empty() ? Nearest(p) : corners[0].z();
  }

 private:
  // Walks there from the last one.
  int32_t TriangleAt(const LatticePoint& p) const {
    int32_t t = last_;
    for (size_t step = 0; step < triangles().size(); ++step) {
      const Triangle& corners = triangles()[t];
      int32_t next = -1;
      for (int k = 0; k < 3 && next < 0; ++k) {
        const LatticePoint a = triangulation_.points[corners[(k + 1) % 3]],
                           b = triangulation_.points[corners[(k + 2) % 3]];
        if (Orientation(a, b, p) < 0) next = triangulation_.mesh.neighbors[t][k];
      }
      if (next < 0) break;
      t = next;
    }
    return t;
  }

  static double HeightIn(const std::vector<Point3>& corners, const Point2& p) {
    const Eigen::Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    const Point2 d = p - corners[0].head<2>();
    if (!(normal.z() > 0)) return corners[0].z();  // flat but on the lattice
    const double height = corners[0].z() - normal.head<2>().dot(d) / normal.z();
    const auto [low, high] = std::minmax({corners[0].z(), corners[1].z(), corners[2].z()});
    return std::clamp(height, low, high);
  }

  static double HeightBeside(const Point3& a, const Point3& b, const Point2& p) {
    const Point2 way = (b - a).head<2>();
    const double share = (p - a.head<2>()).dot(way) / std::max(way.squaredNorm(), 1e-300);
    return a.z() + std::clamp(share, 0.0, 1.0) * (b.z() - a.z());
  }

  // In the frame's corners no ground is near.
  double Nearest(const Point2& p) const {
    return std::min_element(ground_.begin(), ground_.end(),
                            [&](const Point3& a, const Point3& b) {
                              return (a.head<2>() - p).squaredNorm() < (b.head<2>() - p).squaredNorm();
                            })
        ->z();
  }

  const std::vector<Triangle>& triangles() const { return triangulation_.mesh.triangles; }

  const std::vector<Point3>& ground_;
  const PointTriangulation triangulation_;
  int32_t last_ = 0;
};

// Which heights count, and the ground under objects where it is known.
std::vector<bool> KnownGround(const std::vector<bool>& on_object, const std::vector<std::optional<double>>& ground,
                              const std::vector<bool>& known, std::vector<Point3>& points) {
  std::vector<bool> settled = known;
  for (size_t v = 0; v < on_object.size(); ++v) {
    if (!on_object[v]) continue;
    settled[v] = v < ground.size() && ground[v];
    if (settled[v]) points[v].z() = *ground[v];
  }
  return settled;
}

// Rounds off the edges of a surface: minimises |gradient|^2 + (height - its height)^2 / kSoftness^2 over the patch.
bool Soften(ThinPlateProblem& surface) {
  const PlateEquations equations(surface, false, 1.0);
  if (equations.unknown_count() == 0) return true;
  PointValues heights(surface.points.size()), masses = PointValues::Zero(heights.size());
  for (size_t v = 0; v < surface.points.size(); ++v) heights[static_cast<Eigen::Index>(v)] = surface.points[v].z();
  for (const Triangle& t : surface.patch) {
    const double area = std::abs(TwiceVectorArea(surface.points, t).z()) / 2;
    for (const int32_t v : t) masses[v] += area / 3 / (kSoftness * kSoftness);
  }
  Eigen::SparseMatrix<double> matrix = equations.LowerMatrix();
  matrix.diagonal() += equations.Gather(masses);
  const SymmetricFactorization solver(matrix);
  if (!solver.ok()) return false;
  const PointValues change = equations.Spread(solver.Solve(equations.Gather(equations.Residual(heights))));
  if (!change.allFinite()) return false;
  for (size_t v = 0; v < surface.points.size(); ++v) surface.points[v].z() += change[static_cast<Eigen::Index>(v)];
  return true;
}

}  // namespace

std::vector<double> LinearHeights(const std::vector<Point3>& ground, const std::vector<Point2>& at) {
  Eigen::AlignedBox2d box;
  for (const Point3& p : ground) box.extend(Point2(p.head<2>()));
  for (const Point2& p : at) box.extend(p);
  LinearSurface surface(ground, box);
  std::vector<size_t> order(at.size());
  std::iota(order.begin(), order.end(), 0);
  const double strip = std::max(box.sizes().y(), 1e-9) / std::sqrt(static_cast<double>(at.size()) + 1);
  std::sort(order.begin(), order.end(), [&](size_t i, size_t k) {
    const auto key = [&](size_t n) { return std::pair(std::floor((at[n].y() - box.min().y()) / strip), at[n].x()); };
    return key(i) < key(k);
  });
  std::vector<double> heights(at.size());
  for (const size_t i : order) heights[i] = surface.HeightAt(at[i]);
  return heights;
}

bool SolveLinear(const std::vector<Point3>& ground_points, const std::vector<bool>& on_object,
                 const std::vector<std::optional<double>>& ground, ThinPlateProblem& problem) {
  ThinPlateProblem free;
  free.patch = problem.patch;
  free.points = problem.points;
  free.known = KnownGround(on_object, ground, problem.known, free.points);
  free.has_equation.assign(free.points.size(), false);
  std::vector<bool> in_patch(free.points.size(), false);
  for (const Triangle& t : free.patch) {
    for (const int32_t v : t) in_patch[v] = true;
  }
  std::vector<Point2> at;
  for (size_t v = 0; v < free.points.size(); ++v) {
    if (!in_patch[v]) free.known[v] = true;
    if (!free.known[v]) at.emplace_back(free.points[v].head<2>());
  }
  const std::vector<double> heights = LinearHeights(ground_points, at);
  for (size_t v = 0, i = 0; v < free.points.size(); ++v) {
    if (!free.known[v]) free.points[v].z() = heights[i++];
  }
  if (!Soften(free)) return false;
  for (size_t v = 0; v < free.points.size(); ++v) {
    if (in_patch[v]) problem.points[v].z() = free.points[v].z();
  }
  return true;
}

}  // namespace tilemend
