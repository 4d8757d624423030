#include "coordinator/plan/water/river_profile.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "coordinator/plan/water/rim_level.h"

namespace tilemend {
namespace {

constexpr double kSure = 3;               // standard errors
constexpr double kErrorOfLevel = 1.2533;  // of normal noise, times its deviation over the root of the count
constexpr size_t kLeastStations = 2;
constexpr size_t kOddStations = 8;               // one in so many may be off a straight profile
constexpr double kDeviationsPerMedian = 1.4826;  // of the absolute value of normal noise

// Heights by station, and by side of the line.
struct Heights {
  std::vector<double> all, left, right;
};

double Cross(const Point2& u, const Point2& v) { return u.x() * v.y() - u.y() * v.x(); }

// Evenly spaced places on a line, with both its ends.
std::vector<Point3> StationsOn(const std::vector<Point2>& line, double spacing) {
  std::vector<double> along = {0};
  for (size_t i = 1; i < line.size(); ++i) along.push_back(along.back() + (line[i] - line[i - 1]).norm());
  const auto count = static_cast<size_t>(std::max(1.0, std::round(along.back() / spacing)));
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

// The heights at the shore, each as it would be at its station: `slope` metres higher for each station further on.
std::vector<Heights> SortToStations(const std::vector<Point3>& stations, std::span<const Point3> shore, double slope) {
  std::vector<Heights> heights(stations.size());
  for (const Point3& p : shore) {
    const PlaceOnLine place = NearestOnLine(stations, p.head<2>());
    const Point2 a = stations[place.piece].head<2>(), b = stations[place.piece + 1].head<2>();
    const bool is_next = place.along > 0.5;
    const double height = p.z() - slope * (place.along - (is_next ? 1 : 0));
    Heights& at = heights[place.piece + (is_next ? 1 : 0)];
    at.all.push_back(height);
    (Cross(b - a, p.head<2>() - a) > 0 ? at.left : at.right).push_back(height);
  }
  return heights;
}

RimLevel LevelOf(const std::vector<double>& heights, double noise) {
  return heights.empty() ? RimLevel{} : FitLowLevel(heights, noise);
}

RiverStation StationOf(const Heights& h, double noise, const StationRule& rule) {
  const RimLevel all = LevelOf(h.all, noise), left = LevelOf(h.left, noise), right = LevelOf(h.right, noise);
  RiverStation s;
  const auto number = [](const RimLevel& fit) { return static_cast<int64_t>(fit.count); };
  s.level = all.level, s.left = left.level, s.right = right.level;
  s.count = number(all), s.left_count = number(left), s.right_count = number(right);
  const int64_t fewer = std::min(s.left_count, s.right_count);
  if (fewer < (rule.least + 1) / 2) return s;
  const double error = kErrorOfLevel * noise / std::sqrt(static_cast<double>(fewer));
  if (std::abs(s.left - s.right) <= rule.tolerance + std::min(rule.tolerance, kSure * error)) return s;
  s.level = std::min(s.left, s.right);
  s.count = s.left < s.right ? s.left_count : s.right_count;
  return s;
}

struct Line {
  double middle = 0, level = 0, slope = 0;
  double moment = 0;  // of the places about the middle

  double At(double place) const { return level + slope * (place - middle); }
};

// How the levels fall on the whole: the weighted line through them, by stations.
Line LineThrough(const std::vector<double>& at, const std::vector<double>& levels, const std::vector<double>& weights) {
  double w = 0, x = 0, z = 0, xx = 0, xz = 0;
  for (size_t i = 0; i < at.size(); ++i) w += weights[i], x += weights[i] * at[i], z += weights[i] * levels[i];
  x /= w, z /= w;
  for (size_t i = 0; i < at.size(); ++i) {
    xx += weights[i] * (at[i] - x) * (at[i] - x);
    xz += weights[i] * (at[i] - x) * (levels[i] - z);
  }
  return {x, z, xx > 0 ? xz / xx : 0, xx};
}

void Reverse(RiverProfile& profile) {
  std::reverse(profile.water.stations.begin(), profile.water.stations.end());
  std::reverse(profile.stations.begin(), profile.stations.end());
  for (RiverStation& s : profile.stations) {
    std::swap(s.left, s.right);
    std::swap(s.left_count, s.right_count);
  }
}

// Of the line through places and values that the fewest outliers move: Theil 1950, Sen 1968, the median of all slopes.
double MedianSlope(const std::vector<double>& places, const std::vector<double>& values) {
  std::vector<double> slopes;
  for (size_t i = 0; i < places.size(); ++i) {
    for (size_t k = 0; k < i; ++k) slopes.push_back((values[i] - values[k]) / (places[i] - places[k]));
  }
  return slopes.empty() ? 0 : Quantile(std::move(slopes), 0.5);
}

std::vector<double> OffTheLine(const std::vector<double>& places, const std::vector<double>& values) {
  std::vector<double> offsets;
  const double slope = MedianSlope(places, values);
  for (size_t i = 0; i < places.size(); ++i) offsets.push_back(values[i] - slope * places[i]);
  const double middle = Quantile(offsets, 0.5);
  for (double& offset : offsets) offset -= middle;
  return offsets;
}

// How far the levels of stations lie above where the river can be: both shores have nothing but banks or quays there. 0
// for all others.
std::vector<double> HeightsOfBanks(const std::vector<double>& places, const std::vector<double>& levels,
                                   double tolerance) {
  const std::vector<double> off = OffTheLine(places, levels);
  std::vector<double> scatter, above;
  for (const double d : off) scatter.push_back(std::abs(d));
  const double least = kSure * std::max(tolerance, kDeviationsPerMedian * Quantile(scatter, 0.5));
  for (const double d : off) above.push_back(d > least ? d : 0);
  return above;
}

// The level of every station from those that have one.
void Interpolate(const std::vector<size_t>& known, const std::vector<double>& levels, std::vector<Point3>& stations) {
  for (size_t k = 0; k < stations.size(); ++k) {
    const size_t next = static_cast<size_t>(std::lower_bound(known.begin(), known.end(), k) - known.begin());
    if (next == 0) {
      stations[k].z() = levels.front();
    } else if (next == known.size()) {
      stations[k].z() = levels.back();
    } else {
      const double share =
          static_cast<double>(k - known[next - 1]) / static_cast<double>(known[next] - known[next - 1]);
      stations[k].z() = std::lerp(levels[next - 1], levels[next], share);
    }
  }
}

double ErrorOf(double noise, double count) { return kSure * kErrorOfLevel * noise / std::sqrt(count); }

// Whether the line falls by more than three standard errors: those that the noise would leave, or that the levels show.
bool SurelyFalls(const Line& line, const std::vector<double>& places, const std::vector<double>& levels,
                 const std::vector<double>& weights, double noise) {
  double sum = 0;
  for (size_t i = 0; i < places.size(); ++i) sum += weights[i] * std::pow(levels[i] - line.At(places[i]), 2);
  const double shown = places.size() > 2 ? std::sqrt(sum / static_cast<double>(places.size() - 2)) : 0;
  return -line.slope > kSure * std::max(kErrorOfLevel * noise, shown) / std::sqrt(line.moment);
}

// The levels of the straight profile through the stations, if they lie on it as far as can be told: level where it does
// not surely fall.
std::optional<std::vector<double>> StraightLevels(const std::vector<double>& places, const std::vector<double>& levels,
                                                  const std::vector<double>& weights, double noise, double tolerance) {
  Line line = LineThrough(places, levels, weights);
  if (line.slope > 0) return std::nullopt;
  if (!SurelyFalls(line, places, levels, weights, noise)) line.slope = 0;
  std::vector<double> straight;
  size_t odd = 0;
  for (size_t i = 0; i < places.size(); ++i) {
    straight.push_back(line.At(places[i]));
    odd += std::abs(levels[i] - straight[i]) > tolerance + ErrorOf(noise, weights[i]);
  }
  return odd <= places.size() / kOddStations ? std::optional(straight) : std::nullopt;
}

void MeasureAlong(RiverProfile& profile) {
  for (size_t k = 1; k < profile.stations.size(); ++k) {
    const Point3 step = profile.water.stations[k] - profile.water.stations[k - 1];
    profile.stations[k].along = profile.stations[k - 1].along + step.head<2>().norm();
  }
}

// Fills in the stations, but for what the whole line tells of them; returns those that have a level.
std::vector<size_t> MeasureStations(std::span<const Point3> shore, double slope, double noise, const StationRule& rule,
                                    RiverProfile& profile) {
  profile.stations.clear();
  std::vector<size_t> known;
  for (const Heights& h : SortToStations(profile.water.stations, shore, slope)) {
    profile.stations.push_back(StationOf(h, noise, rule));
    if (profile.stations.back().count >= (rule.least + 1) / 2) known.push_back(profile.stations.size() - 1);
  }
  return known;
}

// By how much the levels of the stations rise from one to the next, on the whole.
double RiseByStation(const std::vector<size_t>& known, const RiverProfile& profile) {
  std::vector<double> places, levels;
  for (const size_t k : known) {
    places.push_back(static_cast<double>(k));
    levels.push_back(profile.stations[k].level);
  }
  return MedianSlope(places, levels);
}

// Stations on banks are known no longer: what they rise by is removed.
void LeaveOutBanks(double tolerance, std::vector<size_t>& known, RiverProfile& profile) {
  std::vector<double> places, levels;
  for (const size_t k : known) {
    places.push_back(static_cast<double>(k));
    levels.push_back(profile.stations[k].level);
  }
  const std::vector<double> above = HeightsOfBanks(places, levels, tolerance);
  std::vector<size_t> left;
  for (size_t i = 0; i < known.size(); ++i) {
    if (above[i] > 0) {
      profile.stations[known[i]].on_banks = true;
      profile.removed.push_back({profile.water.stations[known[i]].head<2>(), above[i]});
    } else {
      left.push_back(known[i]);
    }
  }
  known = std::move(left);
}

}  // namespace

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

RiverProfile FitRiver(const std::vector<Point2>& line, std::span<const Point3> shore, double noise,
                      const StationRule& rule) {
  RiverProfile profile;
  profile.water.stations = StationsOn(line, rule.spacing);
  std::vector<size_t> known = MeasureStations(shore, 0, noise, rule, profile);
  const double slope = RiseByStation(known, profile);
  if (std::abs(slope) > noise) known = MeasureStations(shore, slope, noise, rule, profile);
  const auto collect = [&](auto&& value) {
    std::vector<double> values;
    for (const size_t k : known) values.push_back(value(k));
    return values;
  };
  const auto number = [](size_t k) { return static_cast<double>(k); };
  const auto level = [&](size_t k) { return profile.stations[k].level; };
  const auto weight = [&](size_t k) { return static_cast<double>(profile.stations[k].count); };
  if (known.size() < kLeastStations) return {};
  LeaveOutBanks(rule.tolerance, known, profile);
  if (LineThrough(collect(number), collect(level), collect(weight)).slope > 0) {
    Reverse(profile);
    for (size_t& k : known) k = profile.stations.size() - 1 - k;
    std::reverse(known.begin(), known.end());
  }
  MeasureAlong(profile);
  const std::vector<double> levels = collect(level), weights = collect(weight);
  const auto straight = StraightLevels(collect(number), levels, weights, noise, rule.tolerance);
  const std::vector<double> falling = straight ? *straight : NotRising(levels, weights);
  profile.straight = straight.has_value();
  Interpolate(known, falling, profile.water.stations);
  profile.fall = falling.front() - falling.back();
  for (size_t i = 1; i < levels.size(); ++i) {
    const double rise = levels[i] - levels[i - 1];
    if (rise > kSure * kErrorOfLevel * noise * std::sqrt(1 / weights[i] + 1 / weights[i - 1])) {
      profile.removed.push_back({profile.water.stations[known[i]].head<2>(), rise});
    }
  }
  return profile;
}

}  // namespace tilemend
