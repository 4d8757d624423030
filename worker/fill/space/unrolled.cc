#include "worker/fill/space/unrolled.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

namespace tilemend {

using Eigen::Vector3d;

Unrolled::Unrolled(std::vector<Point3> positions, std::vector<Triangle> triangles)
    : positions_(std::move(positions)), triangles_(std::move(triangles)), flat_(positions_.size(), Point2::Zero()) {
  std::map<std::pair<int32_t, int32_t>, int32_t> beside;  // of directed edges
  for (size_t t = 0; t < triangles_.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      beside[{triangles_[t][k], triangles_[t][(k + 1) % 3]}] = static_cast<int32_t>(t);
    }
  }
  const Triangle& first = triangles_[0];
  flat_[first[1]] = {(positions_[first[1]] - positions_[first[0]]).norm(), 0};
  Place(first, 0);
  std::vector<int32_t> open = {0};
  std::vector<bool> placed(triangles_.size(), false);
  placed[0] = true;
  for (size_t next = 0; next < open.size(); ++next) {
    const Triangle t = triangles_[open[next]];
    for (int k = 0; k < 3; ++k) {
      const auto it = beside.find({t[(k + 1) % 3], t[k]});
      if (it == beside.end() || placed[it->second]) continue;
      const Triangle& other = triangles_[it->second];
      Place(other, static_cast<int>(std::find(other.begin(), other.end(), t[(k + 1) % 3]) - other.begin()));
      placed[it->second] = true;
      open.push_back(it->second);
    }
  }
}

Point3 Unrolled::Lift(const Point2& p) const {
  Vector3d best = Vector3d::Constant(-INFINITY);
  const Triangle* at = nullptr;
  for (const Triangle& t : triangles_) {
    const Vector3d weights = Weights(t, p);
    if (weights.minCoeff() <= best.minCoeff()) continue;
    best = weights;
    at = &t;
    if (best.minCoeff() >= 0) break;
  }
  return best[0] * positions_[(*at)[0]] + best[1] * positions_[(*at)[1]] + best[2] * positions_[(*at)[2]];
}

// Places the third corner of t, where edge k has both its ends placed, on its left.
void Unrolled::Place(const Triangle& t, int k) {
  const int32_t a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3];
  const Vector3d edge = positions_[b] - positions_[a], side = positions_[c] - positions_[a];
  const Point2 along = (flat_[b] - flat_[a]).normalized(), left(-along.y(), along.x());
  flat_[c] = flat_[a] + side.dot(edge) / edge.norm() * along + side.cross(edge).norm() / edge.norm() * left;
}

Vector3d Unrolled::Weights(const Triangle& t, const Point2& p) const {
  const auto area = [](const Point2& u, const Point2& v) { return u.x() * v.y() - u.y() * v.x(); };
  const Point2 a = flat_[t[0]] - p, b = flat_[t[1]] - p, c = flat_[t[2]] - p;
  const Vector3d parts(area(b, c), area(c, a), area(a, b));
  return parts / parts.sum();
}

}  // namespace tilemend
