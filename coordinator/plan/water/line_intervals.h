// Intervals along a line, as their ends in ascending order: from, to, from, to.
#ifndef TILEMEND_COORDINATOR_PLAN_WATER_LINE_INTERVALS_H_
#define TILEMEND_COORDINATOR_PLAN_WATER_LINE_INTERVALS_H_

#include <algorithm>
#include <utility>
#include <vector>

namespace tilemend {

// Intervals that overlap or touch are one. Cost O(n log n).
inline std::vector<double> UnionOf(std::vector<std::pair<double, double>> parts) {
  std::sort(parts.begin(), parts.end());
  std::vector<double> ends;
  for (const auto& [low, high] : parts) {
    if (!ends.empty() && low <= ends.back()) {
      ends.back() = std::max(ends.back(), high);
    } else {
      ends.insert(ends.end(), {low, high});
    }
  }
  return ends;
}

// What of `whole` is not in `taken`. Cost O(n).
inline std::vector<double> Without(const std::vector<double>& whole, const std::vector<double>& taken) {
  std::vector<double> left;
  size_t t = 0;
  for (size_t i = 0; i + 1 < whole.size(); i += 2) {
    double from = whole[i];
    while (t + 1 < taken.size() && taken[t + 1] <= from) t += 2;
    for (size_t k = t; k + 1 < taken.size() && taken[k] < whole[i + 1]; k += 2) {
      if (taken[k] > from) left.insert(left.end(), {from, taken[k]});
      from = std::max(from, taken[k + 1]);
    }
    if (from < whole[i + 1]) left.insert(left.end(), {from, whole[i + 1]});
  }
  return left;
}

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_WATER_LINE_INTERVALS_H_
