// The numbers of the holes that places in fills belong to.
#ifndef TILEMEND_CLIENT_HOLE_NUMBERS_H_
#define TILEMEND_CLIENT_HOLE_NUMBERS_H_

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "client/reported_output.h"
#include "common/mesh/plane_polygon.h"

namespace tilemend {

// Finds the filled hole at a place in space, by the boundaries that an output lists in holes.geojson and the heights of
// its report.
class HoleNumbers {
 public:
  // O(points of the boundaries).
  explicit HoleNumbers(const ReportedOutput& reported);

  // The number of the hole of this cell that is nearest to p in space. How far away a hole is goes by two distances:
  // from above, that to its boundary; 0 if it goes around p or is less than a centimetre away;
  // in height, that to the range of its rim and its water. Inside, it is 0 up to the distance from above to the
  // boundary, by which a fill may rise above its rim or sink below it. It is 0 if the heights are not known.
  // Among holes at the same distance: one whose heights are known, then the one whose range is nearest in height, then
  // one around p, then the one whose boundary is nearest from above. None if no boundary of a filled hole of the cell
  // is known. O(points of the cell's boundaries).
  std::optional<int64_t> At(CellId cell, const Point3& p) const;

  // The number of the hole of this cell whose boundary has most of these edges of a fill's rim. An edge is one of a
  // boundary if its ends are, rounded to millimetres and seen from above, and its heights are within those of the
  // hole's rim and water, if they are known. Of holes with as many edges the one whose boundary has fewer others. None
  // if no boundary has any, or two holes are equal in both. O((points of the cell's boundaries + edges) log edges).
  std::optional<int64_t> OfRim(CellId cell, std::vector<std::pair<Point3, Point3>> rim) const;

  // The numbers of all holes of this cell whose boundary has any of these edges, rising. Cost as of OfRim.
  std::vector<int64_t> AllOfRim(CellId cell, std::vector<std::pair<Point3, Point3>> rim) const;

 private:
  struct Hole {
    std::optional<ReportedOutput::HeightRange> heights = {};
    PlanePolygon around = {};                     // empty: the boundary is not closed
    std::vector<std::vector<Point2>> lines = {};  // the boundary
  };

  struct RimTally {
    int64_t hole = 0;
    int64_t edges = 0, segments = 0;  // of the fill's rim that are of the boundary; of the boundary
  };
  // Of each hole of the cell, by number.
  std::vector<RimTally> TallyRim(CellId cell, std::vector<std::pair<Point3, Point3>> rim) const;

  std::map<std::string, std::map<int64_t, Hole>> holes_;  // by the text of their cell, by number
};

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_HOLE_NUMBERS_H_
