// A tile's own outline, walked around: where surface ends on it and where it begins again.
#ifndef TILEMEND_COORDINATOR_PLAN_OVERLAP_OUTLINE_WALK_H_
#define TILEMEND_COORDINATOR_PLAN_OVERLAP_OUTLINE_WALK_H_

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "common/records/survey_record.h"
#include "coordinator/plan/overlap/piece_ends.h"
#include "coordinator/plan/types/cell_side.h"

namespace tilemend {

// Of a metre along the outline of a piece or tile, against one across.
inline constexpr double kOutlineWeight = 0.5;

// A rectangle by Side. Places on it are metres counter-clockwise from the south-west corner.
struct Outline {
  std::array<double, 4> side{};

  double Width() const { return side[kEast] - side[kWest]; }
  double Height() const { return side[kNorth] - side[kSouth]; }
  double Length() const { return 2 * (Width() + Height()); }
  // Of the point on a side that is level with p.
  double PlaceOf(const Point3& p, Side s) const;
  // The point at a place, and the side it is on; places may go round more than once.
  std::pair<Point2, Side> At(double place) const;
  double CornerPlace(int corner) const;  // south-west, south-east, north-east, north-west
  Point2 CornerAt(int corner) const;
  // The side that p lies on or beyond, within a hair.
  std::optional<Side> SideAt(const Point3& p) const;
  Side NearestSide(const Point3& p) const;
};

// A way that closes a hole along the outline: from where surface ends to where it begins again.
struct OutlineGap {
  int32_t from = 0, to = 0;   // into SurveyRecord::vertices
  double begin = 0, end = 0;  // places; end > begin, perhaps by way of the south-west corner: then beyond Length()
  bool open = true;           // nothing covers it; else it lies under other surface of the tile
  // The axes across the outlines, of the tile or of a piece, that its ends are on; those of the link, if there is one.
  // Empty: level ones, or none.
  std::optional<int> from_across = {}, to_across = {};
  // Between pieces, and above runs (closed_runs.h): edges of outlines that lead from `to` to the end of the link, and
  // from its beginning to `from`. They bound the hole. The link is what is left of the way; none: it is all of the way.
  std::vector<int32_t> along = {};
  std::optional<std::pair<int32_t, int32_t>> link = {};
};

struct OutlineWalk {
  std::vector<bool> on_outline;  // of each edge of the record
  std::vector<OutlineGap> gaps;
  bool all_open = false;  // no surface reaches the outline
};

// `taken` says for each edge of the record whether it counts; others are on outlines of pieces. Chains that end at
// those are closed as well (MatchPieceEnds), along outlines of pieces where that is shorter; no edge is in the ways of
// two gaps: the gap that MatchPieceEnds gives first has it. Below overhangs ends are matched anew (closed_runs.h).
// `piece_reach` is how far pieces overlap, or part. Every vertex where chains off the outline begin or end is in one
// gap each time. Cost O(n log n), what MatchPieceEnds costs, and for each gap between pieces the edges followed at one
// end times those at the other, up to 1000 each.
OutlineWalk WalkOutline(const SurveyRecord& record, const std::vector<bool>& taken, const Outline& outline,
                        double piece_reach, const std::vector<ChainPassage>& passages = {});

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_OVERLAP_OUTLINE_WALK_H_
