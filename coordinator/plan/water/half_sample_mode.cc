#include "coordinator/plan/water/half_sample_mode.h"

#include <algorithm>
#include <cstddef>
#include <tuple>

namespace tilemend {
namespace {

constexpr size_t kFewest = 3;  // edges: the mode is their mean (Bickel and Fruehwirth 2006, section 2)

double WeightOf(std::span<const WeightedHeight> edges) {
  double weight = 0;
  for (const WeightedHeight& e : edges) weight += e.weight;
  return weight;
}

// The shortest interval that holds half of the weight.
std::span<const WeightedHeight> DensestHalf(std::span<const WeightedHeight> sorted) {
  const double half = WeightOf(sorted) / 2;
  size_t first = 0, last = 0;  // [first, last) holds `inside`
  double inside = 0;
  std::tuple<double, double, size_t, size_t> best(sorted.back().height - sorted.front().height, -2 * half, 0,
                                                  sorted.size());
  for (; first < sorted.size(); ++first) {
    while (last < sorted.size() && inside < half) inside += sorted[last++].weight;
    if (inside < half) break;
    if (last > first) {
      best = std::min(best, std::tuple(sorted[last - 1].height - sorted[first].height, -inside, first, last));
    }
    inside -= sorted[first].weight;
  }
  const auto [extent, weight, begin, end] = best;
  return sorted.subspan(begin, end - begin);
}

}  // namespace

double WeightedQuantile(std::span<const WeightedHeight> sorted, double share) {
  double wanted = 0, length = 0;
  for (const WeightedHeight& e : sorted) wanted += share * e.length;
  for (const WeightedHeight& e : sorted) {
    length += e.length;
    if (length >= wanted) return e.height;
  }
  return sorted.back().height;
}

double HalfSampleMode(std::span<const WeightedHeight> sorted) {
  while (sorted.size() > kFewest) {
    const std::span<const WeightedHeight> half = DensestHalf(sorted);
    if (half.size() == sorted.size()) break;
    sorted = half;
  }
  const double weight = WeightOf(sorted);
  if (weight <= 0) return sorted[sorted.size() / 2].height;
  double sum = 0;  // about the lowest, so that equal heights keep their value
  for (const WeightedHeight& e : sorted) sum += e.weight * (e.height - sorted.front().height);
  return sorted.front().height + sum / weight;
}

double LowerMode(std::span<const WeightedHeight> sorted) {
  const double median = WeightedQuantile(sorted, 0.5);
  const auto above = std::ranges::upper_bound(sorted, median, {}, &WeightedHeight::height);
  return HalfSampleMode(sorted.first(static_cast<size_t>(above - sorted.begin())));
}

}  // namespace tilemend
