#ifndef TILEMEND_COMMON_MESH_WEIGHTED_MEDIAN_H_
#define TILEMEND_COMMON_MESH_WEIGHTED_MEDIAN_H_

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace tilemend {

// Of values with weights that are not negative: half of all weight lies at it or below. None without a value.
// O(n log n).
inline std::optional<double> WeightedMedian(std::vector<std::pair<double, double>> values_and_weights) {
  std::ranges::sort(values_and_weights);
  double whole = 0;
  for (const auto& [value, weight] : values_and_weights) whole += weight;
  double below = 0;
  for (const auto& [value, weight] : values_and_weights) {
    below += weight;
    if (below >= whole / 2) return value;
  }
  return std::nullopt;
}

}  // namespace tilemend

#endif  // TILEMEND_COMMON_MESH_WEIGHTED_MEDIAN_H_
