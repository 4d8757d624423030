// The waves of a scene in memory, one piece of work after the other.
#ifndef TILEMEND_TESTS_SUPPORT_FILL_PIPELINE_H_
#define TILEMEND_TESTS_SUPPORT_FILL_PIPELINE_H_

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "common/mesh/tri_mesh.h"
#include "common/records/cell_holes.h"
#include "coordinator/plan/plan.h"
#include "coordinator/plan/seam/seam_heights.h"
#include "tests/support/surveyed_scene.h"
#include "worker/fill/fill_holes.h"

namespace tilemend {

struct PipelineOptions {
  PlanOptions plan;
  FillOptions fill;
};

struct FilledScene {
  Plan plan;
  SeamHeights heights;
  std::map<int32_t, HolePatch> patches;  // by hole of the plan; those without a failure in the plan
  std::map<CellId, TriMesh> tiles;       // with their patches: the tile's own vertices and triangles first
};

// Throws std::logic_error if the waves refuse a result.
FilledScene FillScene(const SurveyedScene& scene, const PipelineOptions& options = {});

// All tiles as one mesh, equal positions welded.
TriMesh WeldTiles(const std::map<CellId, TriMesh>& tiles);

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_FILL_PIPELINE_H_
