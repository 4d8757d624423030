// A mesh file while its holes are filled. Keeps every original byte that no edit changes.
#ifndef TILEMEND_CLIENT_MESH_FILE_MESH_H_
#define TILEMEND_CLIENT_MESH_FILE_MESH_H_

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "client/mesh/edited_mesh.h"

namespace tilemend {

class FileMesh : public EditedMesh {
 public:
  // Reads the file. Errors of MeshFormatOf and ReadFile; the content is parsed by the other calls.
  static absl::StatusOr<FileMesh> Open(const std::string& path);

  const std::string& name() const override { return path_; }
  absl::StatusOr<HeldMesh> Mesh() const override;
  absl::StatusOr<LookSurvey> Survey(NoFaces no_faces) const override;
  absl::StatusOr<WeldRecord> Weld(double tolerance) override;
  absl::StatusOr<std::vector<int64_t>> Clear(std::span<const ClearArea> areas) override;
  absl::Status Append(const FilePatch& patch) override;

  MeshFormat format() const { return format_; }
  std::string TakeBytes() { return std::move(bytes_); }

 private:
  FileMesh(std::string path, MeshFormat format, std::string bytes)
      : path_(std::move(path)), format_(format), bytes_(std::move(bytes)) {}

  std::string path_;
  MeshFormat format_;
  std::string bytes_;
};

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_MESH_FILE_MESH_H_
