#include "client/area_rim.h"

#include <algorithm>
#include <limits>

#include "common/mesh/segment_distance.h"

namespace tilemend {
namespace {

constexpr double kOnLine = 0.002;  // metres: coordinates of text files are rounded

// The distance from p to the square of a cell; 0 inside.
double DistanceToCell(const Grid& grid, CellId cell, const Point2& p) {
  const Point2 lo = grid.corner + grid.cell_size.cwiseProduct(Point2(cell.col, cell.row)), hi = lo + grid.cell_size;
  return (p - p.cwiseMax(lo).cwiseMin(hi)).norm();
}

template <typename Visit>
void ForEachAround(CellId cell, const Visit& visit) {
  for (int32_t row = cell.row - 1; row <= cell.row + 1; ++row) {
    for (int32_t col = cell.col - 1; col <= cell.col + 1; ++col) {
      if (CellId{col, row} != cell) visit(CellId{col, row});
    }
  }
}

}  // namespace

AreaRim::AreaRim(const Scene& scene, double reach) : grid_(scene.grid), reach_(reach) {
  for (const SceneTile& tile : scene.tiles) cells_.insert(tile.cell);
  for (const std::vector<Point2>& ring : scene.area.rings) {
    for (size_t i = 0; i < ring.size(); ++i) outline_.emplace_back(ring[i], ring[(i + 1) % ring.size()]);
  }
}

double AreaRim::DistanceFrom(CellId cell, const Point2& p) const {
  double distance = std::numeric_limits<double>::infinity();
  ForEachAround(cell, [&](CellId other) {
    if (!cells_.contains(other)) distance = std::min(distance, DistanceToCell(grid_, other, p));
  });
  for (const auto& [a, b] : outline_) distance = std::min(distance, DistanceToSegment(p, a, b));
  return distance;
}

bool AreaRim::HasEdge(CellId cell, const Point3& from, const Point3& to, OriginalEnds original) const {
  const Point2 a = from.head<2>(), b = to.head<2>();
  const double near = std::max({kOnLine, reach_ + kOnLine, (a - b).norm()});
  const auto limit = [&](bool is_original) { return is_original || reach_ > 0 ? near : kOnLine; };
  return DistanceFrom(cell, a) <= limit(original.from) && DistanceFrom(cell, b) <= limit(original.to);
}

std::vector<CellId> AreaRim::NeighboursAt(CellId cell, const Point3& p) const {
  std::vector<CellId> near;
  ForEachAround(cell, [&](CellId other) {
    if (cells_.contains(other) && DistanceToCell(grid_, other, p.head<2>()) <= reach_ + kOnLine) near.push_back(other);
  });
  return near;
}

}  // namespace tilemend
