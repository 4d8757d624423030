// The rim of the surface: the boundary edges that remain when the tiles are put together, linked to loops.
#ifndef TILEMEND_COORDINATOR_PLAN_RIM_RIM_H_
#define TILEMEND_COORDINATOR_PLAN_RIM_RIM_H_

#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// BoundaryEdge::piece of an edge along the edge of an area polygon. Its new vertices have BoundaryVertex::index -1.
inline constexpr int32_t kAreaPiece = -1;

struct RimPoint {
  CellId tile;        // of the first tile (by cell) that has it
  int32_t index = 0;  // -1: a new vertex on the edge of the area (seam/area_edge.h), without a height
  Point3 position{0, 0, 0};
  Eigen::Vector3d normal{0, 0, 1};
  double centroid_height = 0;
  double size = 0;  // mean length of the rim edges here
  // How near a grid line is near, on a ragged cut: the size, but at most 1.5 times the same length seen from above.
  double reach = 0;
};

struct RimEdge {
  int32_t from = 0, to = 0;  // points; surface on the left
  CellId owner;              // whose triangle it bounds; of an edge of the area: the cell that closes on it
  bool area_edge = false;    // along the edge of an area polygon, with nothing to be covered on the left
};

struct Rim {
  std::vector<RimPoint> points;
  std::vector<RimEdge> edges;
  std::vector<std::vector<int32_t>> loops;  // edges in order; each edge is in one loop or in `unlinked`
  std::vector<int32_t> unlinked;            // edges of chains that do not close (non-manifold surface)
  int32_t continuous = 0;                   // groups of loops that touch
  // Per tile: the point of each boundary vertex of its record, -1: none. Tiles without any are not there.
  std::map<CellId, std::vector<int32_t>> point_of;
  bool surface_beyond = false;  // an area polygon bounds the holes: what lies beyond all edges counts as surface
};

// Metres. Along the edge of an area new vertices have no height yet: seen from above there.
double LengthOf(const Rim& rim, const RimEdge& e);

enum class RimPoints { kAll, kOfEdges };  // every boundary vertex of every tile, or the ends of the rim's edges

// Puts the tiles together: matches boundary edges of different tiles at equal positions, drops the
// matched ones, and links the others to loops. Where several holes touch at a vertex each loop turns back into its own
// hole (Zhang 2022, 3.3). Cost linear in the boundary edges, but for the maps. Memory
// beside the rim, with kOfEdges: the boundaries of two columns of cells; vertices must lie within the tiles' bounds
// then.
Rim BuildRim(const PlanInput& input, RimPoints keep = RimPoints::kAll);

// Links the edges to loops anew.
//   after  for each edge the one that leaves its end around the same fan of triangles, -1: unknown; empty: all are.
//          Where all that end at a point are known, the fans lie one after the other around it, and holes between
//          them, also where two fans lie edge on edge or overlap a little.
void LinkLoops(Rim& rim, std::span<const int32_t> after = {});

// Edges in a row as boundary segments of the hole, in the order of a walk that has the hole on the left. An edge has it
// on the right.
std::vector<RimSegment> Reversed(const Rim& rim, std::span<const int32_t> edges);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_RIM_RIM_H_
