#include "common/mesh/height_tally.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "common/mesh/height_tallies.h"

namespace tilemend {
namespace {

constexpr double kOfNormal = 1.4826;  // standard deviation over median distance
constexpr double kLastSpan = 0.03;    // metres: three heights of 1 cm, as printed

using Bin = std::pair<int32_t, int64_t>;

int64_t SpanOf(std::span<const Bin> bins) { return int64_t{bins.back().first} - bins.front().first; }

int64_t AreaOf(std::span<const Bin> bins) {
  int64_t area = 0;
  for (const Bin& bin : bins) area += bin.second;
  return area;
}

// The run of bins that spans the fewest heights among those with at least half of the area; of equal spans the one with
// the most area, then the lowest.
std::span<const Bin> ShortestHalf(std::span<const Bin> bins) {
  const int64_t half = (AreaOf(bins) + 1) / 2;
  std::span<const Bin> best = bins;
  int64_t area = 0, best_area = 0;
  for (size_t from = 0, to = 0; from < bins.size(); area -= bins[from++].second) {
    while (to < bins.size() && area < half) area += bins[to++].second;
    if (area < half) break;
    const std::span<const Bin> run = bins.subspan(from, to - from);
    if (SpanOf(run) > SpanOf(best) || (SpanOf(run) == SpanOf(best) && area <= best_area)) continue;
    best = run;
    best_area = area;
  }
  return best;
}

}  // namespace

int32_t HeightBinOf(double height) {
  constexpr double kLast = std::numeric_limits<int32_t>::max();
  return static_cast<int32_t>(std::clamp(std::round(height / kHeightBin), -kLast, kLast));
}

void HeightTally::Add(const HeightTally& other) {
  for (const auto& [bin, area] : other.area_of_bin) area_of_bin[bin] += area;
}

HeightTally TallyHeights(const MeshView& mesh, const PlanePolygon& polygon) {
  return TallyHeightsIn(mesh, {&polygon, 1}).front();
}

std::optional<double> HalfSampleMode(const HeightTally& tally) {
  if (tally.area_of_bin.empty()) return std::nullopt;
  const std::vector<Bin> all(tally.area_of_bin.begin(), tally.area_of_bin.end());
  std::span<const Bin> bins = all;
  while (static_cast<double>(SpanOf(bins)) * kHeightBin > kLastSpan) {
    const std::span<const Bin> half = ShortestHalf(bins);
    if (half.size() == bins.size()) break;
    bins = half;
  }
  double sum = 0;
  for (const auto& [bin, area] : bins) sum += bin * static_cast<double>(area);
  return sum / static_cast<double>(AreaOf(bins)) * kHeightBin;
}

HeightTally LowerHalf(const HeightTally& tally) {
  int64_t left = 0;
  for (const auto& [bin, area] : tally.area_of_bin) left += area;
  left = (left + 1) / 2;
  HeightTally half;
  for (const auto& [bin, area] : tally.area_of_bin) {
    if (left <= 0) break;
    half.area_of_bin[bin] = std::min(area, left);
    left -= area;
  }
  return half;
}

double SpreadAbout(const HeightTally& tally, double level, double top) {
  std::map<int64_t, int64_t> area_within;  // by distance in bins
  int64_t all = 0;
  const int64_t middle = HeightBinOf(level);
  for (const auto& [bin, area] : tally.area_of_bin) {
    if (bin * kHeightBin > top) break;
    area_within[std::abs(bin - middle)] += area;
    all += area;
  }
  if (area_within.empty()) return 0;
  int64_t area = 0;
  auto it = area_within.begin();
  while ((area += it->second) * 2 < all) ++it;
  return kOfNormal * static_cast<double>(it->first) * kHeightBin;
}

}  // namespace tilemend
