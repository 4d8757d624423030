// Clusters and layers of open holes.
#ifndef TILEMEND_COORDINATOR_PLAN_HOLE_LAYERS_H_
#define TILEMEND_COORDINATOR_PLAN_HOLE_LAYERS_H_

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace tilemend {

struct Layering {
  std::vector<int32_t> cluster;  // per hole, from 0 in order of the lowest hole; -1: not an open hole
  std::vector<int32_t> layer;    // per hole, from 1; 0: not an open hole
  int32_t clusters = 0;
  int32_t layers = 0;
};

// By Wang 2021, 3.2, open holes that share a grid boundary are one cluster. Those with original surface on their
// boundary are in layer 1. Those that share a grid boundary with layer n and are in no layer up to n are in layer n +
// 1.
//   open        whether hole i is an open hole
//   outermost   whether it has original surface on its boundary; a cluster without any starts at its lowest hole
//   touching    pairs of open holes that share a stretch of grid boundary
// Cost O(holes + pairs log holes).
Layering LayerHoles(const std::vector<bool>& open, const std::vector<bool>& outermost,
                    std::span<const std::pair<int32_t, int32_t>> touching);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_HOLE_LAYERS_H_
