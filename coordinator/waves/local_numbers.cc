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
  CellHoles none;
  return Localise(holes, none);
}

LocalNumbers Localise(CellHoles& holes, CellHoles& others) {
  LocalNumbers numbers;
  for (CellHoles* all : {&holes, &others}) {
    for (const CellHole& hole : all->holes) numbers.holes.push_back(hole.id);
    for (const RimVertex& v : all->vertices) {
      for (const int32_t seam_vertex : {v.seam_vertex, v.follows}) {
        if (seam_vertex >= 0) numbers.seam_vertices.push_back(seam_vertex);
      }
    }
  }
  SortAndThin(numbers.holes);
  SortAndThin(numbers.seam_vertices);
  for (CellHoles* all : {&holes, &others}) {
    for (CellHole& hole : all->holes) hole.id = LocalNumber(numbers.holes, hole.id);
    for (RimVertex& v : all->vertices) {
      if (v.seam_vertex >= 0) v.seam_vertex = LocalNumber(numbers.seam_vertices, v.seam_vertex);
      if (v.follows >= 0) v.follows = LocalNumber(numbers.seam_vertices, v.follows);
    }
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
