// Surveys scenes and single meshes in this process, without a job.
#ifndef TILEMEND_CLIENT_INSPECTION_H_
#define TILEMEND_CLIENT_INSPECTION_H_

#include <map>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/codec/mesh_file.h"
#include "coordinator/plan/plan.h"

namespace tilemend {

struct Inspection {
  Scene scene;
  std::map<CellId, SurveyRecord> records;
  std::vector<absl::Status> errors;  // of tiles that cannot be read or do not fit their cell, in order of the cells
  Plan plan;                         // empty if there are errors
};

// Surveys all tiles of a scene, as many at once as there are cores, and plans.
absl::StatusOr<Inspection> InspectScene(const std::string& path, const PlanOptions& options);

// Whether `path` is a file and no scene.json: a single mesh.
bool IsSingleMesh(const std::string& path);

// Surveys and plans one mesh: no grid, one cell (0, 0).
struct MeshInspection {
  SurveyRecord record;
  PlanInput input;  // refers to `record`: not copied
  Plan plan;
  MeshInspection() = default;
  MeshInspection(const MeshInspection&) = delete;
  MeshInspection& operator=(const MeshInspection&) = delete;
};
void InspectMesh(const MeshFile& file, const PlanOptions& options, MeshInspection& inspection);

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_INSPECTION_H_
