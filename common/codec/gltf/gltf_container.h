// The containers of a glTF file: the chunks of a glb, and the header of a b3dm around it.
#ifndef TILEMEND_COMMON_CODEC_GLTF_GLTF_CONTAINER_H_
#define TILEMEND_COMMON_CODEC_GLTF_GLTF_CONTAINER_H_

#include <cstddef>
#include <string>
#include <string_view>

#include "absl/status/statusor.h"
#include "common/codec/gltf/json_view.h"
#include "common/mesh/tri_mesh.h"

namespace tilemend {

// The views are of the bytes that were parsed.
struct GltfContainer {
  bool is_b3dm = false;
  std::string_view head;           // of a b3dm: header, feature table and batch table
  OrderedJson json;                // an object
  bool has_bin = false;            // the glb has a binary chunk
  size_t bin_offset = 0;           // of its content in the file
  std::string_view bin;            // its content with padding
  std::string_view trailing;       // chunks behind it
  Point3 origin = Point3::Zero();  // RTC_CENTER of the feature table
};

// kInvalidArgument with `name` and byte offset for malformed input and for glTF 1.0. The JSON chunk may have 32 MiB.
absl::StatusOr<GltfContainer> ParseGltfContainer(std::string_view bytes, const std::string& name);

// The file with another JSON, and with `added` behind the binary chunk, at a multiple of 4. kInvalidArgument if it
// would be over 4 GiB.
absl::StatusOr<std::string> WriteGltfContainer(const GltfContainer& container, const OrderedJson& json,
                                               std::string_view added, const std::string& name);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_CODEC_GLTF_GLTF_CONTAINER_H_
