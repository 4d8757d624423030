// Open edges where tiles meet: which are new, and what the neighbour has there.
#ifndef TILEMEND_WORKER_CHECK_TILE_JOINS_H_
#define TILEMEND_WORKER_CHECK_TILE_JOINS_H_

#include <cstdint>
#include <functional>
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
  BorderStrip(std::vector<SpaceTriangle> triangles, std::vector<bool> inner);

  // How far above or below `p` the nearest surface is, in metres.
  struct Nearest {
    bool is_covered = false;  // there is surface above or below p, or within kSteepReach beside it
    bool is_inner = false;    // the nearest is inside a fill (AddedFindings::inner)
    double height = 0;        // of the nearest, above p
  };
  Nearest NearestTo(const Point3& p) const { return NearestBeside(p, p, p); }
  // Whether an open edge of another tile, with its middle at `p`, ends at this surface: some is no further away than
  // kCoverReach, above or below. What is steeper than 45 degrees may be so far away in any direction: where two tiles
  // meet, objects and the walls up to them stand apart.
  bool EndsAt(const Point3& p) const;
  // Whether other surface goes on across the edge from `a` to `b`: above or below both sides of its middle, no further
  // away than kCoverReach. The triangle that has the edge is no other surface, and no wall is that stands on its ends.
  bool GoesOnAcross(const Point3& a, const Point3& b) const;

 private:
  Nearest NearestBeside(const Point3& p, const Point3& a, const Point3& b) const;
  std::vector<SpaceTriangle> triangles_;
  std::vector<bool> inner_;
  BoxTree tree_;  // from above
};

// Surface that is no further above or below an open edge closes it where tiles or pieces of a tile overlap, in metres.
// In 18 made cities the neighbour's surface is within .83 m of every edge where a wall or water ends at an outline.
inline constexpr double kCoverReach = 1;

// Marks the edges that are asked for and across which other surface of the mesh goes on. O(n log n) if any are, else
// O(edges).
void CoverOpenEdges(const TriMesh& mesh, const std::function<bool(const OpenEdge&)>& is_asked,
                    std::vector<OpenEdge>& edges);

// An edge of all tiles together.
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
  // Edges of all tiles in rows below `row`; these are forgotten. In order of position.
  struct Released {
    std::vector<NewOpenEdge> open;     // with one triangle, and not in the input
    std::vector<NewOpenEdge> crowded;  // with more than two triangles
    std::vector<NewOpenEdge> turned;   // of two tiles, with one triangle of each; these go round in the same direction
    std::vector<NewOpenEdge> rims;     // with one triangle in the input, and one or more in the output
  };
  Released ReleaseBelow(int32_t row);

 private:
  struct Sum {
    int32_t before = 0, after = 0, forward = 0, tile = 0, row = 0;
    int32_t single = 0;  // tiles with one triangle there
    bool is_added = false, is_inner = false, is_covered = false;
    int64_t hole = -1;
  };
  std::map<std::array<double, 6>, Sum> sums_;
};

}  // namespace tilemend

#endif  // TILEMEND_WORKER_CHECK_TILE_JOINS_H_
