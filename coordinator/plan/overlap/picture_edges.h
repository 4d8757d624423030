// Which edges of a tile the boundaries of the plan's holes run along.
#ifndef TILEMEND_COORDINATOR_PLAN_OVERLAP_PICTURE_EDGES_H_
#define TILEMEND_COORDINATOR_PLAN_OVERLAP_PICTURE_EDGES_H_

#include <cstdint>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "coordinator/plan/overlap/joint_tiles.h"
#include "coordinator/plan/overlap/piece_ends.h"

namespace tilemend {

// The plan sees a tile as what its boundary winds around from above. So its holes are bounded by edges of the tile and
// by parts of such, between places where edges cross. Holes are walked around against the direction of edges.
class PictureEdges {
 public:
  // Of a tile that is in `joint`, whose vertices have the numbers `vertices` in the plan: of JointTiles::records. The
  // tiles must outlive it.
  PictureEdges(const JointTiles& joint, CellId cell, const std::vector<int32_t>& vertices);

  // Whether a vertex of the plan is one of the tile's own.
  bool IsOwn(int32_t v) const { return own_vertex_.contains(v); }
  // The edge that a segment is.
  std::optional<int32_t> Whole(const RimSegment& s) const;
  // The edges that pass at its ends, where these are none of the tile's vertices.
  std::vector<int32_t> AtEnds(const RimSegment& s) const;
  // Where a hole's boundary passes from one chain to another, at once or along outlines of pieces; and where it comes
  // to a grid line, or from one, along outlines.
  std::vector<ChainPassage> PassagesOf(const Plan& plan, const PlannedHole& hole) const;

 private:
  // The edge that a segment is, or is a part of.
  std::optional<int32_t> Under(const RimSegment& s) const;
  bool Passes(int32_t edge, int32_t v) const;
  // Whether a segment lies on a grid line: it is a seam, or another tile's edge.
  bool IsOnLine(const Plan& plan, const RimSegment& s) const;

  const SurveyRecord& record_;
  const std::vector<bool>& chain_;                             // as JointTiles
  const ClipSquare& square_;                                   // likewise
  std::unordered_map<int32_t, int32_t> own_vertex_;            // plan vertex -> of the record
  std::unordered_map<int32_t, std::vector<int32_t>> through_;  // other plan vertex -> edges of the record there
  std::map<std::pair<int32_t, int32_t>, int32_t> edge_;        // of the record, by its ends
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_OVERLAP_PICTURE_EDGES_H_
