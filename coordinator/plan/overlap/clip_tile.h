// The boundary of one tile seen from above, cut at the sides of its cell.
#ifndef TILEMEND_COORDINATOR_PLAN_OVERLAP_CLIP_TILE_H_
#define TILEMEND_COORDINATOR_PLAN_OVERLAP_CLIP_TILE_H_

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "common/mesh/edge_loops.h"
#include "common/records/survey_record.h"
#include "coordinator/plan/overlap/area_outside.h"
#include "coordinator/plan/rim/grid_lines.h"

namespace tilemend {

// The square of a cell, and where its tile is cut for it. The cut is at the side, or at the tile's own outline if that
// lies inside.
struct ClipSquare {
  std::array<double, 4> side{};  // by Side: the coordinate of the grid line
  std::array<double, 4> cut{};   // never outside the side

  bool Beyond(const Point3& p, Side s) const { return (p[AxisOf(s)] - cut[s]) * OutwardOf(s) >= 0; }
  bool Contains(const Point3& p) const;
};

// A vertex of the clipped boundary that the tile does not have.
struct ClipVertex {
  Point3 position{0, 0, 0};
  std::vector<int32_t> through;  // into SurveyRecord::edges: those that pass there; none at a corner of the square
  double length = 0;             // of the shortest of them, seen from above
  bool outside = false;          // of what is outside the area alone, without a height
};

// What lies on one side of the square.
struct SideCover {
  std::map<double, int> step;     // along the side: how much more surface there is from here on
  std::map<double, int> of_tile;  // the same of the tile's surface alone, without what is outside the area
  // Of the tile's own vertices beyond the side, by where they are along it. Not of those above another edge beyond it:
  // a hole ends at the lowest surface there.
  std::map<double, double> height;
};

struct ClippedTile {
  std::vector<ClipVertex> vertices;  // numbered on from those of the record and then AreaOutside::points
  std::vector<DirectedEdge> inner;   // the boundary inside the square, the surface on its left
  std::vector<bool> on_area_edge;    // of `inner`: between surface outside the area and a hole inside
  std::array<SideCover, 4> sides;
  std::vector<bool> cut;  // of each edge of the record: whether its loop was cut for this; others are in `inner` as is
};

// Clips the loops that leave the square or have an outline of a piece (piece_outlines.h), and islands of surface where
// those leave none. The result is what they wind around seen from above (wound_region.h), in the square. So the clipped
// boundary is simple there whatever the tile's folds. Slivers go. What is outside the area counts as surface; its box
// holds the square. Cost as FindWoundRegion.
ClippedTile ClipTile(const SurveyRecord& record, const std::vector<bool>& on_piece_outline, const ClipSquare& square,
                     const AreaOutside& outside = {});

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_OVERLAP_CLIP_TILE_H_
