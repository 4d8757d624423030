#include "client/hole_numbers.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "common/mesh/segment_distance.h"

namespace tilemend {
namespace {

double DistanceToLines(const std::vector<std::vector<Point2>>& lines, const Point2& p) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const std::vector<Point2>& line : lines) {
    for (size_t k = 1; k < line.size(); ++k) nearest = std::min(nearest, DistanceToSegment(p, line[k - 1], line[k]));
  }
  return nearest;
}

}  // namespace

HoleNumbers::HoleNumbers(const ReportedOutput& reported) {
  for (size_t r = 0; r < reported.filled_rims.size(); ++r) {
    const ReportedOutput::RimOwner& owner = reported.filled_rim_owners[r];
    const std::vector<Point2>& rim = reported.filled_rims[r];
    Hole& hole = holes_[owner.cell][owner.hole];
    hole.lines.push_back(rim);
    if (rim.size() > 3 && rim.front() == rim.back()) hole.around.rings.emplace_back(rim.begin(), rim.end() - 1);
  }
}

std::optional<int64_t> HoleNumbers::At(CellId cell, const Point2& p) const {
  const auto in_cell = holes_.find(ToString(cell));
  if (in_cell == holes_.end()) return std::nullopt;
  std::optional<int64_t> best;
  std::pair<bool, double> best_key;  // outside, distance
  for (const auto& [number, hole] : in_cell->second) {
    const std::pair key(!Contains(hole.around, p), DistanceToLines(hole.lines, p));
    if (best && key >= best_key) continue;
    best = number;
    best_key = key;
  }
  return best;
}

}  // namespace tilemend
