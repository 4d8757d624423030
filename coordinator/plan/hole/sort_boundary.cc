#include "coordinator/plan/hole/sort_boundary.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tilemend {
namespace {

// The side of `cell` across which `other` lies; for a diagonal neighbour the nearer of the two sides between.
int32_t SideTowards(const GridLines& lines, CellId cell, CellId other, const Point3& p) {
  int32_t best = kWest;
  double nearest = std::numeric_limits<double>::infinity();
  for (const Side side : kSides) {
    const int32_t step = AxisOf(side) == 0 ? other.col - cell.col : other.row - cell.row;
    if (step * OutwardOf(side) <= 0) continue;
    const double d = std::abs(lines.Inside(p, cell, side));
    if (d < nearest) {
      nearest = d;
      best = side;
    }
  }
  return best;
}

// The side of the cell that an edge of the area faces: that beyond is on its left.
int32_t SideBeyond(const Rim& rim, const RimEdge& e) {
  const Point3 d = rim.points[e.to].position - rim.points[e.from].position;
  if (std::abs(d.y()) >= std::abs(d.x())) return d.y() > 0 ? kWest : kEast;
  return d.x() > 0 ? kNorth : kSouth;
}

}  // namespace

void AddLoop(const PlanInput& input, const GridLines& lines, const Rim& rim, const ClosingCells& closing,
             const std::vector<int32_t>& loop, CellBoundaries& boundaries) {
  const CellId owner = rim.edges[loop[0]].owner;
  const bool inside = std::all_of(loop.begin(), loop.end(), [&](int32_t e) {
    return closing[e] == owner && rim.edges[e].owner == owner && !rim.edges[e].area_edge;
  });
  if (inside) {
    boundaries[owner].closed_loops.push_back(Reversed(rim, loop));
    return;
  }
  for (const int32_t i : loop) {
    const RimEdge& e = rim.edges[i];
    if (!input.cells.contains(closing[i])) continue;
    BoundarySegment s{{e.to, e.from, e.area_edge}, -1, e.owner, e.area_edge};
    if (e.area_edge) {
      s.side = SideBeyond(rim, e);
    } else if (e.owner != closing[i])
      s.side = SideTowards(lines, closing[i], e.owner, rim.points[e.from].position);
    boundaries[closing[i]].open.push_back(s);
  }
}

void AddSeam(const PlanInput& input, const Rim& rim, const RimIndex& index, const Seam& seam,
             CellBoundaries& boundaries) {
  const auto rim_points = static_cast<int32_t>(rim.points.size());
  const Border border(seam.a, seam.b);
  const CellId left = LeftOf(border), right = RightOf(border);
  const Side side_of_left = IsVertical(border) ? kEast : kSouth;
  for (size_t i = 0; i + 1 < seam.vertices.size(); ++i) {
    const int32_t p = seam.vertices[i], q = seam.vertices[i + 1];
    if (p < rim_points && q < rim_points && index.EdgeBetween(p, q) >= 0) continue;
    if (input.cells.contains(left)) boundaries[left].open.push_back({{p, q, true}, side_of_left, right});
    if (input.cells.contains(right)) boundaries[right].open.push_back({{q, p, true}, Opposite(side_of_left), left});
  }
}

}  // namespace tilemend
