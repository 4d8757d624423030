// One colour for every body of water, cluster and closed hole, from what lies along its rim.
#ifndef TILEMEND_COORDINATOR_PLAN_COLOUR_HOLE_COLOURS_H_
#define TILEMEND_COORDINATOR_PLAN_COLOUR_HOLE_COLOURS_H_

#include <optional>
#include <vector>

#include "common/records/fill_colour.h"
#include "common/util/colour.h"
#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// What holes get along whose rim no colour is known.
inline constexpr Rgb kWaterColour = {95, 120, 135};
inline constexpr Rgb kGroundColour = {140, 138, 130};

// The colours of the plan's holes, in their order. A group of holes is a body of water, else a cluster, else a closed
// hole on its own. Its colour is the median, for each channel, of the colours at the original vertices of all rims of
// its holes. Each vertex counts once, and none that stands on an object, unless there is nothing else. All water has
// the colour `water`, if given. As many boats and blurred texels as all else are needed to change a median. It does not
// depend on the order of anything. Cost: linear in the rims, but for sorting the vertices of a group.
std::vector<FillColour> ColourHoles(const Plan& plan, const PlanInput& input, const std::optional<Rgb>& water);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_COLOUR_HOLE_COLOURS_H_
