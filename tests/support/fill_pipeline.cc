#include "tests/support/fill_pipeline.h"

#include <utility>

#include "common/mesh/position_index.h"
#include "coordinator/plan/make_cell_holes.h"
#include "coordinator/plan/water/water.h"
#include "worker/assemble/assemble.h"
#include "worker/fill/seam/sample_heights.h"

namespace tilemend {
namespace {

using HolesByCell = std::map<CellId, std::vector<int32_t>>;

// The holes of one layer that can be filled; of all layers, and the closed holes, when `layer` is negative.
HolesByCell HolesOf(const Plan& plan, int32_t layer) {
  HolesByCell holes;
  for (size_t h = 0; h < plan.holes.size(); ++h) {
    if (!plan.holes[h].failure.empty() || (layer >= 0 && plan.holes[h].layer != layer)) continue;
    holes[plan.holes[h].cell].push_back(static_cast<int32_t>(h));
  }
  return holes;
}

SeamHeights SettleSeams(const Plan& plan, const PlanInput& input, double gamma) {
  SeamHeights heights;
  SettleWater(plan, heights);
  for (int32_t layer = 1; layer <= plan.layers; ++layer) {
    std::vector<SeamSample> samples;
    for (const auto& [cell, holes] : HolesOf(plan, layer)) {
      const CellHoles work = MakeCellHoles(plan, input, heights, holes, false);
      for (const HeightSample& s : SampleHeights(work)) samples.push_back({cell, s.seam_vertex, s.height});
    }
    SettleLayer(plan, samples, gamma, heights);
  }
  return heights;
}

void Append(const FilePatch& patch, TriMesh& tile) {
  tile.points.insert(tile.points.end(), patch.new_points.begin(), patch.new_points.end());
  tile.triangles.insert(tile.triangles.end(), patch.triangles.begin(), patch.triangles.end());
}

}  // namespace

FilledScene FillScene(const SurveyedScene& scene, const PipelineOptions& options) {
  const PlanInput input = scene.Input();
  FilledScene filled;
  filled.plan = MakePlan(input, options.plan);
  filled.heights = SettleSeams(filled.plan, input, options.gamma);
  filled.tiles = scene.tiles;
  for (const auto& [cell, holes] : HolesOf(filled.plan, -1)) {
    const CellHoles work = MakeCellHoles(filled.plan, input, filled.heights, holes, true);
    const std::vector<HolePatch> patches = FillHoles(work, options.fill);
    TriMesh& tile = filled.tiles[cell];
    const bool has_tile = scene.records.contains(cell);
    const auto own = has_tile ? static_cast<int32_t>(tile.points.size()) : 0;
    if (!has_tile) tile = TriMesh{};
    Append(MergePatches(work.vertices, patches, cell, own), tile);
    for (const HolePatch& patch : patches) filled.patches[patch.hole] = patch;
  }
  return filled;
}

TriMesh WeldTiles(const std::map<CellId, TriMesh>& tiles) {
  TriMesh welded;
  PositionIndex index;
  for (const auto& [cell, tile] : tiles) {
    for (const Triangle& t : tile.triangles) {
      welded.triangles.push_back(
          {index.Insert(tile.points[t[0]]), index.Insert(tile.points[t[1]]), index.Insert(tile.points[t[2]])});
    }
  }
  welded.points = index.positions();
  return welded;
}

}  // namespace tilemend
