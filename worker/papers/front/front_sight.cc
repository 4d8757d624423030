#include "worker/papers/front/front_sight.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "common/mesh/exact_signs.h"
#include "common/mesh/segment_distance.h"
#include "common/mesh/triangle_shape.h"

namespace tilemend {
namespace {

using Eigen::Vector3d;

// A triangle turns at most this far (cosine) against the surface at its corner.
constexpr double kLeastFacing = 0.2;
// The least quality of a triangle; thinner ones have no direction.
constexpr double kLeastQuality = 0.02;

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

  bool IsHitBy(int32_t from, Point3 a, int32_t to, Point3 b) const {
    const bool has_from = Has(from), has_to = Has(to);
    if ((has_from && has_to) || !CutToReach(a, b)) return false;
    const Point2 p = Flat(a), q = Flat(b);
    if ((!has_from && Covers(p)) || (!has_to && Covers(q))) return true;
    for (int k = 0; k < 3; ++k) {
      const int l = (k + 1) % 3;
      if (vertices_[k] >= 0 && (vertices_[k] == from || vertices_[k] == to)) continue;
      if (vertices_[l] >= 0 && (vertices_[l] == from || vertices_[l] == to)) continue;
      if (TurnOf(corners_[k], corners_[l], p) * TurnOf(corners_[k], corners_[l], q) < 0 &&
          TurnOf(p, q, corners_[k]) * TurnOf(p, q, corners_[l]) < 0) {
        return true;
      }
    }
    return false;
  }

  double reach() const { return reach_; }

 private:
  Point2 Flat(const Point3& p) const { return {x_.dot(p - origin_), y_.dot(p - origin_)}; }
  bool Has(int32_t v) const { return std::find(vertices_.begin(), vertices_.end(), v) != vertices_.end(); }
  // Leaves of an edge what is no further above or below than the longest edge; false: nothing.
  bool CutToReach(Point3& a, Point3& b) const {
    const double at_a = z_.dot(a - origin_), at_b = z_.dot(b - origin_);
    if (std::min(at_a, at_b) > reach_ || std::max(at_a, at_b) < -reach_) return false;
    const Vector3d along = (b - a) / (at_b - at_a);
    const Point3 from = a;
    if (std::abs(at_a) > reach_) a = from + (std::copysign(reach_, at_a) - at_a) * along;
    if (std::abs(at_b) > reach_) b = from + (std::copysign(reach_, at_b) - at_a) * along;
    return true;
  }
  bool Covers(const Point2& p) const {
    return TurnOf(corners_[0], corners_[1], p) >= 0 && TurnOf(corners_[1], corners_[2], p) >= 0 &&
           TurnOf(corners_[2], corners_[0], p) >= 0;
  }

  Point3 origin_;
  Vector3d x_, y_, z_;
  const Triangle& vertices_;
  Point2 corners_[3];
  double reach_ = 0;
};

Eigen::AlignedBox3d BoxAround(const Point3& p, double reach) {
  return {p - Vector3d::Constant(reach), p + Vector3d::Constant(reach)};
}

}  // namespace

void FrontSight::Follow(int32_t node, double unit) { index_.Add(node, At(node), At(loops_[node].after), unit); }

bool FrontSight::IsClear(const SpaceTriangle& t, const Triangle& vertices, const Vector3d& normal) const {
  const Vector3d area = TwiceVectorArea(t);
  if (!(area.dot(normal) > kLeastFacing * area.norm()) || TriangleQuality(t[0], t[1], t[2]) < kLeastQuality) {
    return false;
  }
  const Seen seen(t, vertices, area.normalized());
  Eigen::AlignedBox3d box;
  for (const Point3& corner : t) box.extend(corner);
  const Vector3d reach = Vector3d::Constant(seen.reach());
  const std::vector<int32_t> near = index_.Near({box.min() - reach, box.max() + reach});
  return std::none_of(near.begin(), near.end(), [&](int32_t n) {
    return seen.IsHitBy(loops_[n].vertex, At(n), loops_.VertexAfter(n), At(loops_[n].after));
  });
}

bool FrontSight::IsNear(const Point3& p, int32_t node, double distance) const {
  const int32_t vertex = loops_[node].vertex;
  const std::vector<int32_t> near = index_.Near(BoxAround(p, distance));
  return std::any_of(near.begin(), near.end(), [&](int32_t n) {
    return loops_[n].vertex != vertex && loops_.VertexAfter(n) != vertex &&
           DistanceToSegment(p, At(n), At(loops_[n].after)) < distance;
  });
}

std::vector<int32_t> FrontSight::NodesNear(const Point3& p, double distance) const {
  std::vector<int32_t> near = index_.Near(BoxAround(p, distance));
  std::erase_if(near, [&](int32_t n) { return (At(n) - p).norm() > distance; });
  return near;
}

}  // namespace tilemend
