// Additions to a glTF document: buffer views, accessors and whole patches.
#ifndef TILEMEND_COMMON_CODEC_GLTF_GLTF_BUILDER_H_
#define TILEMEND_COMMON_CODEC_GLTF_GLTF_BUILDER_H_

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/codec/gltf/gltf_file.h"
#include "common/codec/gltf/json_view.h"
#include "common/mesh/tri_mesh.h"

namespace tilemend {

// How the material of a patch looks beside those around it.
struct GltfShading {
  bool is_unlit = false;
  bool is_double_sided = false;
};

// Appends to the arrays of a document; what is there keeps its index. Nothing is checked twice: arrays that exist must
// be arrays (CheckArrays).
class GltfBuilder {
 public:
  // `bin_bytes`: of the binary chunk so far, padded to a multiple of 4.
  GltfBuilder(OrderedJson& json, size_t bin_bytes) : json_(json), bin_bytes_(bin_bytes) {}

  // The bytes to append to the binary chunk.
  const std::string& added() const { return added_; }

  // The index of a new view of `bytes`. `target`: 34962 vertices, 34963 indices, 0 neither. `stride`: bytes from one
  // vertex to the next, 0: packed.
  int64_t AddView(std::string_view bytes, int64_t target, size_t stride = 0);

  // The index of a new accessor of triangles, as uint16 if the indices allow it, else uint32.
  int64_t AddIndices(std::span<const Triangle> triangles);

  // The index of a new accessor of float32 positions, with bounds.
  int64_t AddPositions(std::span<const Eigen::Vector3f> points);

  // The index of a copy of an accessor for `values`, which take the place of those it refers to: elements of `size`
  // bytes, packed. New bounds if they are float32 positions.
  int64_t AddCopy(const OrderedJson& accessor, std::string_view values, size_t size, bool is_float_position);

  // The index of a new mesh for `patch`, whose points in the frame of its node are `points`.
  int64_t AddPatchMesh(const GltfPatch& patch, std::span<const Eigen::Vector3f> points,
                       std::span<const Triangle> triangles, const GltfShading& shading);

  // Appends to an array of the document, and returns the index of the new element.
  int64_t Append(const char* array, OrderedJson element);

  // The length of the buffer, for when all is added.
  void SetBufferLength();

 private:
  int64_t AddMaterial(const GltfPatch& patch, const GltfShading& shading);
  int64_t AddTexture(const GltfPatch& patch);

  OrderedJson& json_;
  size_t bin_bytes_;
  std::string added_;
};

// An error of JsonView if an array that GltfBuilder appends to exists as something else.
absl::Status CheckGltfArrays(const JsonView& root);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_CODEC_GLTF_GLTF_BUILDER_H_
