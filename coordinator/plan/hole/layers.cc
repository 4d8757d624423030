#include "coordinator/plan/hole/layers.h"

#include <algorithm>
#include <deque>

#include "common/mesh/disjoint_sets.h"

namespace tilemend {
namespace {

// In order of their lowest holes.
void NumberClusters(const std::vector<bool>& open, std::span<const std::pair<int32_t, int32_t>> touching,
                    Layering& result) {
  const auto count = static_cast<int32_t>(open.size());
  DisjointSets sets(count);
  for (const auto& [a, b] : touching) sets.Join(a, b);
  result.cluster.assign(open.size(), -1);
  for (int32_t i = 0; i < count; ++i) {
    if (!open[i]) continue;
    const int32_t lowest = sets.LowestOf(i);
    result.cluster[i] = lowest == i ? result.clusters++ : result.cluster[lowest];
  }
}

}  // namespace

Layering LayerHoles(const std::vector<bool>& open, const std::vector<bool>& outermost,
                    std::span<const std::pair<int32_t, int32_t>> touching) {
  Layering result;
  NumberClusters(open, touching, result);
  result.layer.assign(open.size(), 0);
  std::vector<std::vector<int32_t>> next(open.size());
  for (const auto& [a, b] : touching) {
    next[a].push_back(b);
    next[b].push_back(a);
  }
  std::vector<bool> has_start(static_cast<size_t>(result.clusters), false);
  for (size_t i = 0; i < open.size(); ++i) {
    if (open[i] && outermost[i]) has_start[result.cluster[i]] = true;
  }
  std::deque<int32_t> queue;
  for (size_t i = 0; i < open.size(); ++i) {
    if (!open[i] || (has_start[result.cluster[i]] && !outermost[i])) continue;
    has_start[result.cluster[i]] = true;  // a cluster without surface: its lowest hole only
    result.layer[i] = 1;
    queue.push_back(static_cast<int32_t>(i));
  }
  while (!queue.empty()) {
    const int32_t hole = queue.front();
    queue.pop_front();
    result.layers = std::max(result.layers, result.layer[hole]);
    for (const int32_t n : next[hole]) {
      if (result.layer[n] != 0) continue;
      result.layer[n] = result.layer[hole] + 1;
      queue.push_back(n);
    }
  }
  return result;
}

}  // namespace tilemend
