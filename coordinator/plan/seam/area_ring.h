// The rings of an area's polygon, and the new vertices along them.
#ifndef TILEMEND_COORDINATOR_PLAN_SEAM_AREA_RING_H_
#define TILEMEND_COORDINATOR_PLAN_SEAM_AREA_RING_H_

#include <set>
#include <utility>
#include <vector>

#include "common/mesh/plane_polygon.h"
#include "coordinator/plan/seam/seam_site.h"

namespace tilemend {

// The rings of an area, each with the inside on its right, as a rim has a hole. Where an area ends at the rim of a hole
// that it has inside, its corners are moved out of it, on to the surface beyond: there the hole is whole. Rings that
// cross after that are united. Precondition: they do not cross. Cost for each corner as SeamSizeAt; near the rim,
// RimIndex::InSurface 17 times.
std::vector<std::vector<Point2>> OrientedRings(const PlanePolygon& area, const SeamSite& site);

// The outline of what oriented rings enclose, oriented likewise (SimpleRings).
std::vector<std::vector<Point2>> UnitedRings(std::vector<std::vector<Point2>> rings);

struct RingVertex {
  Point2 position;
  double size = 0;  // the wanted edge length there
};

// Spaces new vertices along rings. The site must outlive it.
class RingSpacer {
 public:
  explicit RingSpacer(const SeamSite& site);

  // The vertices strictly between the ends of a line: at its corners, where it crosses grid lines, and between. Those
  // between are as far apart as the triangles there will be large. They are on the lattice. None but those on grid
  // lines is nearer than a fraction of that distance to the one before or to the rim, nor a corner that the line cannot
  // do without. Cost as SeamSizeAt for each.
  std::vector<RingVertex> Along(const std::vector<Point2>& line) const;

  // The same around a ring. Of one that is smaller than these distances its corners.
  std::vector<RingVertex> Around(const std::vector<Point2>& ring) const;

 private:
  std::vector<Point2> AtGridLines(const Point2& a, const Point2& b) const;
  bool OnGridLine(const Point2& p) const;
  Point2 OnLattice(const Point2& p) const;

  const SeamSite& site_;
  std::set<std::pair<int, double>> grid_lines_;  // axis and coordinate
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_SEAM_AREA_RING_H_
