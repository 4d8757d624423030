#include "coordinator/waves/ground_reach.h"

#include <cmath>
#include <cstdint>

#include "common/records/ground_raster.h"

namespace tilemend {
namespace {

constexpr int kMostCellsInReach = 20;  // along one axis: 1,681 rasters for each cell at most

CellId CellAt(const Grid& grid, const Point2& p) {
  const Point2 cell = ((p - grid.corner).array() / grid.cell_size.array()).floor();
  return {static_cast<int32_t>(cell.x()), static_cast<int32_t>(cell.y())};
}

}  // namespace

bool IsGroundTold(const Grid& grid) { return grid.cell_size.minCoeff() * kMostCellsInReach >= kGroundReach; }

std::vector<CellId> CellsInGroundReach(const std::map<CellId, StoredRecord>& records, const Grid& grid, CellId cell) {
  std::vector<CellId> around;
  const StoredRecord& own = records.at(cell);
  const double square = RasterSquareFor(grid.cell_size.x(), grid.cell_size.y());
  const Point2 reach = Point2::Constant(kGroundReach + 5 * square);
  const Point2 lo = own->lo.head<2>() - reach, hi = own->hi.head<2>() + reach;
  const CellId first = CellAt(grid, lo), last = CellAt(grid, hi);
  for (int32_t row = first.row - 1; row <= last.row + 1; ++row) {
    for (int32_t col = first.col - 1; col <= last.col + 1; ++col) {
      const auto other = records.find({col, row});
      if (other == records.end() || other->second == nullptr || other->second->triangle_count == 0) continue;
      if ((other->second->lo.head<2>().array() > hi.array()).any()) continue;
      if ((other->second->hi.head<2>().array() < lo.array()).any()) continue;
      around.push_back({col, row});
    }
  }
  return around;
}

}  // namespace tilemend
