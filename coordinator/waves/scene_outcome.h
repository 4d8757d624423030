// What became of the holes of a plan.
#ifndef TILEMEND_COORDINATOR_WAVES_SCENE_OUTCOME_H_
#define TILEMEND_COORDINATOR_WAVES_SCENE_OUTCOME_H_

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "common/mesh/quality_tally.h"
#include "common/records/cell_holes.h"
#include "coordinator/plan/types/plan_types.h"
#include "coordinator/waves/clearing.h"
#include "coordinator/waves/scene_work.h"

namespace tilemend {

struct PatchSize {
  int64_t new_vertices = 0;
  int64_t triangles = 0;
  FillWay way = FillWay::kNone;
  int32_t loop_cuts = 0, creases = 0, crossings = 0;  // as HolePatch
  bool rim_is_crossed = false;                        // as HolePatch
};

// By hole or cluster of the plan.
struct SceneOutcome {
  std::map<int32_t, PatchSize> sizes;                // of the holes that were filled
  int64_t triangles = 0;                             // of `sizes`
  std::set<CellId> filled;                           // cells with a patch
  std::map<int32_t, std::string> failures;           // of the holes that were tried in vain: why
  std::vector<LeftOpen> unwritten;                   // tiles that could not be written
  std::multimap<CellId, std::string> impaired;       // cells that were filled without some result: which, and why
  std::map<int32_t, HoldOut> of_clusters, of_holes;  // where tensions were chosen
  std::set<CellId> chosen;                           // cells that were to be filled; empty: all
  std::map<CellId, PackedTally> quality_of;          // of the new triangles, by cell
  std::vector<ClearedArea> cleared;                  // one for each area that asks for surface to be taken out
  // Of borders where fills overlap (BorderAudit::a and b): how far apart they are there.
  std::map<std::pair<CellId, CellId>, SurfaceGap> fill_gaps;

  // The hole stays open, whatever was known of it before.
  void Fail(int32_t hole, const std::string& reason);
  // Enters the patches of a cell. kInvalidArgument for a hole that is not in the plan.
  absl::Status Add(const CellFill& result, const Plan& plan);
  // The tile of the cell is not written, for a reason that `left` tells. Its holes are for Fail.
  void DropTile(LeftOpen left);
  // Enters the gaps between the fills of tiles that are written. Call it once, after all DropTile.
  void SetGaps(std::map<std::pair<CellId, CellId>, SurfaceGap> gaps);

  // Of all new triangles. Cost O(cells with a patch).
  QualityTally Quality() const;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_WAVES_SCENE_OUTCOME_H_
