// Surveys scenes and single meshes in this process, without a job.
#ifndef TILEMEND_CLIENT_INSPECTION_H_
#define TILEMEND_CLIENT_INSPECTION_H_

#include <memory>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "client/step_watcher.h"
#include "common/codec/mesh_file.h"
#include "coordinator/waves/scene_waves.h"

namespace tilemend {

struct Inspection {
  std::unique_ptr<SceneWaves> waves;  // planned; of no use beyond the scene if there are errors
  std::vector<std::string> warnings;  // on files that tiles name, in order of the cells; those of a job's report but
                                      // for images that cannot be decoded
  std::vector<absl::Status> errors;   // of tiles that cannot be read or do not fit their cell, in order of the cells
};

// Surveys all tiles of a scene, or a single mesh (SceneOfMesh), as many at once as there are cores, and plans. Keeps
// freed memory for the process (KeepHeap).
Inspection InspectScene(Scene scene, const PlanOptions& options, const StepWatcher& watcher = {});

// Whether `path` is a file and no scene.json: a single mesh.
bool IsSingleMesh(const std::string& path);

SurveyRecord SurveyOf(const MeshFile& file);

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_INSPECTION_H_
