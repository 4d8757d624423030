#include "coordinator/report/rim_heights.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "coordinator/report/rounded.h"

namespace tilemend {

double RimHeight(const Plan& plan, const PlannedHole& hole) {
  double original = 0, all = 0;
  size_t originals = 0;
  for (const RimSegment& s : hole.segments) {
    const PlanVertex& vertex = plan.vertices[static_cast<size_t>(s.from)];
    all += vertex.position.z();
    if (vertex.index < 0) continue;  // of a seam: its height may not be known
    original += vertex.position.z();
    ++originals;
  }
  return originals > 0 ? original / static_cast<double>(originals) : all / static_cast<double>(hole.segments.size());
}

nlohmann::ordered_json RimHeightsJson(const Plan& plan, const PlannedHole& hole) {
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  const auto add = [&](const RimSegment& s) {
    for (const int32_t v : {s.from, s.to}) {
      const PlanVertex& vertex = plan.vertices[static_cast<size_t>(v)];
      if (vertex.index < 0) continue;
      lowest = std::min(lowest, vertex.position.z());
      highest = std::max(highest, vertex.position.z());
    }
  };
  std::ranges::for_each(hole.segments, add);
  for (const std::vector<RimSegment>& region : hole.own_regions) std::ranges::for_each(region, add);
  if (lowest > highest) return nullptr;
  return {Rounded(lowest, kMillimetres), Rounded(highest, kMillimetres)};
}

}  // namespace tilemend
