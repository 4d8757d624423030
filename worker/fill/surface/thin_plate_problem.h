// What the thin-plate surface of a patch is found from.
#ifndef TILEMEND_WORKER_FILL_SURFACE_THIN_PLATE_PROBLEM_H_
#define TILEMEND_WORKER_FILL_SURFACE_THIN_PLATE_PROBLEM_H_

#include <functional>
#include <optional>
#include <vector>

#include "common/mesh/tri_mesh.h"

namespace tilemend {

// A patch over the plane: x, y of all points, z of those whose height is known.
struct ThinPlateProblem {
  std::vector<Point3> points;
  std::vector<bool> known;      // whether the height of a point is known
  std::vector<Triangle> patch;  // over known and unknown points
  std::vector<Triangle> band;   // original triangles at the rim, over known points: give the slope there
  // Points with an equation of their own: everything around them is in patch and band. Others bend freely.
  std::vector<bool> has_equation;
  // The Laplacian at points (1 / metre) where it is known from a larger solve: seam vertices. One entry for each point
  // or none.
  std::vector<std::optional<double>> laplacian;
  // A surface near the one that is looked for, above or below the points: it bends along this one. One entry for each
  // point or none: it bends along the plane of x and y.
  std::vector<Point3> along = {};
  // Weight of |gradient|^2 against |Laplacian|^2, 1 / metre^2: the square of an inverse length beyond which the surface
  // is taut.
  double tension = 0;
  // Asked now and then; true ends a solver without a result. None: never.
  std::function<bool()> is_cancelled = {};
  bool cancelled() const { return is_cancelled && is_cancelled(); }
};

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SURFACE_THIN_PLATE_PROBLEM_H_
