// Water that is off its level where two tiles meet.
#ifndef TILEMEND_CLIENT_WATER_SEAMS_H_
#define TILEMEND_CLIENT_WATER_SEAMS_H_

#include <array>
#include <map>
#include <string>
#include <vector>

#include "client/original_rims.h"
#include "common/grid/scene.h"

namespace tilemend {

// A vertex on the boundary of filled water belongs to the shore if it is one of the scene, in any tile. Else it lies
// on a seam, and is water in both tiles.
class WaterSeams {
 public:
  // Takes WaterFinding::off_at_seam of a fill in the tile of `cell`.
  void Add(CellId cell, const std::vector<Point3>& off);

  struct Place {
    CellId cell;
    Point3 at;
  };
  // The vertices that are off the level in two tiles and that the scene does not have. Only those are given whose tiles
  // all have rows less than `row`; these are forgotten.
  std::vector<Place> ReleaseBelow(int32_t row, const OriginalRims& originals);

 private:
  struct Found {
    CellId first, last;
  };
  std::map<std::array<double, 3>, Found> found_;  // by position
};

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_WATER_SEAMS_H_
