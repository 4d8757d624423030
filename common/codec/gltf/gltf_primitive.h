// The triangles of one primitive, with its compression undone.
#ifndef TILEMEND_COMMON_CODEC_GLTF_GLTF_PRIMITIVE_H_
#define TILEMEND_COMMON_CODEC_GLTF_GLTF_PRIMITIVE_H_

#include <cstdint>
#include <optional>
#include <vector>

#include "absl/status/statusor.h"
#include "common/codec/gltf/gltf_data.h"
#include "common/codec/gltf/json_view.h"
#include "common/mesh/tri_mesh.h"

namespace tilemend {

struct GltfPrimitiveData {
  GltfValues positions;             // three components
  std::optional<GltfValues> uv;     // two components, as many as positions
  std::vector<Triangle> triangles;  // indices into positions
  int64_t material = -1;
  const GltfDracoMesh* draco = nullptr;  // of a compressed one; `positions` and `uv` lie in it
};

// The elements of the array `primitives` of a mesh.
absl::StatusOr<std::vector<JsonView>> GltfPrimitivesOf(const JsonView& root, int64_t mesh);

// Reads a primitive of triangles; other modes and morph targets are refused. `uv` is TEXCOORD_n with n = `texture_set`.
// Errors of GltfData.
absl::StatusOr<GltfPrimitiveData> ReadGltfPrimitive(const JsonView& primitive, int64_t texture_set, GltfData& data);

// The index of the primitive's material; -1: none.
absl::StatusOr<int64_t> GltfMaterialIndex(const JsonView& primitive);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_CODEC_GLTF_GLTF_PRIMITIVE_H_
