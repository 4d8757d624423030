#include "worker/fill/front/front_sight.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "common/mesh/triangle_shape.h"

namespace tilemend {
namespace {

using Eigen::Vector3d;

// A triangle turns at most this far (cosine) against the surface at its corner.
constexpr double kLeastFacing = 0.2;
// The least quality of a triangle; thinner ones have no direction.
constexpr double kLeastQuality = 0.02;

double Turn(const Point2& a, const Point2& b, const Point2& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

// A triangle seen along its normal.
class Seen {
 public:
  Seen(const SpaceTriangle& t, const Triangle& vertices, const Vector3d& normal)
      : origin_(t[0]), z_(normal), vertices_(vertices) {
    x_ = (t[1] - t[0]).normalized();
    y_ = z_.cross(x_);
    for (int k = 0; k < 3; ++k) {
      corners_[k] = Flat(t[k]);
      reach_ = std::max(reach_, (t[k] - t[(k + 1) % 3]).norm());
    }
  }

  bool IsHitBy(int32_t from, const Point3& a, int32_t to, const Point3& b) const {
    const bool has_from = Has(from), has_to = Has(to);
    if ((has_from && has_to) || IsFar(a, b)) return false;
    const Point2 p = Flat(a), q = Flat(b);
    if ((!has_from && Covers(p)) || (!has_to && Covers(q))) return true;
    for (int k = 0; k < 3; ++k) {
      const int l = (k + 1) % 3;
      if (vertices_[k] >= 0 && (vertices_[k] == from || vertices_[k] == to)) continue;
      if (vertices_[l] >= 0 && (vertices_[l] == from || vertices_[l] == to)) continue;
      if (Turn(corners_[k], corners_[l], p) * Turn(corners_[k], corners_[l], q) < 0 &&
          Turn(p, q, corners_[k]) * Turn(p, q, corners_[l]) < 0) {
        return true;
      }
    }
    return false;
  }

 private:
  Point2 Flat(const Point3& p) const { return {x_.dot(p - origin_), y_.dot(p - origin_)}; }
  bool Has(int32_t v) const { return std::find(vertices_.begin(), vertices_.end(), v) != vertices_.end(); }
  bool IsFar(const Point3& a, const Point3& b) const {
    const double up = z_.dot(a - origin_), down = z_.dot(b - origin_);
    return std::min(up, down) > reach_ || std::max(up, down) < -reach_ ||
           (a - origin_).norm() > 2 * reach_ + (b - a).norm();
  }
  bool Covers(const Point2& p) const {
    return Turn(corners_[0], corners_[1], p) >= 0 && Turn(corners_[1], corners_[2], p) >= 0 &&
           Turn(corners_[2], corners_[0], p) >= 0;
  }

  Point3 origin_;
  Vector3d x_, y_, z_;
  const Triangle& vertices_;
  Point2 corners_[3];
  double reach_ = 0;
};

double DistanceToSegment(const Point3& p, const Point3& a, const Point3& b) {
  const Vector3d along = b - a;
  const double share = along.squaredNorm() > 0 ? std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0) : 0;
  return (p - a - share * along).norm();
}

}  // namespace

bool FrontSight::IsClear(const SpaceTriangle& t, const Triangle& vertices, const Vector3d& normal) const {
  const Vector3d area = TwiceVectorArea(t);
  if (!(area.dot(normal) > kLeastFacing * area.norm()) || TriangleQuality(t[0], t[1], t[2]) < kLeastQuality) {
    return false;
  }
  const Seen seen(t, vertices, area.normalized());
  for (const int32_t n : loops_.Alive()) {
    const int32_t from = loops_[n].vertex, to = loops_.VertexAfter(n);
    if (seen.IsHitBy(from, points_[from], to, points_[to])) return false;
  }
  return true;
}

double FrontSight::DistanceTo(const Point3& p, int32_t node) const {
  double least = std::numeric_limits<double>::infinity();
  const int32_t vertex = loops_[node].vertex;
  for (const int32_t n : loops_.Alive()) {
    const int32_t from = loops_[n].vertex, to = loops_.VertexAfter(n);
    if (from == vertex || to == vertex) continue;
    least = std::min(least, DistanceToSegment(p, points_[from], points_[to]));
  }
  return least;
}

}  // namespace tilemend
