// Where the surface of a scene ends by right.
#ifndef TILEMEND_CLIENT_AREA_RIM_H_
#define TILEMEND_CLIENT_AREA_RIM_H_

#include <set>
#include <utility>
#include <vector>

#include "common/grid/scene.h"

namespace tilemend {

// The rim of the area of a scene: sides of cells beyond which there is no cell, and the outline of its polygon.
class AreaRim {
 public:
  // `reach`: metres that tiles reach over the sides of their cells. Cost O(cells + points of the polygon).
  AreaRim(const Scene& scene, double reach);

  // Which ends of an edge are vertices of the scene.
  struct OriginalEnds {
    bool from = true, to = true;
  };

  // Whether an edge in the tile of `cell` lies on the rim. Where no triangle is cut, an edge also counts that is no
  // further from the rim than it is long: with the ends that are vertices of the scene, or where tiles overlap. Other
  // ends have to lie on the rim. O(points of the polygon).
  bool HasEdge(CellId cell, const Point3& from, const Point3& to, OriginalEnds original = {true, true}) const;

  // The cells, other than `cell`, whose squares are within `reach` of p.
  std::vector<CellId> NeighboursAt(CellId cell, const Point3& p) const;

 private:
  double DistanceFrom(CellId cell, const Point2& p) const;

  const Grid grid_;
  const double reach_;
  std::set<CellId> cells_;
  std::vector<std::pair<Point2, Point2>> outline_;
};

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_AREA_RIM_H_
