#include "client/mesh/file_mesh.h"

#include <filesystem>
#include <iterator>
#include <memory>

#include "common/assemble/clear_tile.h"
#include "common/codec/face_edits.h"
#include "common/util/files.h"
#include "common/util/status_macros.h"
#include "worker/weld/weld_rims.h"

namespace tilemend {

absl::StatusOr<FileMesh> FileMesh::Open(const std::string& path) {
  TILEMEND_ASSIGN_OR_RETURN(const MeshFormat format, MeshFormatOf(path));
  TILEMEND_ASSIGN_OR_RETURN(std::string bytes, ReadFile(path));
  return FileMesh(path, format, std::move(bytes));
}

absl::StatusOr<HeldMesh> FileMesh::Mesh() const {
  TILEMEND_ASSIGN_OR_RETURN(MeshFile file, ParseMesh(format_, bytes_, path_));
  auto parsed = std::make_unique<const TriMesh>(std::move(file.mesh));
  const MeshView view = *parsed;
  return HeldMesh{std::move(parsed), view};
}

absl::StatusOr<LookSurvey> FileMesh::Survey(NoFaces no_faces) const {
  const std::filesystem::path path(path_);
  const std::string folder = path.has_parent_path() ? path.parent_path().string() : ".";
  return SurveyWithLook(folder, path.filename().string(), bytes_, format_, {PieceAreas::kYes, 0, no_faces});
}

// Has the file's faces name the vertices that stay. The new halves of faces come first: corners of STL are vertices,
// and lie where they lay only until they are changed.
absl::StatusOr<WeldRecord> FileMesh::Weld(double tolerance) {
  TILEMEND_ASSIGN_OR_RETURN(const FileFaces faces, ParseFaces(format_, bytes_, path_));
  const std::vector<Triangle>& before = faces.file.mesh.triangles;
  tilemend::Weld weld = WeldRims(faces.file.mesh, faces.face_of, tolerance, !faces.has_textures);
  const auto halves = weld.triangles.begin() + std::ssize(before);
  if (halves != weld.triangles.end()) {
    FilePatch patch;
    patch.triangles.assign(halves, weld.triangles.end());
    patch.cut_from = std::move(weld.cut_from);
    TILEMEND_RETURN_IF_ERROR(Append(patch));
  }
  std::vector<TriangleChange> changes;
  for (size_t t = 0; t < before.size(); ++t) {
    if (weld.triangles[t] != before[t]) changes.push_back({static_cast<int32_t>(t), before[t], weld.triangles[t]});
  }
  if (!changes.empty()) {
    TILEMEND_ASSIGN_OR_RETURN(bytes_, ChangeTriangles(format_, bytes_, changes, path_));
  }
  return std::move(weld.record);
}

absl::StatusOr<std::vector<int64_t>> FileMesh::Clear(std::span<const ClearArea> areas) {
  TILEMEND_ASSIGN_OR_RETURN(ClearedTile cleared, ClearTile(format_, bytes_, areas, path_));
  bytes_ = std::move(cleared.bytes);
  return std::move(cleared.triangles);
}

absl::Status FileMesh::Append(const FilePatch& patch) {
  TILEMEND_ASSIGN_OR_RETURN(bytes_, AppendPatch(format_, bytes_, patch, path_));
  return absl::OkStatus();
}

}  // namespace tilemend
