// Where the new vertices of an advancing front go.
#ifndef TILEMEND_WORKER_PAPERS_FRONT_FRONT_RULES_H_
#define TILEMEND_WORKER_PAPERS_FRONT_FRONT_RULES_H_

#include <Eigen/Core>
#include <algorithm>
#include <functional>
#include <optional>
#include <span>

#include "common/mesh/tri_mesh.h"
#include "common/records/filler.h"

namespace tilemend {

// A vertex of the front with its two edges. The front runs before -> at -> after, what is to be filled on its left.
struct FrontCorner {
  Point3 at, before, after;
  Eigen::Vector3d normal;              // unit: Sun 2012, eq. 1
  double angle_rad = 0;                // between the edges, on the side to be filled: Sun 2012, eq. 2
  std::span<const Point3> neighbours;  // of the vertex, in the surface and in the patch so far

  Eigen::Vector3d carried;  // unit: of a vertex of the rim its normal, of a new one the mean of those it came from
  double size = 0;          // how long edges are to be here; 0: as the corner's are

  // Of a new edge: the mean of the corner's edges (eq. 6), but no less than the wanted size. Angles are divided more
  // often than joined. So edges by eq. 6 alone get shorter and shorter, and fronts of 80 edges never close.
  double Length() const { return std::max(((before - at).norm() + (after - at).norm()) / 2, size); }
};

// The place of a new vertex that divides the corner's angle. `share` of it lies between `after` and the new edge.
using FrontRule = std::function<Point3(const FrontCorner&, double share)>;

// By Sun 2012, 2.4: on the tangent plane, bent towards the side to which the surface bends in that direction (eq. 5).
// It is as far off as the mean of the two edges (eq. 6).
//
// The paper takes the curvature of eq. 4 from the new vertex itself, which on the tangent plane is none. Here it is
// that of the paper's reference 14 (Taubin 1995, eq. 3): the second fundamental form that fits best the curvatures
// towards the neighbours. Printed: from the plane of the two edges, with eq. 4 of the vertex there. The bend is 45
// degrees at most.
//   bend  eta of eq. 5, metres; none: half the edge
FrontRule NormalCurvatureRule(std::optional<double> bend, FrontSteps steps = FrontSteps::kSteady);

// The front of Zhao 2007 and Xu 2014, 3.2, which put new vertices on the plane of the two edges. Over ground that is
// even to 0.02 edges, a front of 400 edges leaves it by 25 edges. Each row doubles the error of the one before. Steady,
// they lie on the plane across the normal that the front carries along.
FrontRule PlainRule(FrontSteps steps = FrontSteps::kSteady);

// The angle of eq. 2, radians, in (0, 2 pi).
double FrontAngle(const Point3& at, const Point3& before, const Point3& after, const Eigen::Vector3d& normal);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_PAPERS_FRONT_FRONT_RULES_H_
