#include "client/hole_numbers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "client/rounded_place.h"
#include "common/mesh/segment_distance.h"

namespace tilemend {
namespace {

constexpr double kAtBoundary = 0.01;  // metres: places are written in millimetres

double DistanceToLines(const std::vector<std::vector<Point2>>& lines, const Point2& p) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const std::vector<Point2>& line : lines) {
    for (size_t k = 1; k < line.size(); ++k) nearest = std::min(nearest, DistanceToSegment(p, line[k - 1], line[k]));
  }
  return nearest;
}

// Metres; 0 in the range.
double DistanceInHeight(const std::optional<ReportedOutput::HeightRange>& range, double height) {
  return range ? std::max({0.0, range->lowest - height, height - range->highest}) : 0;
}

using Edge = std::pair<Point3, Point3>;

// The edges of a fill's rim, by the x of their middles.
class RimEdges {
 public:
  explicit RimEdges(std::vector<Edge> edges) : edges_(std::move(edges)) {
    std::ranges::sort(edges_, {}, [](const Edge& e) { return MiddleX(e); });
  }

  // Marks the edges that are this segment, seen from above, and within the range of heights.
  void Mark(const Point2& a, const Point2& b, const std::optional<ReportedOutput::HeightRange>& range,
            std::vector<bool>& marked) const {
    const double x = (a.x() + b.x()) / 2;
    const auto first = std::ranges::lower_bound(edges_, x - kOfRounding, {}, [](const Edge& e) { return MiddleX(e); });
    for (auto it = first; it != edges_.end() && MiddleX(*it) <= x + kOfRounding; ++it) {
      const auto& [from, to] = *it;
      const double off = std::max(DistanceInHeight(range, from.z()), DistanceInHeight(range, to.z()));
      if (off <= kAtBoundary && IsRoundedTo(a, b, from, to)) marked[static_cast<size_t>(it - edges_.begin())] = true;
    }
  }

  size_t size() const { return edges_.size(); }

 private:
  static double MiddleX(const Edge& e) { return (e.first.x() + e.second.x()) / 2; }

  std::vector<Edge> edges_;
};

}  // namespace

HoleNumbers::HoleNumbers(const ReportedOutput& reported) {
  for (size_t r = 0; r < reported.filled_rims.size(); ++r) {
    const ReportedOutput::RimOwner& owner = reported.filled_rim_owners[r];
    const std::vector<Point2>& rim = reported.filled_rims[r];
    Hole& hole = holes_[owner.cell][owner.hole];
    const auto heights = reported.filled_heights.find(owner.hole);
    if (heights != reported.filled_heights.end()) hole.heights = heights->second;
    hole.lines.push_back(rim);
    if (rim.size() > 3 && rim.front() == rim.back()) hole.around.rings.emplace_back(rim.begin(), rim.end() - 1);
  }
}

std::optional<int64_t> HoleNumbers::At(CellId cell, const Point3& p) const {
  const auto in_cell = holes_.find(ToString(cell));
  if (in_cell == holes_.end()) return std::nullopt;
  std::optional<int64_t> best;
  // Metres; of unknown height; metres in height; outside; metres from the boundary.
  std::tuple<double, bool, double, bool, double> best_key;
  for (const auto& [number, hole] : in_cell->second) {
    const bool is_outside = !Contains(hole.around, p.head<2>());
    const double from_boundary = DistanceToLines(hole.lines, p.head<2>());
    const double in_height = DistanceInHeight(hole.heights, p.z());
    const double distance = is_outside ? std::hypot(std::max(0.0, from_boundary - kAtBoundary), in_height)
                                       : std::max(0.0, in_height - from_boundary);
    const std::tuple key(distance, !hole.heights.has_value(), in_height, is_outside, from_boundary);
    if (best && key >= best_key) continue;
    best = number;
    best_key = key;
  }
  return best;
}

std::vector<HoleNumbers::RimTally> HoleNumbers::TallyRim(CellId cell,
                                                         std::vector<std::pair<Point3, Point3>> rim) const {
  const auto in_cell = holes_.find(ToString(cell));
  if (in_cell == holes_.end()) return {};
  const RimEdges edges(std::move(rim));
  std::vector<RimTally> tallies;
  for (const auto& [number, hole] : in_cell->second) {
    std::vector<bool> marked(edges.size(), false);
    int64_t segments = 0;
    for (const std::vector<Point2>& line : hole.lines) {
      segments += std::ssize(line) - 1;
      for (size_t k = 1; k < line.size(); ++k) edges.Mark(line[k - 1], line[k], hole.heights, marked);
    }
    tallies.push_back({number, std::ranges::count(marked, true), segments});
  }
  return tallies;
}

std::optional<int64_t> HoleNumbers::OfRim(CellId cell, std::vector<std::pair<Point3, Point3>> rim) const {
  std::optional<int64_t> best;
  std::pair<int64_t, int64_t> best_key = {0, 0};  // edges; less the segments of the boundary
  for (const RimTally& tally : TallyRim(cell, std::move(rim))) {
    const std::pair<int64_t, int64_t> key(tally.edges, -tally.segments);
    if (key.first == 0 || (best_key.first > 0 && key < best_key)) continue;
    best = key == best_key ? std::nullopt : std::optional(tally.hole);
    best_key = key;
  }
  return best;
}

std::vector<int64_t> HoleNumbers::AllOfRim(CellId cell, std::vector<std::pair<Point3, Point3>> rim) const {
  std::vector<int64_t> holes;
  for (const RimTally& tally : TallyRim(cell, std::move(rim))) {
    if (tally.edges > 0) holes.push_back(tally.hole);
  }
  return holes;
}

}  // namespace tilemend
