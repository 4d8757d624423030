// Where a rim touches the creases that go on through its hole.
#ifndef TILEMEND_WORKER_FILL_CREASE_RIM_TOUCHES_H_
#define TILEMEND_WORKER_FILL_CREASE_RIM_TOUCHES_H_

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "common/mesh/box_tree.h"
#include "worker/fill/crease/crease_network.h"
#include "worker/fill/hole/local_hole.h"

namespace tilemend {

// A place where the rim touches a curve without crossing it.
struct RimTouch {
  int32_t loop = 0, place = 0;
  double at = 0;  // of the curve's [0, 1]
};

// The vertices of a rim, by where they lie. Building: O(n log n).
class RimTouches {
 public:
  // The loops must outlive it.
  explicit RimTouches(std::span<const RimLoop> loops);

  // The first vertex of the rim that lies on a curve, but for those that are ends of curves. Costs what lies near it.
  std::optional<RimTouch> FirstOn(const CreaseCurve& curve, const std::function<bool(const RimTouch&)>& is_end) const;

 private:
  struct Place {
    int32_t loop, place;
    double reach;  // how near to a curve it lies on that
  };

  std::span<const RimLoop> loops_;
  std::vector<Place> places_;
  BoxTree tree_;  // of boxes that reach about each of them
};

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_CREASE_RIM_TOUCHES_H_
