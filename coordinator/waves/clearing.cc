#include "coordinator/waves/clearing.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "common/grid/area_shares.h"

namespace tilemend {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Tiles may reach this share of a cell beyond their cells (coordinator/report/tile_checks.h, ReachOfCell).
constexpr double kReachBeyondCell = 0.25;
// Of a polygon within the scene: what must be there as surface to tell its level. Else most of it is a hole
// (kDecidingShare), and what is there are banks.
constexpr double kMeasuredShare = 0.5;

double AreaOf(const HeightTally& tally) {
  double area = 0;
  for (const auto& [bin, part] : tally.area_of_bin) area += static_cast<double>(part) * kAreaUnit;
  return area;
}

bool HasCells(const Grid& grid) { return grid.cell_size.minCoeff() > 0; }

}  // namespace

Clearing::Clearing(const std::vector<WaterArea>& areas, const Grid& grid, std::span<const CellId> cells,
                   const PlanePolygon& bounds)
    : grid_(grid) {
  for (const std::vector<Point2>& ring : bounds.rings) {
    for (size_t i = 0; i < ring.size(); ++i) outline_.emplace_back(ring[i], ring[(i + 1) % ring.size()]);
  }
  for (size_t a = 0; a < areas.size(); ++a) {
    const WaterArea& area = areas[a];
    if (!area.clear) continue;
    Asked asked;
    asked.area = a;
    asked.label = area.label;
    asked.water = area.water;
    asked.measured = area.water && !area.level;
    asked.clear_height = area.clear_height;
    asked.polygon = area.polygon;
    if (asked.measured)
      asked.area_in_scene = HasCells(grid) ? AreaInCells(area.polygon, grid, cells) : AreaOf(area.polygon);
    if (!area.water) asked.top = kInfinity;
    if (area.water && area.level) asked.top = *area.level + area.clear_height;
    asked_.push_back(std::move(asked));
  }
  where_ = PolygonTree(asked_.size(), [&](size_t i) -> const PlanePolygon& { return asked_[i].polygon; });
}

std::vector<size_t> Clearing::InReach(CellId cell) const {
  std::vector<size_t> numbers;
  if (!HasCells(grid_)) {
    for (size_t i = 0; i < asked_.size(); ++i) numbers.push_back(i);
    return numbers;
  }
  const Eigen::AlignedBox2d box = TileBox(cell);
  const std::vector<int32_t> found = where_.Meeting(box.min(), box.max());
  return {found.begin(), found.end()};
}

Eigen::AlignedBox2d Clearing::TileBox(CellId cell) const {
  const Point2 low = grid_.corner + Point2(cell.col, cell.row).cwiseProduct(grid_.cell_size);
  const Point2 reach = kReachBeyondCell * grid_.cell_size;
  return {low - reach, low + grid_.cell_size + reach};
}

std::vector<PlaneSegment> Clearing::OutlineNear(CellId cell) const {
  const Eigen::AlignedBox2d box = TileBox(cell);
  std::vector<PlaneSegment> near;
  std::ranges::copy_if(outline_, std::back_inserter(near), [&](const PlaneSegment& segment) {
    return box.intersects(
        Eigen::AlignedBox2d(segment.first.cwiseMin(segment.second), segment.first.cwiseMax(segment.second)));
  });
  return near;
}

std::vector<size_t> Clearing::Measured(CellId cell) const {
  std::vector<size_t> numbers = InReach(cell);
  std::erase_if(numbers, [&](size_t i) { return !asked_[i].measured; });
  return numbers;
}

std::vector<size_t> Clearing::Cutting(CellId cell) const {
  const auto counted = counted_.find(cell);
  if (counted != counted_.end() && !counted->second) return {};
  std::vector<size_t> numbers = InReach(cell);
  std::erase_if(numbers, [&](size_t i) { return !asked_[i].top; });
  return numbers;
}

std::vector<PlanePolygon> Clearing::Polygons(CellId cell) const {
  std::vector<PlanePolygon> polygons;
  for (const size_t i : Measured(cell)) polygons.push_back(asked_[i].polygon);
  return polygons;
}

absl::Status Clearing::TakeTallies(CellId cell, std::span<const HeightTally> tallies) {
  const std::vector<size_t> numbers = Measured(cell);
  if (numbers.size() != tallies.size()) return absl::InvalidArgumentError("heights of other polygons");
  for (size_t k = 0; k < numbers.size(); ++k) asked_[numbers[k]].heights.Add(tallies[k]);
  return absl::OkStatus();
}

void Clearing::Settle(std::vector<WaterArea>& areas) {
  for (Asked& asked : asked_) {
    if (!asked.measured) continue;
    const bool is_measured = AreaOf(asked.heights) > kMeasuredShare * asked.area_in_scene;
    areas[asked.area].is_mostly_open = !is_measured;
    // Banks rise from the water. What its level is, is for the shore of the hole to say.
    const std::optional<double> level = HalfSampleMode(is_measured ? asked.heights : LowerHalf(asked.heights));
    if (level && is_measured) {
      areas[asked.area].level = *level;
      areas[asked.area].level_sigma = SpreadAbout(asked.heights, *level, *level + asked.clear_height);
    }
    asked.heights = {};
    if (!level) continue;
    asked.top = *level + asked.clear_height;
  }
}

std::vector<ClearArea> Clearing::Areas(CellId cell) const {
  std::vector<ClearArea> areas;
  const std::vector<size_t> cutting = Cutting(cell);
  const std::vector<PlaneSegment> outline =
      cutting.empty() || !HasCells(grid_) ? std::vector<PlaneSegment>() : OutlineNear(cell);
  for (const size_t i : cutting) areas.push_back({asked_[i].polygon, *asked_[i].top, outline});
  return areas;
}

absl::Status Clearing::TakeCounts(CellId cell, std::span<const int64_t> counts) {
  const std::vector<size_t> numbers = Cutting(cell);
  const bool negative = std::any_of(counts.begin(), counts.end(), [](int64_t n) { return n < 0; });
  if (numbers.size() != counts.size() || negative) return absl::InvalidArgumentError("counts of other areas");
  bool any = false;
  for (size_t k = 0; k < numbers.size(); ++k) {
    if (counts[k] > 0) asked_[numbers[k]].triangles_of[cell] = counts[k];
    any = any || counts[k] > 0;
  }
  counted_[cell] = any;
  return absl::OkStatus();
}

void Clearing::TellCells(std::vector<WaterArea>& areas) const {
  for (const Asked& asked : asked_) {
    for (const auto& [cell, triangles] : asked.triangles_of) areas[asked.area].cleared_cells.push_back(cell);
  }
}

std::vector<ClearedArea> Clearing::Cleared() const {
  std::vector<ClearedArea> cleared;
  for (const Asked& asked : asked_) {
    const bool limited = asked.top && std::isfinite(*asked.top);
    cleared.push_back({asked.label, asked.water, limited ? asked.top : std::nullopt, asked.triangles_of});
  }
  return cleared;
}

}  // namespace tilemend
