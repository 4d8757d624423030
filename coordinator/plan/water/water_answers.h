// What became of the areas that the user drew.
#ifndef TILEMEND_COORDINATOR_PLAN_WATER_WATER_ANSWERS_H_
#define TILEMEND_COORDINATOR_PLAN_WATER_WATER_ANSWERS_H_

#include <functional>
#include <optional>

#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// Of the cells of a scene.
struct PlaneBounds {
  Point2 low, high;
};

// None without a grid.
std::optional<PlaneBounds> BoundsOfCells(const PlanInput& input);

// Fills plan.water_answers, one for each of options.areas, from what FindWater has decided. An area is taken if some
// body is filled as it says, and it is the last that covers more than half of that body. The reason is about the body
// of which it covers most, if that is not filled so, or that the area lies outside `scene`. A decision is taken where
// Plan::decisions says so (DecideHoles), and its reason is about the body that it fits best. Unless that is filled so
// and has most of it, other bodies of which it covers a tenth or more are in its doubt. Once cancelled it ends soon,
// and the plan is not to be used. Cost as AreaIndex for each body, and what the answers tell.
void AnswerWaterAreas(const WaterOptions& options, Plan& plan, const std::optional<PlaneBounds>& scene = std::nullopt,
                      const std::function<bool()>& is_cancelled = {});

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_WATER_WATER_ANSWERS_H_
