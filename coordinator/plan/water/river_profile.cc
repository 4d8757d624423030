#include "coordinator/plan/water/river_profile.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tilemend {
namespace {

constexpr double kSpacing = 25;           // metres between stations
constexpr int64_t kMinEdges = 8;          // at a station with a level of its own
constexpr double kErrorOfLevel = 1.2533;  // of a median, times the deviation over the root of the count
constexpr double kMinDeviation = 0.01;    // metres: heights are told no better

struct StationLevel {
  size_t station = 0;
  double level = 0;  // metres
  double edges = 0;
};

std::vector<Point3> StationsOn(const std::vector<Point2>& line) {
  std::vector<double> along = {0};
  for (size_t i = 1; i < line.size(); ++i) along.push_back(along.back() + (line[i] - line[i - 1]).norm());
  const auto count = static_cast<size_t>(std::max(1.0, std::round(along.back() / kSpacing)));
  std::vector<Point3> stations;
  for (size_t k = 0, piece = 0; k <= count; ++k) {
    const double at = along.back() * static_cast<double>(k) / static_cast<double>(count);
    while (piece + 2 < line.size() && along[piece + 1] < at) ++piece;
    const double length = along[piece + 1] - along[piece];
    const double share = length > 0 ? std::clamp((at - along[piece]) / length, 0.0, 1.0) : 0;
    const Point2 p = line[piece] + share * (line[piece + 1] - line[piece]);
    stations.emplace_back(p.x(), p.y(), 0);
  }
  return stations;
}

// An edge's height and where along the stations it is (0: at the first).
struct EdgeAlong {
  WeightedHeight height;
  double along = 0;
};

std::vector<EdgeAlong> EdgesAlong(const std::vector<Point3>& stations, std::span<const RimChain> rim) {
  std::vector<EdgeAlong> edges;
  for (const RimChain& chain : rim) {
    for (const ChainEdge& e : chain) {
      const PlaceOnLine place = NearestOnLine(stations, e.middle.head<2>());
      const WeightedHeight height{e.middle.z(), e.length, e.length};
      edges.push_back({height, static_cast<double>(place.piece) + place.along});
    }
  }
  return edges;
}

// The levels of the stations that have enough edges, each moved to its station along the slope.
std::vector<StationLevel> LevelsAt(size_t stations, const std::vector<EdgeAlong>& edges, double slope) {
  std::vector<std::vector<WeightedHeight>> heights(stations);
  for (const EdgeAlong& e : edges) {
    const double station = std::round(e.along);
    WeightedHeight moved = e.height;
    moved.height -= slope * (e.along - station);
    heights[static_cast<size_t>(station)].push_back(moved);
  }
  std::vector<StationLevel> levels;
  for (size_t k = 0; k < stations; ++k) {
    if (std::ssize(heights[k]) < kMinEdges) continue;
    std::ranges::sort(heights[k]);
    levels.push_back({k, LowerMode(heights[k]), static_cast<double>(heights[k].size())});
  }
  return levels;
}

double MedianOf(std::vector<double> values) {
  const auto middle = values.begin() + std::ssize(values) / 2;
  std::ranges::nth_element(values, middle);
  return *middle;
}

// Theil 1950, Sen 1968: the median of the slopes of all pairs. Precondition: at least two.
double MedianSlope(const std::vector<StationLevel>& levels) {
  std::vector<double> slopes;
  for (size_t i = 0; i < levels.size(); ++i) {
    for (size_t k = 0; k < i; ++k) {
      const auto apart = static_cast<double>(levels[i].station - levels[k].station);
      slopes.push_back((levels[i].level - levels[k].level) / apart);
    }
  }
  return MedianOf(std::move(slopes));
}

void EraseBanks(double slope, std::vector<StationLevel>& levels) {
  const auto at = [&](const StationLevel& s) { return s.level - slope * static_cast<double>(s.station); };
  std::vector<double> heights, offs;
  for (const StationLevel& s : levels) heights.push_back(at(s));
  const double middle = MedianOf(heights);
  for (const double h : heights) offs.push_back(std::abs(h - middle));
  const double limit = kSigmas * std::max(kMinDeviation, kDeviationsPerMedian * MedianOf(std::move(offs)));
  std::erase_if(levels, [&](const StationLevel& s) { return at(s) > middle + limit; });
}

// Whether any edge is nearest to each station.
std::vector<bool> StationsAtRim(size_t stations, const std::vector<EdgeAlong>& edges) {
  std::vector<bool> at_rim(stations, false);
  for (const EdgeAlong& e : edges) at_rim[static_cast<size_t>(std::round(e.along))] = true;
  return at_rim;
}

// The level of every station from those that have one. Beyond the first and last it follows the slope, and stays where
// the line leaves the rim.
void Interpolate(const std::vector<StationLevel>& known, const std::vector<double>& levels,
                 const std::vector<bool>& at_rim, double slope, std::vector<Point3>& stations) {
  for (size_t i = 0; i < known.size(); ++i) {
    const size_t from = known[i].station;
    const size_t to = i + 1 < known.size() ? known[i + 1].station : from + 1;
    for (size_t k = from; k < to; ++k) {
      const double share = static_cast<double>(k - from) / static_cast<double>(to - from);
      stations[k].z() = i + 1 < known.size() ? std::lerp(levels[i], levels[i + 1], share) : levels[i];
    }
  }
  for (size_t k = known.front().station; k-- > 0;) stations[k].z() = stations[k + 1].z() - (at_rim[k] ? slope : 0);
  for (size_t k = known.back().station + 1; k < stations.size(); ++k) {
    stations[k].z() = stations[k - 1].z() + (at_rim[k] ? slope : 0);
  }
}

// Rises that are more than three standard errors of the two levels. Precondition: the levels run downstream.
std::vector<RemovedRise> RisesOf(const std::vector<StationLevel>& levels, const std::vector<Point3>& stations,
                                 double noise) {
  std::vector<RemovedRise> rises;
  for (size_t i = 1; i < levels.size(); ++i) {
    const double error = kErrorOfLevel * noise * std::sqrt(1 / levels[i].edges + 1 / levels[i - 1].edges);
    const double rise = levels[i].level - levels[i - 1].level;
    if (rise <= kSigmas * std::max(error, kMinDeviation)) continue;
    rises.push_back({stations[levels[i].station].head<2>(), rise});
  }
  return rises;
}

}  // namespace

