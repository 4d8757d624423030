#include "coordinator/waves/planned_scene.h"

#include <algorithm>
#include <iterator>

#include "coordinator/plan/colour/hole_colours.h"
#include "coordinator/plan/make_cell_holes.h"
#include "coordinator/plan/plan.h"
#include "coordinator/plan/water/water.h"
#include "coordinator/waves/tiles_in_reach.h"

namespace tilemend {
namespace {

bool NeedsHeights(const PlannedScene& scene, int32_t hole) {
  const auto& segments = scene.plan.holes[hole].segments;
  return std::any_of(segments.begin(), segments.end(), [&](const RimSegment& s) {
    return scene.plan.vertices[s.from].index < 0 && !scene.heights.height.contains(s.from);
  });
}

}  // namespace

std::map<CellId, std::vector<int32_t>> HolesToFill(const Plan& plan, const std::set<CellId>& chosen) {
  std::map<CellId, std::vector<int32_t>> holes_of;
  std::set<int32_t> clusters;  // that reach chosen cells
  for (size_t h = 0; h < plan.holes.size(); ++h) {
    const PlannedHole& hole = plan.holes[h];
    if (!hole.failure.empty()) continue;
    holes_of[hole.cell].push_back(static_cast<int32_t>(h));
    if (hole.cluster >= 0 && chosen.contains(hole.cell)) clusters.insert(hole.cluster);
  }
  if (chosen.empty()) return holes_of;
  for (auto& [cell, holes] : holes_of) {
    if (chosen.contains(cell)) continue;
    std::erase_if(holes, [&](int32_t h) { return !clusters.contains(plan.holes[h].cluster); });
  }
  std::erase_if(holes_of, [](const auto& of_cell) { return of_cell.second.empty(); });
  return holes_of;
}

void MakeThePlan(const WaveOptions& options, const PlanOptions& plan, PlannedScene& scene) {
  scene.plan = MakePlan(scene.survey.input(), plan);
  SettleWater(scene.plan, scene.heights);
  scene.plan.colours = ColourHoles(scene.plan, scene.survey.input(), plan.water_colour);
  scene.is_coloured = std::ranges::any_of(scene.plan.colours, &FillColour::known);
  scene.holes_of = HolesToFill(scene.plan, options.chosen);
  scene.float32 = std::any_of(scene.survey.records().begin(), scene.survey.records().end(),
                              [](const auto& r) { return r.second != nullptr && r.second->float32; });
}

std::vector<BorderAudit> BordersToCompare(const PlannedScene& scene, const WaveOptions& options) {
  const auto is_filled = [&](CellId cell) { return scene.holes_of.contains(cell) && options.IsChosen(cell); };
  std::vector<BorderAudit> borders;
  std::copy_if(scene.plan.borders.begin(), scene.plan.borders.end(), std::back_inserter(borders),
               [&](const BorderAudit& border) { return is_filled(border.a) && is_filled(border.b); });
  return borders;
}

std::vector<int32_t> HolesOfLayer(const PlannedScene& scene, CellId cell, int32_t layer) {
  const std::vector<int32_t>& holes = scene.holes_of.at(cell);
  std::vector<int32_t> of_layer;
  std::copy_if(holes.begin(), holes.end(), std::back_inserter(of_layer),
               [&](int32_t h) { return scene.plan.holes[h].layer == layer && NeedsHeights(scene, h); });
  return of_layer;
}

int32_t LastLayerOf(const Plan& plan, const std::vector<int32_t>& holes) {
  int32_t last = 1;
  for (const int32_t h : holes) {
    if (plan.holes[h].water < 0) last = std::max(last, plan.holes[h].layer);
  }
  return last;
}

bool CanBeFilled(const PlannedScene& scene, CellId cell) {
  const auto holes = scene.holes_of.find(cell);
  return holes != scene.holes_of.end() &&
         std::none_of(holes->second.begin(), holes->second.end(), [&](int32_t h) { return NeedsHeights(scene, h); });
}

LayerWork LayerWorkOf(const PlannedScene& scene, CellId cell, int32_t layer) {
  return {MakeCellHoles(scene.plan, scene.survey.input(), scene.heights, HolesOfLayer(scene, cell, layer), false)};
}

FillWork FillWorkOf(const PlannedScene& scene, CellId cell, int32_t layer, bool is_wang) {
  const PlanInput& input = scene.survey.input();
  FillWork work{MakeFillHoles(scene.plan, input, scene.heights, scene.holes_of.at(cell)), {}};
  for (const CellId tile : TilesInReach(work.holes, scene.plan, input))
    work.surface.push_back(&scene.survey.tile(tile));
  if (is_wang && !HolesOfLayer(scene, cell, layer).empty()) work.sampled = LayerWorkOf(scene, cell, layer).holes;
  return work;
}

AssembleWork AssembleWorkOf(const PlannedScene& scene, CellId cell, bool is_wang) {
  const auto& records = scene.survey.records();
  const std::vector<FillColour>& colours = scene.plan.colours;
  AssembleWork work{&scene.survey.tile(cell)};
  work.float32 = scene.float32;
  if (const auto record = records.find(cell); record != records.end() && record->second != nullptr) {
    work.tile_vertices = record->second->vertex_count;
  }
  if (const auto holes = scene.holes_of.find(cell); holes != scene.holes_of.end()) {
    for (const int32_t h : holes->second) work.colours.of_holes[h] = colours[h];
    if (is_wang) work.holes = HolesAsFilled(scene, cell);
  }
  work.colours.on_vertices = scene.is_coloured;
  return work;
}

CellHoles HolesAsFilled(const PlannedScene& scene, CellId cell) {
  return MakeFillHoles(scene.plan, scene.survey.input(), scene.heights, scene.holes_of.at(cell), false);
}

}  // namespace tilemend
