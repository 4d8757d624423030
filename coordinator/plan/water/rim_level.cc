#include "coordinator/plan/water/rim_level.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace tilemend {
namespace {

constexpr double kDeviationsPerMedian = 1.4826;  // of the absolute value of normal noise
constexpr double kWindow = 1.75;                 // spreads about the level
constexpr double kOutlier = 5;                   // spreads below the level
constexpr double kLeastWindow = 1e-4;            // metres: a rim of equal heights has no spread
constexpr double kMostScatter = 2;               // of noise between neighbours: how much noise may be over a whole rim
constexpr double kSettled = 1e-5;                // metres
constexpr int kMostSteps = 50;
constexpr ptrdiff_t kLeastLow = 4;  // heights that a level can be taken from

// The middle of the shortest interval that holds a third of the sorted heights.
double MiddleOfDensest(const std::vector<double>& sorted) {
  const size_t count = (sorted.size() + 2) / 3;
  size_t best = 0;
  for (size_t i = 0; i + count <= sorted.size(); ++i) {
    if (sorted[i + count - 1] - sorted[i] < sorted[best + count - 1] - sorted[best]) best = i;
  }
  return (sorted[best] + sorted[best + count - 1]) / 2;
}

double SpreadBelow(const std::vector<double>& sorted, double level) {
  const std::vector<double> below(sorted.begin(), std::upper_bound(sorted.begin(), sorted.end(), level));
  return below.empty() ? 0 : kDeviationsPerMedian * (level - Quantile(below, 0.5));
}

double MeanWithin(const std::vector<double>& sorted, double lo, double hi, double otherwise) {
  const auto first = std::lower_bound(sorted.begin(), sorted.end(), lo);
  const auto last = std::upper_bound(first, sorted.end(), hi);
  if (first == last) return otherwise;
  return std::accumulate(first, last, 0.0) / static_cast<double>(last - first);
}

RimLevel FitDensest(const std::vector<double>& sorted) {
  RimLevel fit{MiddleOfDensest(sorted), 0, sorted.size()};
  for (int step = 0; step < kMostSteps; ++step) {
    fit.spread = SpreadBelow(sorted, fit.level);
    const double reach = kWindow * fit.spread + kLeastWindow;
    const double level = MeanWithin(sorted, fit.level - reach, fit.level + reach, fit.level);
    const bool settled = std::abs(level - fit.level) < kSettled;
    fit.level = level;
    if (settled) break;
  }
  return fit;
}

// How high the level can be: the lowest height that is no outlier is noise about it. Half a deviation more than the
// lowest of so many is expected at.
double HighestLevel(const std::vector<double>& sorted, double spread, double level, double noise) {
  const double lowest_noise = std::sqrt(2 * std::log(static_cast<double>(sorted.size()))) + 0.5;
  const auto lowest = std::lower_bound(sorted.begin(), sorted.end(), level - kOutlier * spread - kLeastWindow);
  const double scatter = std::clamp(spread, noise, kMostScatter * noise);
  return lowest == sorted.end() ? level : *lowest + lowest_noise * scatter;
}

}  // namespace

double Quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  const double at = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<size_t>(at);
  const size_t above = std::min(below + 1, values.size() - 1);
  return std::lerp(values[below], values[above], at - static_cast<double>(below));
}

RimLevel FitRimLevel(std::vector<double> heights, double noise) {
  std::sort(heights.begin(), heights.end());
  RimLevel fit = FitDensest(heights);
  fit.level = std::min(fit.level, HighestLevel(heights, fit.spread, fit.level, noise));
  return fit;
}

RimLevel FitLowLevel(std::vector<double> heights, double noise) {
  std::sort(heights.begin(), heights.end());
  for (;;) {
    RimLevel fit = FitDensest(heights);
    const double highest = HighestLevel(heights, fit.spread, fit.level, noise);
    const bool on_quays = fit.level > highest + kLeastQuay;
    fit.level = std::min(fit.level, highest);
    const auto above = std::upper_bound(heights.begin(), heights.end(), highest + kWindow * noise);
    if (!on_quays || above == heights.end() || above - heights.begin() < kLeastLow) return fit;
    heights.erase(above, heights.end());
  }
}

}  // namespace tilemend
