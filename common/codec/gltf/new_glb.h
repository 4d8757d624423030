// New glb files.
#ifndef TILEMEND_COMMON_CODEC_GLTF_NEW_GLB_H_
#define TILEMEND_COMMON_CODEC_GLTF_NEW_GLB_H_

#include <span>
#include <string>

#include "absl/status/statusor.h"
#include "common/codec/gltf/gltf_file.h"

namespace tilemend {

// A glb with one mesh for each of `surfaces`, unlit, since photographs have their light in them. Points are in metres,
// z up, and are written as float32; a node turns them to y up. The `node` of a patch is not used. Returns
// kInvalidArgument with `name` for a surface without triangles, and for a file over 4 GiB. Linear.
absl::StatusOr<std::string> NewGlb(std::span<const GltfPatch> surfaces, const std::string& name);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_CODEC_GLTF_NEW_GLB_H_
