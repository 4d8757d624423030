#include "coordinator/plan/hole/layers.h"

#include <algorithm>
#include <deque>

namespace tilemend {
namespace {

using Adjacency = std::vector<std::vector<int32_t>>;

void NumberClusters(const std::vector<bool>& open, const Adjacency& next, Layering& result) {
  for (size_t start = 0; start < open.size(); ++start) {
    if (!open[start] || result.cluster[start] >= 0) continue;
    std::vector<int32_t> stack = {static_cast<int32_t>(start)};
    result.cluster[start] = result.clusters;
    while (!stack.empty()) {
      const int32_t hole = stack.back();
      stack.pop_back();
      for (const int32_t n : next[hole]) {
        if (result.cluster[n] >= 0) continue;
        result.cluster[n] = result.clusters;
        stack.push_back(n);
      }
    }
    ++result.clusters;
  }
}

}  // namespace

Layering LayerHoles(const std::vector<bool>& open, const std::vector<bool>& outermost,
                    std::span<const std::pair<int32_t, int32_t>> touching) {
  Layering result;
  result.cluster.assign(open.size(), -1);
  result.layer.assign(open.size(), 0);
  Adjacency next(open.size());
  for (const auto& [a, b] : touching) {
    next[a].push_back(b);
    next[b].push_back(a);
  }
  NumberClusters(open, next, result);
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
