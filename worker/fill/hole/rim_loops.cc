#include "worker/fill/hole/rim_loops.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "common/mesh/edge_loops.h"

namespace tilemend {
namespace {

// Rim edges on either side of a place that its normal is evened out over.
constexpr int32_t kReach = 6;

}  // namespace

std::vector<std::vector<int32_t>> LoopsOf(std::span<const RegionSegment> segments) {
  std::vector<DirectedEdge> edges;
  for (const RegionSegment& s : segments) edges.push_back({s.from, s.to});
  std::vector<std::vector<int32_t>> loops;
  for (const EdgeWalk& walk : LinkEdges(edges)) {
    if (!walk.closed) return {};
    std::vector<int32_t>& loop = loops.emplace_back();
    for (const int32_t e : walk.edges) loop.push_back(edges[e].from);
  }
  return loops;
}

std::vector<Eigen::Vector3d> EvenNormals(const RimLoop& loop) {
  const int32_t n = loop.size(), width = 2 * std::min(kReach, n / 2);
  std::vector<bool> none(static_cast<size_t>(n));
  for (int32_t i = 0; i < n; ++i) none[i] = loop.outside[i].isZero();
  // From the normal at each place to those at the `width` places from there on; 0 if one is missing.
  std::vector<double> apart(static_cast<size_t>(n) * width, 0);
  for (int32_t i = 0; i < n; ++i) {
    for (int32_t d = 1; d < width; ++d) {
      const int32_t j = (i + d) % n;
      if (!none[i] && !none[j]) apart[i * width + d] = (loop.outside[i] - loop.outside[j]).norm();
    }
  }
  std::vector<Eigen::Vector3d> normals;
  std::array<int32_t, 2 * kReach> place{};  // those within reach, in order
  for (int32_t i = 0; i < n; ++i) {
    for (int32_t k = 0; k < width; ++k) place[k] = (i + k - width / 2 + n) % n;
    Eigen::Vector3d best = Eigen::Vector3d::Zero();
    double least = INFINITY;
    for (int32_t m = 0; m < width; ++m) {
      if (none[place[m]]) continue;
      double sum = 0;
      for (int32_t k = 0; k < m; ++k) sum += apart[place[k] * width + m - k];
      for (int32_t k = m + 1; k < width; ++k) sum += apart[place[m] * width + k - m];
      if (sum >= least) continue;
      least = sum;
      best = loop.outside[place[m]];
    }
    normals.push_back(best);
  }
  return normals;
}

}  // namespace tilemend
