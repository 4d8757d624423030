#include "coordinator/plan/seam/seam_heights.h"

#include <algorithm>
#include <optional>

#include "common/mesh/rounding.h"

namespace tilemend {
namespace {

constexpr int kReach = 2;  // neighbours on either side that eq. 6 averages over

struct Merged {
  double height = 0;
  bool shared = false;  // two cells gave heights
};

std::map<int32_t, Merged> Merge(std::span<const SeamSample> samples, const SeamHeights& settled) {
  std::map<int32_t, std::vector<SeamSample>> by_vertex;
  for (const SeamSample& s : samples) {
    if (!settled.height.contains(s.vertex)) by_vertex[s.vertex].push_back(s);
  }
  std::map<int32_t, Merged> merged;
  for (auto& [vertex, list] : by_vertex) {
    std::sort(list.begin(), list.end(), [](const SeamSample& a, const SeamSample& b) {
      return a.cell != b.cell ? a.cell < b.cell : a.height < b.height;
    });
    double sum = 0;
    for (const SeamSample& s : list) sum += s.height;
    merged[vertex] = {sum / static_cast<double>(list.size()), list.front().cell != list.back().cell};
  }
  return merged;
}

class Smoother {
 public:
  Smoother(const Plan& plan, const SeamHeights& settled, const std::map<int32_t, Merged>& merged)
      : plan_(plan), settled_(settled), merged_(merged) {}

  // Mean of s_i - p over the neighbours along all seams through each shared vertex (eq. 6).
  std::map<int32_t, double> Differences() {
    std::map<int32_t, std::pair<double, int>> sums;
    for (const Seam& seam : plan_.seams) {
      const auto n = static_cast<int>(seam.vertices.size());
      for (int i = 0; i < n; ++i) {
        const auto it = merged_.find(seam.vertices[i]);
        if (it == merged_.end() || !it->second.shared) continue;
        for (int k = std::max(0, i - kReach); k <= std::min(n - 1, i + kReach); ++k) {
          if (k == i) continue;
          const auto height = HeightOf(seam.vertices[k]);
          if (!height) continue;
          sums[seam.vertices[i]].first += *height - it->second.height;
          ++sums[seam.vertices[i]].second;
        }
      }
    }
    std::map<int32_t, double> differences;
    for (const auto& [vertex, sum] : sums) differences[vertex] = sum.first / sum.second;
    return differences;
  }

 private:
  std::optional<double> HeightOf(int32_t vertex) const {
    if (plan_.vertices[vertex].index >= 0) return plan_.vertices[vertex].position.z();
    if (const auto it = settled_.height.find(vertex); it != settled_.height.end()) return it->second;
    if (const auto it = merged_.find(vertex); it != merged_.end()) return it->second.height;
    return std::nullopt;
  }

  const Plan& plan_;
  const SeamHeights& settled_;
  const std::map<int32_t, Merged>& merged_;
};

double HeightAt(const Plan& plan, int32_t vertex, double found) {
  const PlanVertex& v = plan.vertices[vertex];
  return v.height_given ? v.position.z() : RoundedToLattice(found, plan.lattice_step);
}

}  // namespace

void SettleCluster(const Plan& plan, int32_t cluster, std::span<const ClusterSample> samples, SeamHeights& heights) {
  for (const ClusterSample& s : samples) {
    const PlanVertex& vertex = plan.vertices[s.vertex];
    const bool has_walls = heights.walls.contains(cluster);
    if (!has_walls) heights.laplacian[{cluster, s.vertex}] = s.laplacian;
    if (vertex.on_object || (has_walls && vertex.index >= 0)) {
      heights.ground[{cluster, s.vertex}] = {s.height, s.slope};
    }
    if (vertex.index >= 0) continue;  // an original vertex at the end of a seam
    const auto settled = heights.slope.find(s.vertex);
    if (settled != heights.slope.end() && settled->second.cluster < cluster) continue;
    heights.height[s.vertex] = HeightAt(plan, s.vertex, s.height);
    heights.slope[s.vertex] = {s.slope, cluster};
  }
}

void SettleLayer(const Plan& plan, std::span<const SeamSample> samples, double gamma, SeamHeights& heights) {
  const std::map<int32_t, Merged> merged = Merge(samples, heights);
  const std::map<int32_t, double> differences = Smoother(plan, heights, merged).Differences();
  for (const auto& [vertex, m] : merged) {
    double height = m.height;
    if (const auto it = differences.find(vertex); it != differences.end()) height += gamma * it->second;  // eq. 5
    heights.height[vertex] = HeightAt(plan, vertex, height);
  }
}

void SettleSmoothed(const Plan& plan, const SmoothedHeights& smoothed, SeamHeights& heights) {
  for (const auto& [vertex, by_seam] : smoothed) {
    double sum = 0;
    for (const auto& [cells, height] : by_seam) sum += height;
    heights.height[vertex] = HeightAt(plan, vertex, sum / static_cast<double>(by_seam.size()));
  }
}

}  // namespace tilemend
