#include "worker/check/corner_cones.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace tilemend {
namespace {

// Triangles at a vertex from which on cones are worth their room.
constexpr int32_t kMany = 64;
// Of cosines, for rounding.
constexpr double kSlack = 1e-12;

}  // namespace

CornerCones::CornerCones(std::span<const Point3> points, std::span<const Triangle> triangles) : triangles_(triangles) {
  std::vector<int32_t> count(points.size(), 0);
  for (const Triangle& t : triangles) {
    for (const int32_t v : t) ++count[v];
  }
  if (std::ranges::none_of(count, [](int32_t n) { return n >= kMany; })) return;
  cone_of_.assign(triangles.size(), {-1, -1, -1});
  for (size_t i = 0; i < triangles.size(); ++i) {
    for (size_t k = 0; k < 3; ++k) {
      const int32_t v = triangles[i][k];
      if (count[v] < kMany) continue;
      const Eigen::Vector3d one = (points[triangles[i][(k + 1) % 3]] - points[v]).normalized();
      const Eigen::Vector3d other = (points[triangles[i][(k + 2) % 3]] - points[v]).normalized();
      const Eigen::Vector3d axis = (one + other).normalized();
      cone_of_[i][k] = static_cast<int32_t>(cones_.size());
      cones_.push_back({axis, axis.dot(one), axis.cross(one).norm()});
    }
  }
}

bool CornerCones::AreApart(int32_t a, int32_t b) const {
  if (cone_of_.empty()) return false;
  int32_t common = 0;
  std::array<int32_t, 2> at{-1, -1};
  for (size_t k = 0; k < 3; ++k) {
    for (size_t m = 0; m < 3; ++m) {
      if (triangles_[a][k] != triangles_[b][m]) continue;
      ++common;
      at = {cone_of_[a][k], cone_of_[b][m]};
    }
  }
  if (common != 1 || at[0] < 0) return false;
  const Cone &one = cones_[at[0]], &other = cones_[at[1]];
  if (one.sine * other.cosine + one.cosine * other.sine <= 0)
    return false;  // together they are wider than a half space
  return one.axis.dot(other.axis) < one.cosine * other.cosine - one.sine * other.sine - kSlack;
}

}  // namespace tilemend
