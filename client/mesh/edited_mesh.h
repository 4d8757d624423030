// A single mesh while its holes are filled: the bytes of a file (file_mesh.h) or arrays (array_mesh.h).
#ifndef TILEMEND_CLIENT_MESH_EDITED_MESH_H_
#define TILEMEND_CLIENT_MESH_EDITED_MESH_H_

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/codec/mesh_file.h"
#include "common/mesh/clear_area.h"
#include "common/mesh/mesh_view.h"
#include "common/mesh/tri_mesh.h"
#include "common/records/weld.h"
#include "worker/materials/survey_look.h"

namespace tilemend {

// A mesh to read. Valid until the next edit of the mesh it is of.
struct HeldMesh {
  std::unique_ptr<const TriMesh> parsed;  // null: the view is of what the edited mesh holds
  MeshView view;
};

// Each edit keeps the numbers of vertices; triangles are numbered anew by Clear. Errors name the mesh and the place.
// Precondition of all functions but name and Append: nothing was appended. Not safe from several threads.
class EditedMesh {
 public:
  virtual ~EditedMesh() = default;

  // Stands in messages: a path, or what the caller calls the mesh.
  virtual const std::string& name() const = 0;
  // The mesh as it is now. Cost: that of parsing it, if it is a file.
  virtual absl::StatusOr<HeldMesh> Mesh() const = 0;
  // Boundary edges, colours along them, and files that the mesh names.
  virtual absl::StatusOr<LookSurvey> Survey(NoFaces no_faces) const = 0;
  // Merges boundary vertices (worker/weld/weld_rims.h). Precondition: tolerance > 0.
  virtual absl::StatusOr<WeldRecord> Weld(double tolerance) = 0;
  // Takes out the triangles that AreasThatClear names, and returns how many by each area.
  virtual absl::StatusOr<std::vector<int64_t>> Clear(std::span<const ClearArea> areas) = 0;
  // Adds vertices and triangles behind those that are there. Coordinates are rounded to the mesh's number type. After
  // an error the mesh is as it was.
  virtual absl::Status Append(const FilePatch& patch) = 0;
};

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_MESH_EDITED_MESH_H_
