#include "coordinator/report/rim_heights.h"

#include <algorithm>
#include <limits>

#include "coordinator/report/rounded.h"

namespace tilemend {

double RimHeight(const Plan& plan, const PlannedHole& hole) {
  double height = 0;
  for (const RimSegment& s : hole.segments) height += plan.vertices[static_cast<size_t>(s.from)].position.z();
  return height / static_cast<double>(hole.segments.size());
}

nlohmann::ordered_json RimHeightsJson(const Plan& plan, const PlannedHole& hole) {
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (const RimSegment& s : hole.segments) {
    if (s.seam) continue;
    for (const int32_t v : {s.from, s.to}) {
      lowest = std::min(lowest, plan.vertices[static_cast<size_t>(v)].position.z());
      highest = std::max(highest, plan.vertices[static_cast<size_t>(v)].position.z());
    }
  }
  if (lowest > highest) return nullptr;
  return {Rounded(lowest, kMillimetres), Rounded(highest, kMillimetres)};
}

}  // namespace tilemend
