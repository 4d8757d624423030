// Sharp edges that enter a hole, and how they go on through it.
//
// A crease is where two smooth parts of the surface meet at an angle: a roof's edge, the foot of a wall. Where its ends
// on either side of a hole fit together, a curve carries it through; where the creases of three smooth parts end at the
// hole, they meet in the point that the parts' planes have in common (the corner of a box).
#ifndef TILEMEND_WORKER_FILL_CREASE_CREASE_CURVES_H_
#define TILEMEND_WORKER_FILL_CREASE_CREASE_CURVES_H_

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "worker/fill/hole/rim_loops.h"

namespace tilemend {

// A crease that ends at the rim.
struct FeatureEnd {
  int32_t loop = 0;
  int32_t place = 0;        // in the loop: where the rim crosses the crease
  int32_t order = 0;        // among the ends at one place, along the rim
  Eigen::Vector3d before;   // unit normal of the surface beside the rim before the place
  Eigen::Vector3d after;    // and after it
  Eigen::Vector3d tangent;  // unit, along the crease into the hole
};

// A cubic between two ends, or straight to a corner.
struct FeatureCurve {
  int32_t from = 0;  // an end; -1 - c: corner c
  int32_t to = 0;
  Point3 start, finish;
  Eigen::Vector3d start_slope, finish_slope;  // derivatives at 0 and 1

  Point3 At(double t) const;  // t in [0, 1]
  Eigen::Vector3d SlopeAt(double t) const;
};

// A point inside the hole where three parts of the surface meet.
struct FeatureCorner {
  Point3 position;
  std::array<int32_t, 3> curves;  // that end there, in the order in which the rim passes their other ends
};

struct FeatureNetwork {
  std::vector<FeatureEnd> ends;
  std::vector<FeatureCorner> corners;
  std::vector<FeatureCurve> curves;  // they cross each other nowhere; an end belongs to at most one
};

// Where creases end at the rim of a hole, in order of loop and place. A crease is a place where the normals beside the
// rim change by at least 30 degrees, are alike before it and alike after it: rough ground and round walls have none.
// O(rim * bends).
std::vector<FeatureEnd> FindFeatureEnds(std::span<const RimLoop> loops);

// The creases that go on through the hole. Two ends are joined if their angles agree (sign included), each points at
// the other as nearly as a curve needs, and the smooth parts on either side fit; shorter curves first. Of the ends left
// over, three neighbours along a loop with flat parts between them are joined in a corner, four in two corners with a
// crease between these (the edge of a box from its roof to the ground). An end that fits none is left alone. A curve
// that the rim touches is parted there. O(rim * (ends + curves) + ends^2 log ends). Deterministic.
FeatureNetwork FindFeatures(std::span<const RimLoop> loops);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_CREASE_CREASE_CURVES_H_
