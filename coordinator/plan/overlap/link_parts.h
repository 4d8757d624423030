// How densely the links between the chains of a region have vertices.
#ifndef TILEMEND_COORDINATOR_PLAN_OVERLAP_LINK_PARTS_H_
#define TILEMEND_COORDINATOR_PLAN_OVERLAP_LINK_PARTS_H_

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace tilemend {

// The links of one region have vertices as its rim has, but no more than 16 times as many in all. A link may be a
// million times longer than the edges of the chains that it joins.
class LinkParts {
 public:
  // rim: metres, seen from above, over its edges.
  LinkParts(double rim, int64_t edges) : spacing_(rim / static_cast<double>(edges)), left_(kMost * edges) {}

  // Into how many parts, 1 or more, the next link of this length (metres) falls. A rim without length or edges asks
  // for no more than one.
  int64_t Take(double length) {
    const auto more = static_cast<int64_t>(std::clamp(Wanted(length), 0.0, static_cast<double>(left_)));
    left_ -= more;
    return 1 + more;
  }
  // Whether a link of this length is longer than edges of the rim, however many parts are left.
  bool Wants(double length) const { return Wanted(length) > 0; }

 private:
  static constexpr int64_t kMost = 16;

  // Parts beyond the first.
  double Wanted(double length) const { return spacing_ > 0 ? std::ceil(length / spacing_) - 1 : 0; }

  const double spacing_;  // metres
  int64_t left_;          // parts beyond the first of each link
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_OVERLAP_LINK_PARTS_H_
