#include "common/records/moved_outline.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <map>

namespace tilemend {
namespace {

bool IsNear(const Point3& p, const PlacedEdge& edge) {
  const Eigen::Vector3d along = edge.at_to - edge.at_from;
  const double length = along.squaredNorm();
  const double share = length > 0 ? std::clamp((p - edge.at_from).dot(along) / length, 0.0, 1.0) : 0;
  const Eigen::Vector3d off = p - (edge.at_from + share * along);
  return off.head<2>().norm() <= 2 * kMaxOutlineAside && std::abs(off.z()) <= 2 * kMaxOutlineRise;
}

}  // namespace

bool MayMoveOutline(std::span<const PlacedEdge> lost, std::span<const PlacedEdge> fresh) {
  std::map<int64_t, int> leaving;  // lost edges less fresh ones
  const auto count = [&](std::span<const PlacedEdge> edges, int times) {
    for (const PlacedEdge& e : edges) {
      leaving[e.from] += times;
      leaving[e.to] -= times;
    }
  };
  count(lost, 1);
  count(fresh, -1);
  if (std::ranges::any_of(leaving, [](const auto& vertex) { return vertex.second != 0; })) return false;
  return std::ranges::all_of(fresh, [&](const PlacedEdge& e) {
    return std::ranges::any_of(lost, [&](const PlacedEdge& of) { return IsNear(e.at_from, of); });
  });
}

}  // namespace tilemend
