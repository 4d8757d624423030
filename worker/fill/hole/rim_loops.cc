#include "worker/fill/hole/rim_loops.h"

#include <algorithm>
#include <array>
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
