// Nodes, materials and images of a glTF document.
#ifndef TILEMEND_COMMON_CODEC_GLTF_GLTF_SCENE_H_
#define TILEMEND_COMMON_CODEC_GLTF_GLTF_SCENE_H_

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/codec/gltf/gltf_file.h"
#include "common/codec/gltf/json_view.h"

namespace tilemend {

// A node of the scene that has a mesh.
struct GltfInstance {
  int64_t node = 0;
  int64_t parent = -1;  // -1: the node is a root of the scene
  int64_t mesh = 0;
  std::string name;
  Eigen::Matrix4d matrix;  // from the mesh to the frame of the glTF
};

// The base colour of a material.
struct GltfMaterial {
  int64_t image = -1;
  int64_t texture_set = 0;  // n of TEXCOORD_n
  Eigen::Matrix<double, 2, 3> uv_transform = Eigen::Matrix<double, 2, 3>::Identity();
  std::array<double, 4> base_colour = {1, 1, 1, 1};
  bool has_base_colour = false;  // the file says it
};

// From the frame of the glTF to one with z up.
Eigen::Matrix4d GltfToZUp(GltfUpAxis up);

// Refuses required extensions that are not read, by name. All errors here are those of JsonView.
absl::Status CheckGltfExtensions(const JsonView& root);

// The translation CESIUM_RTC, else zero.
absl::StatusOr<Point3> GltfRtcCenter(const JsonView& root);

// The index of the scene that is shown.
absl::StatusOr<int64_t> GltfSceneIndex(const JsonView& root);

// In the order of a walk down from the scene's roots. An error if a node is reached twice, or is deeper than 64 levels.
absl::StatusOr<std::vector<GltfInstance>> GltfInstances(const JsonView& root);

// The material of that index; -1: the default one. An image that viewers of any kind show is taken before a WebP or
// KTX2 of the same texture.
absl::StatusOr<GltfMaterial> GltfMaterialOf(const JsonView& root, int64_t index);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_CODEC_GLTF_GLTF_SCENE_H_
