#include "worker/fill/rim_loops.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace tilemend {
namespace {

// Rim edges on either side of a place that its normal is evened out over.
constexpr int32_t kReach = 6;

}  // namespace

Eigen::Vector3d UnitNormalBeside(const CellHoles& cell, const CellBand& band, int32_t a, int32_t b) {
  for (const int32_t t : band.At(a)) {
    const Triangle& corners = cell.band.triangles[t];
    if (std::find(corners.begin(), corners.end(), b) == corners.end()) continue;
    const Eigen::Vector3d normal = band.Normal(t);
    return normal.norm() > 0 ? Eigen::Vector3d(normal.normalized()) : Eigen::Vector3d::Zero();
  }
  return Eigen::Vector3d::Zero();
}

std::vector<RimLoop> LoopsOf(const CellHoles& cell, const CellHole& hole, const CellBand& band) {
  const auto& segments = hole.segments;
  const auto count = static_cast<int32_t>(segments.size());
  std::map<int32_t, std::vector<int32_t>> leaving;
  for (int32_t s = 0; s < count; ++s) leaving[segments[s].from].push_back(s);
  std::vector<bool> used(segments.size(), false);
  const auto next_of = [&](int32_t s) {
    if (s + 1 < count && !used[s + 1] && segments[s + 1].from == segments[s].to) return s + 1;
    for (const int32_t next : leaving[segments[s].to]) {
      if (!used[next]) return next;
    }
    return -1;
  };
  std::vector<RimLoop> loops;
  for (int32_t first = 0; first < count; ++first) {
    if (used[first]) continue;
    RimLoop loop;
    int32_t last = first;
    for (int32_t s = first; s >= 0; s = next_of(s)) {
      used[s] = true;
      loop.vertices.push_back(segments[s].from);
      loop.positions.push_back(cell.vertices[segments[s].from].position);
      loop.outside.push_back(UnitNormalBeside(cell, band, segments[s].from, segments[s].to));
      last = s;
    }
    if (segments[last].to != segments[first].from) return {};
    loops.push_back(std::move(loop));
  }
  return loops;
}

std::vector<Eigen::Vector3d> EvenNormals(const RimLoop& loop) {
  const int32_t n = loop.size(), reach = std::min(kReach, n / 2);
  std::vector<Eigen::Vector3d> normals;
  for (int32_t i = 0; i < n; ++i) {
    const auto at = [&](int32_t k) -> const Eigen::Vector3d& { return loop.outside[(i + k + n) % n]; };
    Eigen::Vector3d best = Eigen::Vector3d::Zero();
    double least = INFINITY;
    for (int32_t m = -reach; m < reach; ++m) {
      if (at(m).isZero()) continue;
      double sum = 0;
      for (int32_t k = -reach; k < reach; ++k) sum += at(k).isZero() ? 0 : (at(k) - at(m)).norm();
      if (sum >= least) continue;
      least = sum;
      best = at(m);
    }
    normals.push_back(best);
  }
  return normals;
}

}  // namespace tilemend
