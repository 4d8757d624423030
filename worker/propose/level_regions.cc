#include "worker/propose/level_regions.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include "worker/propose/height_tree.h"
#include "worker/propose/square_outline.h"
#include "worker/propose/square_set.h"

namespace tilemend {
namespace {

constexpr double kSigmaOfMedian = 1.4826;  // of a normal distribution: sigma over the median distance

// Precondition: not empty.
double MedianOf(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// The half-sample mode (Bickel and Fruehwirth 2006). Precondition: not empty.
double ModeOf(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  auto first = values.begin(), end = values.end();
  while (end - first > 3) {
    const ptrdiff_t half = (end - first + 1) / 2;
    auto best = first;
    for (auto it = first; it + half <= end; ++it) {
      if (*(it + half - 1) - *it < *(best + half - 1) - *best) best = it;
    }
    first = best;
    end = best + half;
  }
  double sum = 0;
  for (auto it = first; it != end; ++it) sum += *it;
  return sum / static_cast<double>(end - first);
}

class Finder {
 public:
  Finder(const GroundRaster& heights, const std::vector<bool>& is_ground, const LevelRegionOptions& options)
      : heights_(heights), is_ground_(is_ground), options_(options), step_(options.bank / kDeepSteps) {
    stepped_ = {heights.cols, heights.rows, {}};
    for (int32_t row = 0; row < heights.rows; ++row) {
      for (int32_t col = 0; col < heights.cols; ++col) {
        stepped_.steps.push_back(StepAt(heights.col + col, heights.row + row));
      }
    }
  }

  std::vector<LowRegion> Find() {
    nodes_ = HeightTreeOf(stepped_);
    std::vector<LowRegion> found;
    std::vector<bool> taken(nodes_.size(), false), above(nodes_.size(), false);
    for (const int32_t node : Candidates()) {
      bool apart = !above[node];
      for (int32_t n = node; n >= 0 && apart; n = nodes_[n].parent) apart = !taken[n];
      if (!apart) continue;
      std::optional<LowRegion> region = RegionOf(node);
      if (!region) continue;
      taken[node] = true;
      for (int32_t n = node; n >= 0; n = nodes_[n].parent) above[n] = true;
      found.push_back(*std::move(region));
    }
    std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.area > b.area; });
    return found;
  }

 private:
  double SquareArea() const { return heights_.square * heights_.square; }
  // Here and below: on the lattice.
  bool IsGround(int32_t col, int32_t row) const {
    return heights_.Contains(col, row) && is_ground_[heights_.IndexOf(col, row)];
  }

  // Of the median of the ground around.
  int32_t StepAt(int32_t col, int32_t row) const {
    if (!IsGround(col, row)) return SteppedHeights::kWall;
    std::vector<double> around;
    for (int32_t r = row - options_.smoothing; r <= row + options_.smoothing; ++r) {
      for (int32_t c = col - options_.smoothing; c <= col + options_.smoothing; ++c) {
        if (IsGround(c, r)) around.push_back(heights_.heights[heights_.IndexOf(c, r)]);
      }
    }
    return static_cast<int32_t>(std::ceil(MedianOf(std::move(around)) / step_));
  }

  // What the region of a node has grown to a bank higher. Between walls it may have nothing left to grow into.
  int64_t AreaABankHigher(int32_t node) const {
    const int32_t level = nodes_[node].level + kDeepSteps;
    int32_t n = node;
    while (nodes_[n].parent >= 0 && nodes_[nodes_[n].parent].level <= level) n = nodes_[n].parent;
    return nodes_[n].area;
  }

  // Nodes whose region is level and steep at its rim, the clearest first.
  std::vector<int32_t> Candidates() const {
    std::vector<std::pair<double, int32_t>> scored;
    for (int32_t i = 0; i < static_cast<int32_t>(nodes_.size()); ++i) {
      const auto area = static_cast<double>(nodes_[i].area);
      if (area * SquareArea() < options_.min_area) continue;
      const double growth = static_cast<double>(AreaABankHigher(i)) / area;
      const double depth_share = static_cast<double>(nodes_[i].deep) / area;
      if (growth <= options_.growth && depth_share <= options_.depth_share)
        scored.emplace_back(growth + depth_share, i);
    }
    std::sort(scored.begin(), scored.end());
    std::vector<int32_t> candidates;
    for (const auto& [score, node] : scored) candidates.push_back(node);
    return candidates;
  }

