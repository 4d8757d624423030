// How the pieces of a tile were cut: along which planes, and how far they overlap.
#ifndef TILEMEND_COORDINATOR_PLAN_RIM_PIECE_LAYOUT_H_
#define TILEMEND_COORDINATOR_PLAN_RIM_PIECE_LAYOUT_H_

#include <Eigen/Core>
#include <optional>

#include "common/records/survey_record.h"

namespace tilemend {

struct PieceLayout {
  double reach = 0;            // metres: pieces overlap by less than this; 0: a tile is one piece
  Eigen::Vector2d axis{1, 0};  // unit: the upright planes lie along it and across it
};

// Told from the boundary of one tile; none if the tile is not in pieces that overlap, or its boundary does not close.
// An export cuts a mesh into the leaves of a tree, and lets all of them overlap by one length. So edges are paired with
// the nearest edge whose surface lies on the other side. If these pairs agree about how far surface lies over surface,
// the tile is in pieces. Exports in a map's frame are cut along its axes, which are turned in the frame of a tileset.
// Cost: O(n log n) in the edges. Some thousand of them are asked, and a bounded number of others around; where that is
// not enough, there is no layout.
std::optional<PieceLayout> FindPieceLayout(const SurveyRecord& record);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_RIM_PIECE_LAYOUT_H_
