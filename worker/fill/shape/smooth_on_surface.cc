#include "worker/fill/shape/smooth_on_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "common/mesh/triangle_shape.h"
#include "common/mesh/vertex_lists.h"

namespace tilemend {
namespace {

constexpr double kSteepSlope = 0.25;
// Tangent planes steeper than this foretell no heights.
constexpr double kSteepestTangent = 10;
// A move may make the worst triangle around a vertex worse as long as it stays this good.
constexpr double kGoodShape = 0.7;
// A move that gains less in the sum of shapes is not worth it, and could be a matter of rounding.
constexpr double kLeastSmoothingGain = 1e-3;

class Smoother {
 public:
  Smoother(const std::vector<Triangle>& triangles, int32_t first_movable, const PlacePoint& place,
           std::vector<LatticePoint>& plane, std::vector<Point3>& points)
      : triangles_(triangles),
        first_(first_movable),
        place_(place),
        plane_(plane),
        points_(points),
        corners_(CornersAt(triangles, plane.size())) {
    FindSlopes();
  }

  void Run() {
    for (auto v = first_; v < static_cast<int32_t>(plane_.size()); ++v) Move(v);
  }

 private:
  struct StarShape {
    double worst = 1;
    double sum = 0;
  };

  void FindSlopes() {
    for (size_t v = 0; v < plane_.size(); ++v) slope_.push_back(SlopeAt(static_cast<int32_t>(v)));
  }

  // The gradient of the sum of the normals around v.
  Point2 SlopeAt(int32_t v) const {
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    for (const int32_t c : corners_.Of(v)) normal += TwiceVectorArea(points_, triangles_[c >> 2]);
    return normal.z() > 0 ? Point2(-normal.head<2>() / normal.z()) : Point2(0, 0);
  }

  // The two corners of a corner's triangle behind it.
  std::pair<int32_t, int32_t> Behind(int32_t corner) const {
    const Triangle& t = triangles_[corner >> 2];
    return {t[((corner & 3) + 1) % 3], t[((corner & 3) + 2) % 3]};
  }

  StarShape ShapeAt(int32_t v, const Point3& p) const {
    StarShape result;
    for (const int32_t c : corners_.Of(v)) {
      const auto [a, b] = Behind(c);
      const double shape = TriangleShape(p, points_[a], points_[b]);
      result.worst = std::min(result.worst, shape);
      result.sum += shape;
    }
    return result;
  }

  bool StaysUpright(int32_t v, const LatticePoint& p) const {
    return std::ranges::all_of(corners_.Of(v), [&](int32_t c) {
      const auto [a, b] = Behind(c);
      return Orientation(p, plane_[a], plane_[b]) > 0;
    });
  }

  // Where the sum of shapes around v has no gradient, its denominators held fixed (as in smooth_region.cc), on the
  // tangent plane; seen from above, relative to v.
  Point2 Pull(int32_t v) const {
    const Eigen::Vector3d normal = Eigen::Vector3d(-slope_[v].x(), -slope_[v].y(), 1).normalized();
    const Eigen::Vector3d e = Eigen::Vector3d(1, 0, slope_[v].x()).normalized(), f = normal.cross(e);
    double sum = 0, x = 0, y = 0;
    for (const int32_t c : corners_.Of(v)) {
      const auto [from, to] = Behind(c);
      const Eigen::Vector3d p = points_[from] - points_[v], q = points_[to] - points_[v];
      const double ax = p.dot(e), ay = p.dot(f), bx = q.dot(e), by = q.dot(f);
      const double squares = 2 * (ax * (ax - bx) + ay * (ay - by) + bx * bx + by * by);
      const double weight = 2 * (ax * by - ay * bx) / (squares * squares);
      x += (ay - by) / squares + weight * (ax + bx);
      y += (bx - ax) / squares + weight * (ay + by);
      sum += 2 * weight;
    }
    return ((x * e + y * f) / sum).head<2>();
  }

  // The height of the surface at a place near v.
  double HeightAt(int32_t v, const Point2& place) const {
    double best = -std::numeric_limits<double>::infinity(), height = points_[v].z();
    for (const int32_t c : corners_.Of(v)) {
      const Triangle& t = triangles_[c >> 2];
      const std::array<double, 3> share = Shares(t, place);
      const double least = *std::min_element(share.begin(), share.end());
      if (!(least > best)) continue;
      best = least;
      height = HeightOn(t, share, place);
    }
    return height;
  }

  // Barycentric coordinates.
  std::array<double, 3> Shares(const Triangle& t, const Point2& place) const {
    std::array<double, 3> share{};
    double sum = 0;
    for (int k = 0; k < 3; ++k) {
      const Point2 a = points_[t[(k + 1) % 3]].head<2>() - place, b = points_[t[(k + 2) % 3]].head<2>() - place;
      share[k] = a.x() * b.y() - a.y() * b.x();
      sum += share[k];
    }
    for (double& s : share) s /= sum;
    return share;
  }

  double HeightOn(const Triangle& t, const std::array<double, 3>& share, const Point2& place) const {
    double flat = 0, tangent = 0;
    bool steep = false;
    for (int k = 0; k < 3; ++k) {
      const Point3& p = points_[t[k]];
      flat += share[k] * p.z();
      tangent += share[k] * (p.z() + slope_[t[k]].dot(place - p.head<2>()));
      steep |= slope_[t[k]].norm() > kSteepestTangent;
    }
    return steep ? flat : (flat + tangent) / 2;
  }

  void Move(int32_t v) {
    const StarShape before = ShapeAt(v, points_[v]);
    const Point2 way = Pull(v);
    for (const double step : {1.0, 0.5, 0.25}) {
      const Point2 wanted = points_[v].head<2>() + step * way;
      if (!wanted.allFinite()) return;
      const auto placed = place_(wanted);
      if (!placed || !StaysUpright(v, placed->first)) continue;
      const Point3 p(placed->second.x(), placed->second.y(), HeightAt(v, placed->second));
      const StarShape after = ShapeAt(v, p);
      if (after.sum < before.sum + kLeastSmoothingGain || after.worst < std::min(before.worst, kGoodShape)) continue;
      plane_[v] = placed->first;
      points_[v] = p;
      slope_[v] = SlopeAt(v);
      return;
    }
  }

  const std::vector<Triangle>& triangles_;
  const int32_t first_;
  const PlacePoint& place_;
  std::vector<LatticePoint>& plane_;
  std::vector<Point3>& points_;
  const VertexLists corners_;
  std::vector<Point2> slope_;
};

}  // namespace

bool IsSteepPatch(const std::vector<Triangle>& triangles, const std::vector<Point3>& points) {
  double area = 0, slope2 = 0;
  for (const Triangle& t : triangles) {
    const Eigen::Vector3d normal = TwiceVectorArea(points, t);
    if (normal.z() <= 0) continue;
    area += normal.z();
    slope2 += normal.head<2>().squaredNorm() / normal.z();
  }
  return slope2 > kSteepSlope * kSteepSlope * area;
}

void SmoothOnSurface(const std::vector<Triangle>& triangles, int32_t first_movable, const PlacePoint& place,
                     std::vector<LatticePoint>& plane, std::vector<Point3>& points) {
  Smoother(triangles, first_movable, place, plane, points).Run();
}

}  // namespace tilemend
