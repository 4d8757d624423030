#include "coordinator/plan/water/known_water.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "coordinator/plan/water/area_cover.h"
#include "coordinator/plan/water/hole_groups.h"

namespace tilemend {
namespace {

// What stays of a river beside these holes, and a station more on either side.
void KeepBeside(const Plan& plan, WaterBody& river) {
  const std::vector<Point3>& all = river.river.stations;
  size_t first = all.size() - 1, last = 0;
  for (const auto& [a, b] : BoundaryOf(plan, river.holes)) {
    const size_t piece = NearestOnLine(all, a).piece;
    first = std::min(first, piece);
    last = std::max(last, piece + 1);
  }
  if (first > last) return;
  first -= std::min<size_t>(first, 1);
  last = std::min(last + 1, all.size() - 1);
  river.river.stations =
      std::vector<Point3>(all.begin() + static_cast<ptrdiff_t>(first), all.begin() + static_cast<ptrdiff_t>(last) + 1);
  const auto is_off = [&](const RemovedRise& rise) {
    return std::ranges::none_of(river.river.stations, [&](const Point3& s) { return s.head<2>() == rise.at; });
  };
  std::erase_if(river.removed_rises, is_off);
  river.level = LevelAt(river.river, river.river.stations.back().head<2>(), plan.lattice_step);
}

// The open clusters that have holes with water and others.
std::set<int32_t> MixedClusters(const Plan& plan) {
  std::map<int32_t, bool> first;
  std::set<int32_t> mixed;
  for (const PlannedHole& hole : plan.holes) {
    if (hole.cluster < 0 || !hole.failure.empty()) continue;
    const bool is_water = hole.water >= 0;
    if (first.try_emplace(hole.cluster, is_water).first->second != is_water) mixed.insert(hole.cluster);
  }
  return mixed;
}

}  // namespace

void KnownWater::Forget(const std::vector<int32_t>& holes) {
  if (bodies.empty()) return;
  for (const int32_t h : holes) body_of[h] = -1;
}

KnownWater FindKnownWater(const Plan& whole, const Plan& plan) {
  std::vector<int32_t> water;
  for (const PlannedHole& hole : whole.holes) {
    const bool is_water = hole.water >= 0 && whole.water[hole.water].kind == BodyKind::kWater;
    water.push_back(is_water ? hole.water : -1);
  }
  return {whole.water, GroupsCovering(plan, whole, water)};
}

void AddKnownWater(const KnownWater& more, KnownWater& known) {
  const auto first = static_cast<int32_t>(known.bodies.size());
  known.bodies.insert(known.bodies.end(), more.bodies.begin(), more.bodies.end());
  for (size_t h = 0; h < known.body_of.size(); ++h) {
    if (known.body_of[h] < 0 && more.body_of[h] >= 0) known.body_of[h] = first + more.body_of[h];
  }
}

std::vector<WaterBody> PartsOfKnown(const KnownWater& known, const std::vector<bool>& is_water, const Plan& plan) {
  std::vector<WaterBody> parts;
  std::vector<std::vector<int32_t>> holes_of(known.bodies.size());
  for (size_t h = 0; h < known.body_of.size(); ++h) {
    if (known.body_of[h] >= 0 && !is_water[h]) holes_of[known.body_of[h]].push_back(static_cast<int32_t>(h));
  }
  for (size_t b = 0; b < known.bodies.size(); ++b) {
    if (holes_of[b].empty()) continue;
    WaterBody part = known.bodies[b];
    part.holes = std::move(holes_of[b]);
    if (!part.river.stations.empty()) KeepBeside(plan, part);
    parts.push_back(std::move(part));
  }
  return parts;
}

void HoldLevelAtEdges(Plan& plan) {
  const std::set<int32_t> mixed = MixedClusters(plan);
  for (const PlannedHole& hole : plan.holes) {
    if (hole.water < 0 || !mixed.contains(hole.cluster)) continue;
    const WaterBody& body = plan.water[hole.water];
    for (const RimSegment& s : hole.segments) {
      for (const int32_t v : {s.from, s.to}) {
        PlanVertex& vertex = plan.vertices[v];
        if (vertex.index >= 0) continue;
        vertex.height_given = true;
        vertex.position.z() = LevelAt(body, vertex.position.head<2>(), plan.lattice_step);
      }
    }
  }
}

}  // namespace tilemend
