// The shores of water whose surface was taken out.
#ifndef TILEMEND_COORDINATOR_PLAN_WATER_CLEAR_SHORES_H_
#define TILEMEND_COORDINATOR_PLAN_WATER_CLEAR_SHORES_H_

#include <functional>
#include <vector>

#include "common/grid/scene.h"
#include "common/grid/water_areas.h"
#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// Sets PlanVertex::on_object of original rim vertices that are more than kFlatWithin off the water, in bodies that an
// area with `clear` decides on (FindDecidingArea). So the water is level up to its rim, which is the outline of whole
// triangles here and no shore. Call it when plan.water is known. Once cancelled it ends soon. Cost as AreaIndex for
// each body.
void MarkClearedShores(const std::vector<WaterArea>& areas, Plan& plan, const std::function<bool()>& is_cancelled = {});

// Adds to plan.left the cells that an area took surface out of, where it covers more than a hundredth and lies over no
// hole. What was taken out is not filled again. Once cancelled it ends soon. Cost as AreaIndex for each hole in such
// a cell, and as CoverLines for each cell of each area.
void LeaveClearedCells(const Grid& grid, const std::vector<WaterArea>& areas, Plan& plan,
                       const std::function<bool()>& is_cancelled = {});

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_WATER_CLEAR_SHORES_H_
