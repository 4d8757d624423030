#include "coordinator/waves/local_numbers.h"

#include <algorithm>

namespace tilemend {
namespace {

void SortAndThin(std::vector<int32_t>& numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

}  // namespace

LocalNumbers Localise(CellHoles& holes) {
  LocalNumbers numbers;
  for (const CellHole& hole : holes.holes) numbers.holes.push_back(hole.id);
  for (const RimVertex& v : holes.vertices) {
    if (v.seam_vertex >= 0) numbers.seam_vertices.push_back(v.seam_vertex);
  }
  SortAndThin(numbers.holes);
  SortAndThin(numbers.seam_vertices);
  for (CellHole& hole : holes.holes) hole.id = LocalNumber(numbers.holes, hole.id);
  for (RimVertex& v : holes.vertices) {
    if (v.seam_vertex >= 0) v.seam_vertex = LocalNumber(numbers.seam_vertices, v.seam_vertex);
  }
  return numbers;
}

std::optional<int32_t> InPlan(const std::vector<int32_t>& numbers, int64_t local) {
  if (local < 0 || local >= std::ssize(numbers)) return std::nullopt;
  return numbers[static_cast<size_t>(local)];
}

int32_t LocalNumber(const std::vector<int32_t>& numbers, int32_t in_plan) {
  return static_cast<int32_t>(std::lower_bound(numbers.begin(), numbers.end(), in_plan) - numbers.begin());
}

}  // namespace tilemend
