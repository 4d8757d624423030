// A mesh in arrays while its holes are filled: the same result as of a binary PLY file with the same numbers.
#ifndef TILEMEND_CLIENT_MESH_ARRAY_MESH_H_
#define TILEMEND_CLIENT_MESH_ARRAY_MESH_H_

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "client/mesh/edited_mesh.h"
#include "common/mesh/rounding.h"
#include "common/mesh/tri_mesh.h"

namespace tilemend {

// Three numbers a vertex and three indices a face, one after the other.
using VertexNumbers = std::variant<std::span<const float>, std::span<const double>>;
using FaceNumbers = std::variant<std::span<const int32_t>, std::span<const int64_t>, std::span<const uint32_t>,
                                 std::span<const uint64_t>>;

class ArrayMesh : public EditedMesh {
 public:
  // Copies both. Errors are kInvalidArgument and name the array, the row and what was expected. They are: no vertices,
  // a coordinate that is not finite or beyond 1e9, an index out of range, more rows than int32_t counts. Precondition:
  // the lengths are multiples of 3. Cost: linear.
  static absl::StatusOr<ArrayMesh> Make(const VertexNumbers& vertices, const FaceNumbers& faces);

  const std::string& name() const override { return name_; }
  absl::StatusOr<TriMesh> Mesh() const override { return mesh_; }
  absl::StatusOr<LookSurvey> Survey(NoFaces no_faces) const override;
  absl::StatusOr<WeldRecord> Weld(double tolerance) override;
  absl::StatusOr<std::vector<int64_t>> Clear(std::span<const ClearArea> areas) override;
  absl::Status Append(const FilePatch& patch) override;

  const TriMesh& mesh() const { return mesh_; }
  // The same without a copy; nothing else may be called after it.
  TriMesh TakeMesh() && { return std::move(mesh_); }
  // The triangles behind this one are new.
  size_t originals() const { return originals_; }

 private:
  ArrayMesh(TriMesh mesh, NumberType number_type)
      : mesh_(std::move(mesh)), number_type_(number_type), originals_(mesh_.triangles.size()) {}

  std::string name_ = "mesh";
  TriMesh mesh_;
  NumberType number_type_;
  size_t originals_;  // triangles that came from the caller, without those taken out
};

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_MESH_ARRAY_MESH_H_
