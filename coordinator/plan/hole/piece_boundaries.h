// How far the boundaries of a tile's pieces of surface reach.
#ifndef TILEMEND_COORDINATOR_PLAN_HOLE_PIECE_BOUNDARIES_H_
#define TILEMEND_COORDINATOR_PLAN_HOLE_PIECE_BOUNDARIES_H_

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "coordinator/plan/hole/cell_boundary.h"
#include "coordinator/plan/hole/hole_site.h"

namespace tilemend {

// The pieces of one cell's tile. Both must outlive it. Reads the tile's outline when it is first asked, linear in its
// edges.
class PieceBoundaries {
 public:
  PieceBoundaries(const HoleSite& site, const CellBoundary& boundary) : site_(site), boundary_(boundary) {}

  // Whether the boundary of the piece of surface along a loop of rim points reaches beyond the loop, seen from above.
  // Nothing if that is not known.
  std::optional<bool> ReachBeyond(const std::vector<RimSegment>& loop);

 private:
  void Read();

  const HoleSite& site_;
  const CellBoundary& boundary_;
  bool is_read_ = false;
  std::unordered_map<uint64_t, int32_t> piece_of_;  // by EdgeKey of rim points
  std::vector<Eigen::AlignedBox2d> extent_of_;      // by piece
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_HOLE_PIECE_BOUNDARIES_H_
