// The numbers of the holes that places in fills belong to.
#ifndef TILEMEND_CLIENT_HOLE_NUMBERS_H_
#define TILEMEND_CLIENT_HOLE_NUMBERS_H_

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "client/reported_output.h"
#include "common/mesh/plane_polygon.h"

namespace tilemend {

// Finds the filled hole around a place, by the boundaries that an output lists in holes.geojson.
class HoleNumbers {
 public:
  // O(points of the boundaries).
  explicit HoleNumbers(const ReportedOutput& reported);

  // The number of the hole of this cell whose boundary goes around p from above; among several, and if none does, the
  // one whose boundary is nearest. None if no boundary of a filled hole of the cell is known.
  // O(points of the cell's boundaries).
  std::optional<int64_t> At(CellId cell, const Point2& p) const;

 private:
  struct Hole {
    PlanePolygon around = {};                     // empty: the boundary is not closed
    std::vector<std::vector<Point2>> lines = {};  // the boundary
  };

  std::map<std::string, std::map<int64_t, Hole>> holes_;  // by the text of their cell, by number
};

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_HOLE_NUMBERS_H_
