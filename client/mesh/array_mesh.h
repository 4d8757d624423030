// A mesh in arrays while its holes are filled: the same result as of a binary PLY file with the same numbers.
#ifndef TILEMEND_CLIENT_MESH_ARRAY_MESH_H_
#define TILEMEND_CLIENT_MESH_ARRAY_MESH_H_

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "client/mesh/edited_mesh.h"
#include "common/mesh/mesh_view.h"

namespace tilemend {

// Three numbers a vertex and three indices a face, one after the other.
using VertexNumbers = std::variant<std::span<const float>, std::span<const double>>;
using FaceNumbers = std::variant<std::span<const int32_t>, std::span<const int64_t>, std::span<const uint32_t>,
                                 std::span<const uint64_t>>;

// Rows of three numbers, one after the other.
struct FilledArrays {
  std::variant<std::vector<float>, std::vector<double>> vertices;  // in the type of those that came in
  std::vector<int32_t> faces;
  size_t originals = 0;  // faces that came in, without those taken out; those behind are new
};

// Reads the numbers where they lie, whatever their type, and copies none before Filled.
class ArrayMesh : public EditedMesh {
 public:
  // Both outlive the mesh, and nobody changes them meanwhile. Errors are kInvalidArgument and name the array, the row
  // and what was expected. They are: no vertices, a coordinate that is not finite or beyond 1e9, an index out of range,
  // more rows than int32_t counts. Precondition: the lengths are multiples of 3. Cost: linear, without memory.
  static absl::StatusOr<ArrayMesh> Make(const VertexNumbers& vertices, const FaceNumbers& faces);

  const std::string& name() const override { return name_; }
  absl::StatusOr<HeldMesh> Mesh() const override { return HeldMesh{nullptr, View()}; }
  absl::StatusOr<LookSurvey> Survey(NoFaces no_faces) const override;
  absl::StatusOr<WeldRecord> Weld(double tolerance) override;
  absl::StatusOr<std::vector<int64_t>> Clear(std::span<const ClearArea> areas) override;
  absl::Status Append(const FilePatch& patch) override;

  // The whole mesh in arrays of its own. Cost: linear.
  FilledArrays Filled() const;

 private:
  explicit ArrayMesh(const MeshView& given) : given_(given), originals_(given.triangles.size()) {}

  // The mesh without what was appended.
  MeshView View() const;

  std::string name_ = "mesh";
  MeshView given_;
  std::optional<std::vector<Triangle>> edited_;  // in place of the given triangles, once an edit changed them
  size_t originals_;
  std::vector<Point3> new_points_;
  std::vector<Triangle> new_triangles_;
};

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_MESH_ARRAY_MESH_H_