  // Those at or below a level that are together with one, on the lattice.
  std::vector<Square> SquaresAt(int32_t square, int32_t level) const {
    std::vector<Square> squares;
    for (const int32_t s : SquaresBelow(stepped_, square, level)) {
      squares.push_back({heights_.col + s % heights_.cols, heights_.row + s / heights_.cols});
    }
    return squares;
  }

  // None if too little of its rim has higher ground behind it.
  std::optional<LowRegion> RegionOf(int32_t node) const {
    const std::vector<Square> squares = SquaresAt(nodes_[node].square, nodes_[node].level);
    LowRegion region;
    std::vector<double> heights, distances;
    for (const Square& s : squares) heights.push_back(heights_.heights[heights_.IndexOf(s.col, s.row)]);
    region.level = ModeOf(heights);
    for (const double height : heights) distances.push_back(std::abs(height - region.level));
    region.sigma = kSigmaOfMedian * MedianOf(std::move(distances));
    region.shore_share =
        ShoreShare(WithSmallIslands(SetOf(squares), std::numeric_limits<int64_t>::max()), region.level);
    if (region.shore_share < options_.shore_share) return std::nullopt;
    // Up to the foot of the bank.
    const auto foot = static_cast<int32_t>(std::floor((region.level + options_.bank) / step_));
    const SquareSet water = WithSmallIslands(SetOf(SquaresAt(nodes_[node].square, std::max(foot, nodes_[node].level))),
                                             static_cast<int64_t>(options_.min_area / SquareArea()));
    region.area = SquareArea() * static_cast<double>(CountOf(water));
    region.outline = OutlineOf(water, heights_.square);
    return region;
  }

  // Of the rim of `region`, behind which ground lies a bank higher than the level. Where no surface is nothing is
  // known.
  double ShoreShare(const SquareSet& region, double level) const {
    int64_t rim = 0, higher = 0;
    for (const Square& s : RimOf(region)) {
      if (!heights_.Contains(s.col, s.row) || std::isnan(heights_.heights[heights_.IndexOf(s.col, s.row)])) continue;
      ++rim;
      const std::optional<double> ground = NearestGround(region, s);
      if (ground && *ground >= level + options_.bank) ++higher;
    }
    return rim > 0 ? static_cast<double>(higher) / static_cast<double>(rim) : 0;
  }

  // The height of the ground nearest to a square that is not of the region; of ground that is equally near, the first.
  std::optional<double> NearestGround(const SquareSet& region, const Square& from) const {
    const auto reach = static_cast<int32_t>(options_.shore_reach / heights_.square);
    std::optional<double> nearest;
    int32_t least = reach * reach + 1;
    for (int32_t r = from.row - reach; r <= from.row + reach; ++r) {
      for (int32_t c = from.col - reach; c <= from.col + reach; ++c) {
        const int32_t distance = (c - from.col) * (c - from.col) + (r - from.row) * (r - from.row);
        if (distance >= least || !IsGround(c, r) || region.Has(c, r)) continue;
        least = distance;
        nearest = heights_.heights[heights_.IndexOf(c, r)];
      }
    }
    return nearest;
  }

  const GroundRaster& heights_;
  const std::vector<bool>& is_ground_;
  const LevelRegionOptions options_;
  const double step_;
  SteppedHeights stepped_;
  std::vector<HeightNode> nodes_;
};

}  // namespace

std::vector<LowRegion> FindLevelRegions(const GroundRaster& heights, const std::vector<bool>& is_ground,
                                        const LevelRegionOptions& options) {
  if (heights.empty()) return {};
  return Finder(heights, is_ground, options).Find();
}

}  // namespace tilemend
