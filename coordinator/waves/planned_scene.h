// The plan of a scene, what is settled of it, and the work that is made of it.
#ifndef TILEMEND_COORDINATOR_WAVES_PLANNED_SCENE_H_
#define TILEMEND_COORDINATOR_WAVES_PLANNED_SCENE_H_

#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "coordinator/plan/seam/seam_heights.h"
#include "coordinator/plan/types/plan_types.h"
#include "coordinator/waves/scene_survey.h"
#include "coordinator/waves/scene_work.h"
#include "coordinator/waves/wave_order.h"

namespace tilemend {

struct PlannedScene {
  const SceneSurvey& survey;                             // that the plan is made of
  Plan plan = {};                                        // empty until all of the survey is there
  SeamHeights heights = {};                              // of its vertices; the waves after the plan add to them
  std::map<CellId, std::vector<int32_t>> holes_of = {};  // those to fill. Cells that are left go
  bool float32 = false;                                  // some tile is
  bool is_coloured = false;                              // some hole has a colour
};

// By cell, the holes that the plan finds no fault with. Of cells that are not chosen those whose clusters reach chosen
// ones, and no cell without any. No chosen cells: all are.
std::map<CellId, std::vector<int32_t>> HolesToFill(const Plan& plan, const std::set<CellId>& chosen);

// Sets all but the survey. Cost as MakePlan.
void MakeThePlan(const WaveOptions& options, const PlanOptions& plan, PlannedScene& scene);

// Borders between chosen cells that both have holes to fill.
std::vector<BorderAudit> BordersToCompare(const PlannedScene& scene, const WaveOptions& options);

// The holes of a cell in a layer with seam vertices that are not settled.
std::vector<int32_t> HolesOfLayer(const PlannedScene& scene, CellId cell, int32_t layer);
// The last layer of those that are no water; 1 where there is none.
int32_t LastLayerOf(const Plan& plan, const std::vector<int32_t>& holes);
// Whether all seam vertices of the cell are settled, and it has holes to fill.
bool CanBeFilled(const PlannedScene& scene, CellId cell);

LayerWork LayerWorkOf(const PlannedScene& scene, CellId cell, int32_t layer);
// With the surface wang it samples what is left of `layer`.
FillWork FillWorkOf(const PlannedScene& scene, CellId cell, int32_t layer, bool is_wang);
AssembleWork AssembleWorkOf(const PlannedScene& scene, CellId cell, bool is_wang);
// All holes to fill of a cell, without bands, with the heights that are settled now.
CellHoles HolesAsFilled(const PlannedScene& scene, CellId cell);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_WAVES_PLANNED_SCENE_H_
