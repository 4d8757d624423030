#include "worker/fill/shape/patch_quality.h"

#include <algorithm>

#include "common/mesh/triangle_shape.h"

namespace tilemend {
namespace {

bool IsForced(const CellHoles& cell, const HolePatch& patch, const Triangle& t) {
  const auto position = [&](int32_t v) { return v >= 0 ? cell.vertices[v].position : patch.new_points[-1 - v]; };
  const auto original = [&](int32_t v) { return v >= 0 && cell.vertices[v].index >= 0; };
  if (std::all_of(t.begin(), t.end(), original)) return true;
  int shortest = 0;
  double least = 0;
  for (int k = 0; k < 3; ++k) {
    const double length = (position(t[(k + 1) % 3]) - position(t[k])).norm();
    if (k > 0 && length >= least) continue;
    shortest = k;
    least = length;
  }
  return original(t[shortest]) && original(t[(shortest + 1) % 3]);
}

}  // namespace

QualityTally TallyQuality(const CellHoles& cell, const std::vector<HolePatch>& patches) {
  QualityTally tally;
  for (const HolePatch& patch : patches) {
    const auto position = [&](int32_t v) { return v >= 0 ? cell.vertices[v].position : patch.new_points[-1 - v]; };
    for (const Triangle& t : patch.triangles) {
      const double quality = TriangleQuality(position(t[0]), position(t[1]), position(t[2]));
      tally.Add(quality, quality < kPoorQuality && IsForced(cell, patch, t));
    }
  }
  return tally;
}

}  // namespace tilemend
