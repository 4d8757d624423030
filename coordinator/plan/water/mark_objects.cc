#include "coordinator/plan/water/mark_objects.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "coordinator/plan/water/hole_groups.h"
#include "coordinator/plan/water/hole_parts.h"

namespace tilemend {
namespace {

// Of a vertex's size: triangles may be this much smaller than the edges there, no more.
constexpr double kLeastShareOfSize = 0.4;

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

void MarkHolesInGround(Plan& plan) {
  for (const std::vector<int32_t>& holes : GroupHoles(plan)) {
    PlannedHole& hole = plan.holes[holes.front()];
    if (hole.kind != HoleKind::kClosed || hole.standing == Standing::kHanging) continue;
    const std::vector<int32_t> rim = RimVerticesOf(plan, holes);
    const bool is_in_ground = std::ranges::any_of(rim, [&](int32_t v) { return plan.vertices[v].on_ground; });
    hole.standing = is_in_ground ? Standing::kInGround : Standing::kElse;
  }
}

}  // namespace

void MarkObjects(Plan& plan) {
  MarkHolesInGround(plan);
  // A vertex may be on the rims of several groups.
  std::vector<bool> stands_on_object(plan.vertices.size(), false);  // as seen from one of them
  std::vector<int> groups(plan.vertices.size(), 0);
  std::vector<std::pair<int32_t, float>> below;
  for (const std::vector<int32_t>& holes : GroupHoles(plan)) {
    const std::vector<int32_t> rim = RimVerticesOf(plan, holes);
    for (const int32_t v : rim) ++groups[v];
    if (std::ranges::all_of(rim, [&](int32_t v) { return plan.vertices[v].on_object; })) continue;
    const RoofParts in_roofs = FindRoofParts(plan, holes);
    const std::set<int32_t> joined(in_roofs.joined.begin(), in_roofs.joined.end());
    for (const int32_t v : rim) {
      if (!joined.contains(v)) stands_on_object[v] = true;
    }
    below.insert(below.end(), in_roofs.below.begin(), in_roofs.below.end());
  }
  for (size_t v = 0; v < stands_on_object.size(); ++v) {
    if (stands_on_object[v]) continue;
    plan.vertices[v].on_object = false;
    plan.vertices[v].ground.reset();
  }
  for (const auto& [v, height] : below) {
    if (groups[v] > 1) continue;
    plan.vertices[v].on_object = true;
    plan.vertices[v].ground = height;
  }
  LowerSizesAtObjects(plan);
}

}  // namespace tilemend
