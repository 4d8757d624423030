// Open edges where tiles meet: which are new, and what the neighbour has there.
#ifndef TILEMEND_WORKER_CHECK_TILE_JOINS_H_
#define TILEMEND_WORKER_CHECK_TILE_JOINS_H_

#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "common/mesh/box_tree.h"
#include "common/mesh/tri_mesh.h"
#include "worker/check/added_faults.h"

namespace tilemend {

// The surface of a tile in a strip along its cell's sides.
class BorderStrip {
 public:
  BorderStrip() = default;
  BorderStrip(std::vector<SpaceTriangle> triangles, std::vector<bool> added);

  // How far above or below `p` the nearest surface is, in metres.
  struct Nearest {
    bool is_covered = false;  // there is surface above or below p, or within kSteepReach beside it
    bool is_added = false;    // the nearest was added
    double height = 0;        // of the nearest, above p
  };
  Nearest NearestTo(const Point3& p) const;

 private:
  std::vector<SpaceTriangle> triangles_;
  std::vector<bool> added_;
  BoxTree tree_;  // from above
};

// An edge that has one triangle in all tiles together, and had not in the input.
struct NewOpenEdge {
  OpenEdge edge;
  int32_t tile = 0;  // that has its triangle
};

// Sums the open edges of tiles, row by row of the grid: edges of tiles further apart than one row are never at the same
// place. So memory is bounded by three rows.
class JoinedEdges {
 public:
  // Precondition: rows never fall. O(log n) for each edge.
  void Add(int32_t tile, int32_t row, const std::vector<OpenEdge>& edges);
  // The new open edges and the edges with more than two triangles, of all tiles in rows below `row`; these are
  // forgotten. In order of position.
  struct Released {
    std::vector<NewOpenEdge> open;
    std::vector<NewOpenEdge> crowded;
  };
  Released ReleaseBelow(int32_t row);

 private:
  struct Sum {
    int32_t before = 0, after = 0, tile = 0, row = 0;
    bool is_added = false;
  };
  std::map<std::array<double, 6>, Sum> sums_;
};

}  // namespace tilemend

#endif  // TILEMEND_WORKER_CHECK_TILE_JOINS_H_
