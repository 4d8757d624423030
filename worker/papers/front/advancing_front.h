// Covers a hole with triangles from its boundary inward.
#ifndef TILEMEND_WORKER_PAPERS_FRONT_ADVANCING_FRONT_H_
#define TILEMEND_WORKER_PAPERS_FRONT_ADVANCING_FRONT_H_

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <vector>

#include "common/mesh/tri_mesh.h"
#include "worker/papers/front/front_rules.h"

namespace tilemend {

// The boundary that a front begins with, and the surface at it.
struct FrontRim {
  std::vector<Point3> points;
  std::vector<std::vector<int32_t>> loops;         // of points, the hole on the left, seen from outside
  std::vector<Eigen::Vector3d> areas;              // of each point: twice the vector area of the surface around it
  std::vector<std::vector<Point3>> neighbours;     // of each point, in the surface
  std::vector<double> sizes;                       // of each point: how long edges are to be, metres
  std::function<bool(int32_t, int32_t)> may_join;  // whether a new edge may run between two points
};

struct FrontLimits {
  bool by_corners = false;      // edges are as long as their corner's, however short: FrontCorner::size is 0
  double merge = 0.6;           // FillerOptions::merge
  int64_t most_new_points = 0;  // more than these: the front does not close
  int64_t longest_front = 0;    // likewise, of vertices on it
  int64_t most_looks = 0;       // likewise, of edges of the front that are looked at: kTooMuchWork
  std::function<bool()> is_cancelled = {};  // asked now and then; none: never
};

enum class FrontEnd { kOpen, kClosed, kTooMuchWork };

struct FrontPatch {
  FrontEnd end = FrontEnd::kOpen;  // but for kClosed: no triangles
  std::vector<Point3> points;      // those of the rim first
  std::vector<Triangle> triangles;

  bool closed() const { return end == FrontEnd::kClosed; }
};

// The advancing front of Zhao 2007, Sun 2012 and Xu 2014, the smallest angle of the front first. At most 75 degrees,
// its two neighbours are joined. At most 135, a new vertex divides it, else two; where they go is the rule's. Normals
// of vertices on the front are those of eq. 1 of Sun 2012. They are of the triangles around them, and of the one that
// would join their neighbours. A new vertex near the front, or beyond it, is given up for a vertex of the front there
// (Xu 2014, 3.2, step 4). So the front parts, and fronts around islands join.
//
// What the papers leave open: what is done where a triangle would cover others. Seen along its normal, no new triangle
// covers a vertex of the front or crosses an edge of it. A corner that allows none waits until its neighbours have
// changed. When all wait, new vertices may lie near the front. At last the smallest angle is joined whatever it covers.
// So a patch may cross itself: the caller checks it. No edge is made twice.
//
// About O(log n) for each new point, where the front is nowhere crowded. Deterministic.
FrontPatch AdvanceFront(const FrontRim& rim, const FrontRule& rule, const FrontLimits& limits);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_PAPERS_FRONT_ADVANCING_FRONT_H_
