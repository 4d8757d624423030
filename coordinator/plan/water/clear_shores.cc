#include "coordinator/plan/water/clear_shores.h"

#include <algorithm>
#include <cmath>

#include "common/records/flat_water.h"
#include "common/records/water_surface.h"
#include "coordinator/plan/water/area_cover.h"
#include "coordinator/plan/water/hole_groups.h"

namespace tilemend {
namespace {

constexpr double kDecides = 0.5;  // share of a body

bool IsCleared(const WaterBody& body, const std::vector<WaterArea>& areas, const Plan& plan) {
  const CoverLines region(BoundaryOf(plan, body.holes));
  const auto decides = std::find_if(areas.rbegin(), areas.rend(),
                                    [&](const WaterArea& area) { return region.ShareIn(area) > kDecides; });
  return decides != areas.rend() && decides->clear;
}

void MarkShore(const WaterBody& body, Plan& plan) {
  for (const int32_t h : body.holes) {
    ForRimSegments(plan.holes[h], [&](const RimSegment& s) {
      for (const int32_t v : {s.from, s.to}) {
        PlanVertex& vertex = plan.vertices[v];
        if (vertex.index < 0) continue;
        const double level = LevelAt(body, vertex.position.head<2>(), plan.lattice_step);
        if (std::abs(vertex.position.z() - level) > kFlatWithin) vertex.on_object = true;
      }
    });
  }
}

}  // namespace

void MarkClearedShores(const std::vector<WaterArea>& areas, Plan& plan) {
  if (std::none_of(areas.begin(), areas.end(), [](const WaterArea& area) { return area.clear; })) return;
  for (const WaterBody& body : plan.water) {
    if (IsCleared(body, areas, plan)) MarkShore(body, plan);
  }
}

}  // namespace tilemend
