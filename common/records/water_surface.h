// The surface of a body of water that is not level: a river's.
#ifndef TILEMEND_COMMON_RECORDS_WATER_SURFACE_H_
#define TILEMEND_COMMON_RECORDS_WATER_SURFACE_H_

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "common/mesh/tri_mesh.h"

namespace tilemend {

// Stations along the centreline of a river, downstream: x, y and the level of the water, which never rises.
struct WaterSurface {
  std::vector<Point3> stations;
};

// A rise of the level downstream that the shores have and the surface does not.
struct RemovedRise {
  Point2 at{0, 0};  // the station downstream
  double rise = 0;  // metres
};

// The place on a line that is nearest to p: which piece of the line, and how far along it (0 to 1).
struct PlaceOnLine {
  size_t piece = 0;
  double along = 0;
  double distance = std::numeric_limits<double>::infinity();
};

// Precondition: at least two points, whose z does not count. Cost linear in them. Of equal places the first.
inline PlaceOnLine NearestOnLine(const std::vector<Point3>& line, const Point2& p) {
  PlaceOnLine best;
  for (size_t i = 0; i + 1 < line.size(); ++i) {
    const Point2 a = line[i].head<2>(), way = line[i + 1].head<2>() - a;
    const double length = way.squaredNorm();
    const double along = length > 0 ? std::clamp(way.dot(p - a) / length, 0.0, 1.0) : 0;
    const double distance = (a + along * way - p).norm();
    if (distance < best.distance) best = {i, along, distance};
  }
  return best;
}

// The level at a place: that of the nearest place on the centreline, so that it is the same from bank to bank. Rounded
// down to the lattice. Preconditions: two stations or more; lattice_step > 0.
inline double LevelAt(const WaterSurface& water, const Point2& p, double lattice_step) {
  const PlaceOnLine at = NearestOnLine(water.stations, p);
  const double level = std::lerp(water.stations[at.piece].z(), water.stations[at.piece + 1].z(), at.along);
  return std::floor(level / lattice_step) * lattice_step;
}

}  // namespace tilemend

#endif  // TILEMEND_COMMON_RECORDS_WATER_SURFACE_H_
