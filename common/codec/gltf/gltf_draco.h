// Draco streams of KHR_draco_mesh_compression, decoded within limits.
//
// Draco trusts its input: 61 bytes can make its decoder allocate 20 GB (google/draco#1169). Two guards stand before it.
// The counts in the stream's header are held against limits and against the length of the stream. The sizes of the
// attributes are checked when Draco has read their headers and has not yet made room for them.
#ifndef TILEMEND_COMMON_CODEC_GLTF_GLTF_DRACO_H_
#define TILEMEND_COMMON_CODEC_GLTF_GLTF_DRACO_H_

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"

namespace tilemend {

struct GltfDracoAttribute {
  uint32_t id = 0;             // what the glTF calls it by
  int64_t component_type = 0;  // of glTF, such as 5126 for float32
  int64_t components = 0;
  std::string values;  // one per point, tightly packed
};

struct GltfDracoMesh {
  int64_t points = 0;
  std::vector<std::array<uint32_t, 3>> faces;  // indices below `points`
  std::vector<GltfDracoAttribute> attributes;  // those with a component type of glTF
};

struct GltfDracoLimits {
  int64_t max_points = 4'000'000;
  int64_t max_faces = 8'000'000;
};

// Reads version 2.2, sequential or edgebreaker, without metadata. Returns kInvalidArgument for other streams. Returns
// kResourceExhausted beyond the limits, 64 faces or points for each byte of the stream, or 256 bytes for each point.
// Takes at most about 1 kB of memory for each byte of the stream. Does not throw.
absl::StatusOr<GltfDracoMesh> DecodeGltfDraco(std::string_view stream, const GltfDracoLimits& limits = {});

}  // namespace tilemend

#endif  // TILEMEND_COMMON_CODEC_GLTF_GLTF_DRACO_H_
