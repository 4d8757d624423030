// The height that most of a rim has: mode and quantiles of heights along it.
#ifndef TILEMEND_COORDINATOR_PLAN_WATER_HALF_SAMPLE_MODE_H_
#define TILEMEND_COORDINATOR_PLAN_WATER_HALF_SAMPLE_MODE_H_

#include <span>

namespace tilemend {

// An edge of a rim.
struct WeightedHeight {
  double height = 0;  // metres, of its middle
  double length = 0;  // metres seen from above, >= 0
  double weight = 0;  // >= 0: length over the uncertainty of the height

  friend bool operator==(const WeightedHeight&, const WeightedHeight&) = default;
  friend auto operator<=>(const WeightedHeight&, const WeightedHeight&) = default;
};

// All functions ask for a range that is sorted and not empty, and return metres. They depend on its values alone.

// The height that `share` (0 to 1) of the length lies at or below. Cost linear.
double WeightedQuantile(std::span<const WeightedHeight> sorted, double share);

// The half-sample mode (Bickel and Fruehwirth 2006). The shortest interval that holds half of the weight is kept, again
// and again, until three edges or fewer are left. Their weighted mean. Of intervals of the same extent the heaviest
// counts, then the lowest. Cost linear.
double HalfSampleMode(std::span<const WeightedHeight> sorted);

// The level of water with this rim: the half-sample mode of the lower half of its length. What stands at the water
// (trees, quays, bridges) is in the upper half, so it does not count. Cost linear.
double LowerMode(std::span<const WeightedHeight> sorted);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_WATER_HALF_SAMPLE_MODE_H_
