// How the creases that end at a hole go on through it.
//
// Where the ends of a crease on either side of a hole fit together, a curve carries it through. Where the creases of
// three or more smooth parts end at the hole, they meet in the point that the parts' planes have in common. Examples
// are the corner of a box and the tip of a pyramid.
#ifndef TILEMEND_WORKER_FILL_CREASE_CREASE_NETWORK_H_
#define TILEMEND_WORKER_FILL_CREASE_CREASE_NETWORK_H_

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "worker/fill/crease/crease_ends.h"
#include "worker/fill/hole/rim_loops.h"

namespace tilemend {

// A cubic between two ends, or straight to a corner.
struct CreaseCurve {
  int32_t from = 0;  // an end; -1 - c: corner c
  int32_t to = 0;
  Point3 start, finish;
  Eigen::Vector3d start_slope, finish_slope;  // derivatives at 0 and 1

  Point3 At(double t) const;  // t in [0, 1]
  Eigen::Vector3d SlopeAt(double t) const;
};

// A point inside the hole where three or more parts of the surface meet.
struct CreaseCorner {
  Point3 position;
  std::vector<int32_t> curves;  // that end there, in the order in which the rim passes their other ends
};

struct CreaseNetwork {
  std::vector<CreaseEnd> ends;
  std::vector<CreaseCorner> corners;
  std::vector<CreaseCurve> curves;  // they cross each other nowhere; an end belongs to at most one
};

// The creases that go on through the hole. Two ends are joined if their angles agree (sign included) and each points at
// the other as nearly as a curve needs. The smooth parts on either side must fit as well. Shorter curves come first. Of
// the ends left over, three neighbours along a loop with flat parts between them are joined in a corner. Four to eight
// are joined in one if the planes of all parts have a point in common (the tip of a pyramid). Four others are joined in
// two corners with a crease between these (the edge of a box from its roof to the ground). An end that fits none is
// left alone. A curve that the rim touches is parted there. A rim with more than 1,000 ends has none. O(rim log rim +
// ends (rim + ends log ends)), and for each curve the vertices of the rim near it. Deterministic.
CreaseNetwork FindCreases(std::span<const RimLoop> loops, Bends bends);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_CREASE_CREASE_NETWORK_H_
