// The seams that the surface of Wang 2021 smooths.
#ifndef TILEMEND_COORDINATOR_WAVES_PAIR_SEAMS_H_
#define TILEMEND_COORDINATOR_WAVES_PAIR_SEAMS_H_

#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "coordinator/plan/seam/seam_heights.h"
#include "coordinator/plan/types/plan_types.h"
#include "coordinator/waves/planned_scene.h"
#include "coordinator/waves/scene_work.h"
#include "coordinator/waves/wave_order.h"

namespace tilemend {

using CellPair = std::pair<CellId, CellId>;  // the lower one first

// What two cells have in common. Numbers of the plan.
struct PairSeam {
  std::set<int32_t> holes_of_first, holes_of_second;
  std::set<int32_t> vertices;  // of seams, with a height
  int32_t number = 0;          // of those whose first cell is the same; cells across a corner have one too
};

// The seams between holes of one layer in two cells (Wang 2021, 3.4). `holes` are those that were filled; water and
// closed ones have none. O(n log n) in their segments.
std::map<CellPair, PairSeam> FindPairSeams(const Plan& plan, std::span<const int32_t> holes,
                                           const SeamHeights& heights);

// The wave that smooths them. Pure; one thread at a time.
class PairSmoothing {
 public:
  // Finds the seams that touch a chosen cell. Their numbers are from 0. Returns the first cell of each.
  std::vector<CellId> Begin(const PlannedScene& scene, const std::map<int32_t, std::string>& failures,
                            const WaveOptions& options);
  SmoothWork WorkOf(int32_t seam, const PlannedScene& scene) const;
  // kInvalidArgument for a vertex that is not in the plan, and for a height that is no number.
  absl::Status Take(const SmoothedSeam& result, const Plan& plan);
  // All results have been taken.
  void Settle(PlannedScene& scene) const { SettleSmoothed(scene.plan, smoothed_, scene.heights); }

 private:
  std::vector<std::pair<CellPair, PairSeam>> seams_;
  SmoothedHeights smoothed_;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_WAVES_PAIR_SEAMS_H_
