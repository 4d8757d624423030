#include "coordinator/plan/water/rim_level.h"

#include <algorithm>
#include <cmath>
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
  RimLevel fit;
  fit.level = MiddleOfDensest(heights);
  for (int step = 0; step < kMostSteps; ++step) {
    fit.spread = SpreadBelow(heights, fit.level);
    const double reach = kWindow * fit.spread + kLeastWindow;
    const double level = MeanWithin(heights, fit.level - reach, fit.level + reach, fit.level);
    const bool settled = std::abs(level - fit.level) < kSettled;
    fit.level = level;
    if (settled) break;
  }
  // Half a deviation more than the lowest of n is expected at.
  const double lowest_noise = std::sqrt(2 * std::log(static_cast<double>(heights.size()))) + 0.5;
  const auto lowest =
      std::lower_bound(heights.begin(), heights.end(), fit.level - kOutlier * fit.spread - kLeastWindow);
  const double scatter = std::clamp(fit.spread, noise, kMostScatter * noise);
  if (lowest != heights.end()) fit.level = std::min(fit.level, *lowest + lowest_noise * scatter);
  return fit;
}

}  // namespace tilemend
