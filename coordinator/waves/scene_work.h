// The pieces of work that a scene is made of, and what comes of each.
#ifndef TILEMEND_COORDINATOR_WAVES_SCENE_WORK_H_
#define TILEMEND_COORDINATOR_WAVES_SCENE_WORK_H_

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "common/grid/scene.h"
#include "common/mesh/quality_tally.h"
#include "common/records/cell_holes.h"
#include "common/records/fill_colour.h"
#include "coordinator/plan/seam/seam_heights.h"

namespace tilemend {

// Survey a tile. Gives its SurveyRecord. Pointers to tiles hold as long as the SceneWaves that gave them.
struct SurveyWork {
  const SceneTile* tile = nullptr;
};

// Sample the thin-plate surface of a whole cluster along its seams. Gives ClusterSamples.
struct ClusterWork {
  int32_t cluster = 0;
  CellHoles holes;  // all of the cluster; `cell` is that of the first
};

// Project heights onto the seams of one cell's holes in one layer (Wang 2021, 3.3). Gives samples of its cell.
struct LayerWork {
  CellHoles holes;
};

// Fill the holes of one cell. Gives CellPatches.
struct FillWork {
  CellHoles holes;
  std::vector<const SceneTile*> surface;  // tiles that patches of closed holes may not pass through
};

// Write the tile of one cell with its patches.
struct AssembleWork {
  const SceneTile* tile = nullptr;
  bool float32 = false;       // number type of a new tile, where the cell has none
  int64_t tile_vertices = 0;  // in the tile, as surveyed
  FillColours colours = {};
};

using SceneWork = std::variant<SurveyWork, ClusterWork, LayerWork, FillWork, AssembleWork>;

struct ClusterSamples {
  int32_t cluster = 0;
  std::vector<ClusterSample> samples;  // empty: the cluster has no such surface, its seams are sampled by layers
  std::optional<HoldOut> hold_out;     // where the tension was chosen
};

// What is to be known of a patch; the patch itself stays with who made it.
struct PatchExtent {
  int32_t hole = 0;          // into Plan::holes
  std::string failure = {};  // not empty: the hole stays open, for this reason
  int64_t new_vertices = 0;
  int64_t triangles = 0;
  std::optional<HoldOut> hold_out = {};  // where the tension was chosen for this hole alone
  FillWay way = FillWay::kNone;
};

struct CellPatches {
  std::vector<PatchExtent> patches;
  QualityTally quality;  // of all triangles
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_WAVES_SCENE_WORK_H_
