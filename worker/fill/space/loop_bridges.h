// Ties loops in space together by bridges, so that one loop runs around them all.
#ifndef TILEMEND_WORKER_FILL_SPACE_LOOP_BRIDGES_H_
#define TILEMEND_WORKER_FILL_SPACE_LOOP_BRIDGES_H_

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "common/mesh/tri_mesh.h"

namespace tilemend {

using VertexLoop = std::vector<int32_t>;  // may pass a vertex several times

// What bridges are built between.
struct BridgeEnds {
  std::function<Point3(int32_t)> at;                  // where a vertex is
  std::function<bool(int32_t, int32_t)> may_be_tied;  // whether an edge may be made between two vertices
};

// A way from the first loop to another and back.
struct Bridge {
  size_t from, loop, to;  // place on the first loop, the other loop, place on it
  double length;          // metres; 0 where both pass one vertex
};

// All bridges that may be built, the shortest first; of loops of more than 600 places every second, third and so on.
// O(n^2 log n) for n places.
std::vector<Bridge> BridgesFrom(const BridgeEnds& ends, const std::vector<VertexLoop>& loops);

// Makes one loop of two: along the first to the bridge, over it, around the other and back. Returns whether the loop
// now has two edges along the bridge: none where both passed one vertex.
bool BuildBridge(const Bridge& bridge, std::vector<VertexLoop>& loops);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SPACE_LOOP_BRIDGES_H_
