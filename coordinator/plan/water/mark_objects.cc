#include "coordinator/plan/water/mark_objects.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "coordinator/plan/water/hole_groups.h"

namespace tilemend {
namespace {

// Of a vertex's size: triangles may be this much smaller than the edges there, no more.
constexpr double kLeastShareOfSize = 0.4;

// By vertex of the plan; none: it stands on no object. NaN: the ground under it is not known.
std::vector<std::optional<float>> GroundUnderObjects(const PlanInput& input, const Plan& plan) {
  std::vector<std::optional<float>> under(plan.vertices.size());
  for (const auto& [cell, rim] : input.rim_ground) {
    const std::span<const int32_t> vertices = plan.VerticesOf(cell);
    for (size_t i = 0; i < std::min(vertices.size(), rim.on_object.size()); ++i) {
      if (rim.on_object[i] && vertices[i] >= 0) under[vertices[i]] = rim.ground[i];
    }
  }
  return under;
}

// Edges that run up an object are long in space alone: triangles of that length beside them would carry its wall far
// out.
void LowerSizesAtObjects(Plan& plan) {
  std::map<int32_t, std::pair<double, int>> lengths;  // seen from above: sum and count
  for (const PlannedHole& hole : plan.holes) {
    ForRimSegments(hole, [&](const RimSegment& s) {
      if (s.seam) return;
      const Point3 way = plan.vertices[s.to].position - plan.vertices[s.from].position;
      for (const int32_t v : {s.from, s.to}) {
        if (!plan.vertices[v].on_object) continue;
        lengths[v].first += way.head<2>().norm();
        ++lengths[v].second;
      }
    });
  }
  for (const auto& [v, length] : lengths) {
    double& size = plan.vertices[v].size;
    size = std::clamp(length.first / length.second, kLeastShareOfSize * size, size);
  }
}

}  // namespace

void MarkObjects(const PlanInput& input, Plan& plan) {
  if (input.rim_ground.empty()) return;
  const std::vector<std::optional<float>> under = GroundUnderObjects(input, plan);
  for (const std::vector<int32_t>& holes : GroupHoles(plan)) {
    const std::vector<int32_t> rim = RimVerticesOf(plan, holes);
    if (std::ranges::all_of(rim, [&](int32_t v) { return under[v].has_value(); })) continue;
    for (const int32_t v : rim) {
      plan.vertices[v].on_object = under[v].has_value();
      if (under[v] && !std::isnan(*under[v])) plan.vertices[v].ground = under[v];
    }
  }
  LowerSizesAtObjects(plan);
}

}  // namespace tilemend
