// Heights of a rim from which those of a surface are foretold.
#ifndef TILEMEND_WORKER_FILL_SURFACE_RIM_SAMPLES_H_
#define TILEMEND_WORKER_FILL_SURFACE_RIM_SAMPLES_H_

#include <cstdint>
#include <utility>
#include <vector>

#include "worker/fill/surface/thin_plate_problem.h"

namespace tilemend {

// A square of a raster of that side over the ground, moved by offsets in sides.
using RasterSquare = std::pair<int64_t, int64_t>;
RasterSquare SquareOf(const Point3& p, double side, double x_offset, double y_offset);

// Rim points, and for each the farthest band point beside it: the two tell the slope there.
struct RimSamples {
  std::vector<Point3> samples;  // in the order of their coordinates, no two above each other
  int32_t rim_points = 0;       // of the whole rim: known points with an equation
  double spacing = 0;           // rim points nearer than about this were left out, metres
  bool in_a_plane = false;      // to within rounding
};

// Does not depend on the order of points. O(n log n).
//   width            of the hole, metres; positive (hole_width.h)
//   most_rim_points  as many are taken, evenly
RimSamples SampleRim(const ThinPlateProblem& problem, double width, size_t most_rim_points);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SURFACE_RIM_SAMPLES_H_
