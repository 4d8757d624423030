// Fills the holes of one mesh in this process, without a grid and without a job.
#ifndef TILEMEND_CLIENT_MESH_MESH_FILLER_H_
#define TILEMEND_CLIENT_MESH_MESH_FILLER_H_

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "client/mesh/edited_mesh.h"
#include "common/codec/mtl.h"
#include "common/records/tile_files.h"
#include "common/util/colour.h"
#include "coordinator/report/scene_report.h"
#include "coordinator/waves/scene_waves.h"
#include "worker/fill/fill_holes.h"

namespace tilemend {

// What is being done, and of how many holes it is done; 0 of 0 where none are counted.
using ShowStep = std::function<void(std::string_view step, size_t holes_done, size_t holes)>;

struct MeshFillOptions {
  FillOptions fill;
  WaterOptions water;
  MeshHoleOptions holes;
  std::optional<double> weld;       // tolerance, in the mesh's units (worker/weld/weld_rims.h)
  std::optional<Rgb> water_colour;  // none: as the rim has it
  std::string library;              // of an OBJ: the material file beside the output that its filled faces will have
  ShowStep show = [](std::string_view, size_t, size_t) {};
};

struct FilledMesh {
  std::unique_ptr<SceneWaves> waves;    // owns the plan
  SceneReportInput report;              // refers to the plan of `waves`
  std::string bytes;                    // of a file: the filled mesh, in the format of the original
  TileFiles files;                      // that the original names, relative to its folder
  std::vector<FillMaterial> materials;  // that `library` has to define; empty: there need be no such file
};

// Welds if asked, surveys, plans and fills the mesh. Errors of parsing the mesh; kCancelled once options.fill.refine is
// cancelled, which is looked at within each hole and leaves the mesh without patches. Holes that cannot be filled are
// in the report. Holds the survey and the patches, and a second copy of the mesh if some hole is no height over the
// ground.
absl::StatusOr<FilledMesh> FillMesh(EditedMesh& mesh, const MeshFillOptions& options);

// The same for the mesh in the file `path`; errors of ReadFile and ParseMesh as well. Keeps the process's heap
// (KeepHeap).
absl::StatusOr<FilledMesh> FillMesh(const std::string& path, const MeshFillOptions& options);

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_MESH_MESH_FILLER_H_