FallLine FitFall(const std::vector<Point2>& line, std::span<const RimChain> rim) {
  const std::vector<Point3> stations = StationsOn(line);
  const std::vector<EdgeAlong> edges = EdgesAlong(stations, rim);
  FallLine fall;
  for (int fit = 0; fit < 2; ++fit) {
    const std::vector<StationLevel> levels = LevelsAt(stations.size(), edges, fall.slope);
    if (levels.size() < 2) return {};
    fall.slope = MedianSlope(levels);
    fall.with_level = levels.size();
  }
  fall.stations = stations;
  return fall;
}

std::vector<double> NotRising(std::span<const double> values, std::span<const double> weights) {
  struct Block {
    double mean, weight;
    size_t count;
  };
  std::vector<Block> blocks;
  for (size_t i = 0; i < values.size(); ++i) {
    blocks.push_back({values[i], weights[i], 1});
    while (blocks.size() > 1 && blocks[blocks.size() - 2].mean < blocks.back().mean) {
      const Block last = blocks.back();
      blocks.pop_back();
      Block& before = blocks.back();
      before.mean = (before.mean * before.weight + last.mean * last.weight) / (before.weight + last.weight);
      before.weight += last.weight;
      before.count += last.count;
    }
  }
  std::vector<double> result;
  for (const Block& b : blocks) result.insert(result.end(), b.count, b.mean);
  return result;
}

RiverProfile FitRiver(const std::vector<Point2>& line, std::span<const RimChain> rim) {
  const FallLine fall = FitFall(line, rim);
  RiverProfile profile;
  if (fall.stations.empty()) return profile;
  profile.water.stations = fall.stations;
  const std::vector<EdgeAlong> edges = EdgesAlong(profile.water.stations, rim);
  std::vector<StationLevel> known = LevelsAt(fall.stations.size(), edges, fall.slope);
  std::vector<bool> at_rim = StationsAtRim(fall.stations.size(), edges);
  if (fall.slope > 0) {
    std::ranges::reverse(profile.water.stations);
    std::reverse(at_rim.begin(), at_rim.end());
    std::ranges::reverse(known);
    for (StationLevel& s : known) s.station = fall.stations.size() - 1 - s.station;
  }
  profile.removed = RisesOf(known, profile.water.stations, EvidenceOf(rim, {}).noise);
  EraseBanks(-std::abs(fall.slope), known);
  std::vector<double> levels, weights;
  for (const StationLevel& s : known) levels.push_back(s.level), weights.push_back(s.edges);
  Interpolate(known, NotRising(levels, weights), at_rim, -std::abs(fall.slope), profile.water.stations);
  return profile;
}

}  // namespace tilemend
