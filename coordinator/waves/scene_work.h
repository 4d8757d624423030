// The pieces of work that a scene is made of, and what comes of each.
#ifndef TILEMEND_COORDINATOR_WAVES_SCENE_WORK_H_
#define TILEMEND_COORDINATOR_WAVES_SCENE_WORK_H_

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "common/grid/scene.h"
#include "common/mesh/clear_area.h"
#include "common/mesh/height_tally.h"
#include "common/mesh/quality_tally.h"
#include "common/records/cell_holes.h"
#include "common/records/fill_colour.h"
#include "common/records/rim_ground.h"
#include "common/records/stored_record.h"
#include "coordinator/plan/seam/seam_heights.h"

namespace tilemend {

// Tally the heights of a tile in polygons whose surface is to be taken out. Gives TileLevels. Pointers to tiles hold as
// long as the SceneWaves that gave them.
struct MeasureWork {
  const SceneTile* tile = nullptr;
  std::vector<PlanePolygon> polygons = {};
};

// Survey a tile without the surface that is taken out of it. Gives its TileSurvey.
struct SurveyWork {
  const SceneTile* tile = nullptr;
  std::vector<ClearArea> clear = {};
};

// Tell ground from objects at a cell's boundary vertices, by the rasters of these cells. Gives CellGround.
struct GroundWork {
  CellId cell;
  StoredRecord record;         // of the cell
  std::vector<CellId> around;  // those with a tile within reach of the filter, the cell itself among them
};

// Sample the thin-plate surface of a whole cluster along its seams. Gives ClusterSamples.
struct ClusterWork {
  int32_t cluster = 0;
  CellHoles holes;  // all of the cluster; `cell` is that of the first
};

// Project heights onto the seams of one cell's holes in one layer (Wang 2021, 3.3). Gives LayerSamples of its cell.
struct LayerWork {
  CellHoles holes;
};

// Fill the holes of one cell. Gives a CellFill; with the surface of Wang 2021 also the boundary height samples of the
// holes in `sampled`, which are taken first (TakeSampledHeights).
struct FillWork {
  CellHoles holes;
  std::vector<const SceneTile*> surface = {};  // tiles that patches of closed holes may not pass through
  std::optional<CellHoles> sampled = {};       // without a band
};

// Smooth the patches of two cells of one layer along the seam between them (Wang 2021, 3.4). Gives a SmoothedSeam, and
// new heights of points of both cells' patches, which stay with who made the patches. Numbers are the plan's.
struct SmoothWork {
  std::array<CellId, 2> cells = {};
  int32_t number = 0;                              // PairSeam::number
  std::array<CellHoles, 2> sides = {};             // as filled, with heights and without bands
  std::array<std::vector<int32_t>, 2> holes = {};  // those that the seam bounds
  std::vector<int32_t> vertices = {};              // of the seam, rising
  std::vector<double> heights = {};                // of each: the mean of what its cells gave
};

// Write the tile of one cell with its patches. Gives TileWritten.
struct AssembleWork {
  const SceneTile* tile = nullptr;
  bool float32 = false;       // number type of a new tile, where the cell has none
  int64_t tile_vertices = 0;  // in the tile, as surveyed
  FillColours colours = {};
  std::optional<CellHoles> holes = {};  // of Wang 2021: as filled, with the heights that seams have in the end; no band
};

using SceneWork =
    std::variant<MeasureWork, SurveyWork, GroundWork, ClusterWork, LayerWork, FillWork, SmoothWork, AssembleWork>;

struct TileLevels {
  CellId cell;
  std::vector<HeightTally> tallies;  // of MeasureWork::polygons
};

struct TileSurvey {
  CellId cell;
  StoredRecord record;
  std::vector<int64_t> cleared = {};  // how many triangles each of SurveyWork::clear took
};
// With the record in memory.
inline TileSurvey SurveyInMemory(CellId cell, SurveyRecord record, std::vector<int64_t> cleared = {}) {
  return {cell, StoredRecord(std::make_shared<const SurveyRecord>(std::move(record))), std::move(cleared)};
}

struct CellGround {
  CellId cell;
  RimGround rim;
};

struct ClusterSamples {
  int32_t cluster = 0;
  std::vector<ClusterSample> samples;  // empty: the cluster has no such surface, its seams are sampled by layers
  std::optional<HoldOut> hold_out;     // where the tension was chosen
};

struct LayerSamples {
  std::vector<SeamSample> samples;
};

// What is to be known of a patch; the patch itself stays with who made it.
struct PatchExtent {
  int32_t hole = 0;          // into Plan::holes
  std::string failure = {};  // not empty: the hole stays open, for this reason
  int64_t new_vertices = 0;
  int64_t triangles = 0;
  std::optional<HoldOut> hold_out = {};  // where the tension was chosen for this hole alone
  FillWay way = FillWay::kNone;
  int32_t loop_cuts = 0, creases = 0, crossings = 0;  // as HolePatch
  bool rim_is_crossed = false;                        // as HolePatch
};

struct CellPatches {
  std::vector<PatchExtent> patches;
  QualityTally quality;                  // of all triangles
  std::vector<SeamSample> samples = {};  // of FillWork::sampled
};

struct CellFill {
  CellId cell;
  CellPatches patches;
};

// New heights of the vertices of a seam, in the order of its SmoothWork.
struct SmoothedSeam {
  std::array<CellId, 2> cells = {};
  std::vector<int32_t> vertices = {};
  std::vector<double> heights = {};
};

struct TileWritten {};

// In place of a result, for this reason:
struct LeftWork {
  enum class Kind {
    kGround,  // nothing at the boundary of `cell` is taken for an object
    kHoles,   // of ClusterWork, LayerWork or FillWork: the holes of `cell` stay open
    kSeam,    // the seams of `cell` that are given out with it keep what its cells gave
    kTile     // the tile is not written, and so its holes are not filled
  };
  Kind kind;
  CellId cell;
  std::string reason;
};

using SceneResult = std::variant<TileLevels, TileSurvey, CellGround, ClusterSamples, LayerSamples, CellFill,
                                 SmoothedSeam, TileWritten, LeftWork>;

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_WAVES_SCENE_WORK_H_
