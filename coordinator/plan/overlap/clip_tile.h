// The boundary of one tile pressed into the square of its cell.
#ifndef TILEMEND_COORDINATOR_PLAN_OVERLAP_CLIP_TILE_H_
#define TILEMEND_COORDINATOR_PLAN_OVERLAP_CLIP_TILE_H_

#include <array>
#include <cstdint>
#include <vector>

#include "common/records/survey_record.h"
#include "coordinator/plan/rim/grid_lines.h"

namespace tilemend {

// The square of a cell, and where its tile is cut for it: at the side, or at the tile's own outline where that lies
// inside the side.
struct ClipSquare {
  std::array<double, 4> side{};  // by Side: the coordinate of the grid line
  std::array<double, 4> cut{};   // never outside the side

  bool Beyond(const Point3& p, Side s) const { return (p[AxisOf(s)] - cut[s]) * OutwardOf(s) >= 0; }
  bool Contains(const Point3& p) const;
};

// Where a boundary edge passes a side of the square.
struct Crossing {
  int32_t edge = 0;  // into SurveyRecord::edges
  Side side = kWest;
  double t = 0;         // along the side
  double height = 0;    // of the edge there
  double length = 0;    // of the edge, seen from above
  bool leaves = false;  // the edge runs out of the square
};

// An end of a part of the clipped boundary: a vertex of the record, or a crossing.
struct ClipEnd {
  int32_t vertex = -1;    // into SurveyRecord::vertices
  int32_t crossing = -1;  // into ClippedTile::crossings
};

struct InnerPart {
  ClipEnd from, to;
};

// What lies beyond a side is pressed against it.
struct SidePart {
  Side side = kWest;
  double from = 0, to = 0;  // along the side
  double from_height = 0, to_height = 0;
  int32_t from_crossing = -1, to_crossing = -1;  // the crossing at that end, if it is one of this side
};

struct CornerPoint {
  std::array<Side, 2> sides;  // west or east, then south or north
  double height = 0;
};

// The tile's boundary as the image of a map that leaves the square as it is and presses everything else against its
// sides: loops stay loops, and what a tile has beyond a grid line becomes a stretch of that line.
struct ClippedTile {
  std::vector<Crossing> crossings;
  std::vector<InnerPart> inner;
  std::vector<SidePart> at_side;
  std::vector<CornerPoint> corners;  // vertices that are pressed into a corner
};

// Cost linear in the edges.
ClippedTile ClipTile(const SurveyRecord& record, const ClipSquare& square);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_OVERLAP_CLIP_TILE_H_
