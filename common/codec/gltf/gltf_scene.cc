#include "common/codec/gltf/gltf_scene.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>

#include "absl/strings/str_cat.h"
#include "common/util/status_macros.h"
#include "common/util/text.h"

namespace tilemend {
namespace {

constexpr int64_t kMaxIndex = INT64_C(1) << 31;
constexpr int kMaxNodeDepth = 64;

// Extensions that are read, or that say nothing about the geometry. So do all KHR_materials_*.
constexpr const char* kReadExtensions[] = {
    "CESIUM_RTC",         "CESIUM_primitive_outline",   "EXT_feature_metadata",
    "EXT_mesh_features",  "EXT_meshopt_compression",    "EXT_structural_metadata",
    "EXT_texture_webp",   "KHR_draco_mesh_compression", "KHR_mesh_quantization",
    "KHR_texture_basisu", "KHR_texture_transform"};

absl::StatusOr<Eigen::Matrix4d> LocalMatrix(const JsonView& node) {
  if (const std::optional<JsonView> matrix = node.Find("matrix")) {
    TILEMEND_ASSIGN_OR_RETURN(const std::vector<double> numbers, matrix->AsNumbers(16));
    return Eigen::Matrix4d(numbers.data());  // both store columns
  }
  TILEMEND_ASSIGN_OR_RETURN(const std::vector<double> t, node.NumbersOr("translation", {0, 0, 0}));
  TILEMEND_ASSIGN_OR_RETURN(const std::vector<double> r, node.NumbersOr("rotation", {0, 0, 0, 1}));
  TILEMEND_ASSIGN_OR_RETURN(const std::vector<double> s, node.NumbersOr("scale", {1, 1, 1}));
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix.topLeftCorner<3, 3>() =
      Eigen::Quaterniond(r[3], r[0], r[1], r[2]).toRotationMatrix() * Eigen::Vector3d(s[0], s[1], s[2]).asDiagonal();
  matrix.topRightCorner<3, 1>() = Eigen::Vector3d(t[0], t[1], t[2]);
  return matrix;
}

class SceneWalk {
 public:
  explicit SceneWalk(const JsonView& nodes) : nodes_(nodes), is_seen_(nodes.value().size()) {}

  absl::Status Visit(const JsonView& index, int64_t parent, const Eigen::Matrix4d& above, int depth) {
    TILEMEND_ASSIGN_OR_RETURN(const int64_t i, index.AsInteger(0, kMaxIndex));
    TILEMEND_ASSIGN_OR_RETURN(const JsonView node, nodes_.At(i));
    if (is_seen_[static_cast<size_t>(i)]) return node.Error("the scene reaches this node twice");
    if (depth > kMaxNodeDepth) return node.Error("nodes are nested deeper than 64 levels");
    is_seen_[static_cast<size_t>(i)] = true;
    if (node.Find("skin")) return node.Error("skins are not read");
    if (node.Extension("EXT_mesh_gpu_instancing")) return node.Error("EXT_mesh_gpu_instancing is not read");
    TILEMEND_ASSIGN_OR_RETURN(const Eigen::Matrix4d local, LocalMatrix(node));
    const Eigen::Matrix4d matrix = above * local;
    if (!matrix.allFinite()) return node.Error("the matrix is not finite");
    if (node.Find("mesh")) {
      GltfInstance instance{.node = i, .parent = parent, .mesh = 0, .name = "", .matrix = matrix};
      TILEMEND_ASSIGN_OR_RETURN(instance.mesh, node.Integer("mesh", 0, kMaxIndex));
      TILEMEND_ASSIGN_OR_RETURN(instance.name, node.TextOr("name", ""));
      instances_.push_back(std::move(instance));
    }
    TILEMEND_ASSIGN_OR_RETURN(const std::vector<JsonView> children, node.Elements("children"));
    for (const JsonView& child : children) TILEMEND_RETURN_IF_ERROR(Visit(child, i, matrix, depth + 1));
    return absl::OkStatus();
  }

  std::vector<GltfInstance> TakeInstances() { return std::move(instances_); }

 private:
  JsonView nodes_;
  std::vector<bool> is_seen_;
  std::vector<GltfInstance> instances_;
};

// The image of a texture.
absl::StatusOr<int64_t> ImageOf(const JsonView& root, int64_t texture_index) {
  TILEMEND_ASSIGN_OR_RETURN(const JsonView textures, root.Get("textures"));
  TILEMEND_ASSIGN_OR_RETURN(const JsonView texture, textures.At(texture_index));
  std::optional<JsonView> source = texture.Find("source");
  for (const char* extension : {"EXT_texture_webp", "KHR_texture_basisu"}) {
    const std::optional<JsonView> other = texture.Extension(extension);
    if (!source && other) source = other->Find("source");
  }
  if (!source) return -1;
  TILEMEND_ASSIGN_OR_RETURN(const int64_t image, source->AsInteger(0, kMaxIndex));
  TILEMEND_ASSIGN_OR_RETURN(const JsonView images, root.Get("images"));
  TILEMEND_RETURN_IF_ERROR(images.At(image).status());
  return image;
}

// KHR_texture_transform: scale, then rotation, then offset.
absl::Status ReadTransform(const JsonView& transform, GltfMaterial& material) {
  TILEMEND_ASSIGN_OR_RETURN(const std::vector<double> offset, transform.NumbersOr("offset", {0, 0}));
  TILEMEND_ASSIGN_OR_RETURN(const std::vector<double> scale, transform.NumbersOr("scale", {1, 1}));
  double angle_rad = 0;
  if (const std::optional<JsonView> rotation = transform.Find("rotation")) {
    TILEMEND_ASSIGN_OR_RETURN(angle_rad, rotation->AsNumber());
  }
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  material.uv_transform << c * scale[0], s * scale[1], offset[0],  //
      -s * scale[0], c * scale[1], offset[1];
  TILEMEND_ASSIGN_OR_RETURN(material.texture_set, transform.IntegerOr("texCoord", 0, kMaxIndex, material.texture_set));
  return absl::OkStatus();
}

}  // namespace

Eigen::Matrix4d GltfToZUp(GltfUpAxis up) {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  if (up == GltfUpAxis::kY) matrix.topLeftCorner<3, 3>() << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  if (up == GltfUpAxis::kX) matrix.topLeftCorner<3, 3>() << 0, 0, -1, 0, 1, 0, 1, 0, 0;
  return matrix;
}

absl::Status CheckGltfExtensions(const JsonView& root) {
  TILEMEND_ASSIGN_OR_RETURN(const std::vector<JsonView> required, root.Elements("extensionsRequired"));
  for (const JsonView& element : required) {
    TILEMEND_ASSIGN_OR_RETURN(const std::string extension, element.AsText());
    const bool is_read =
        extension.starts_with("KHR_materials_") ||
        std::find(std::begin(kReadExtensions), std::end(kReadExtensions), extension) != std::end(kReadExtensions);
    if (!is_read) {
      return element.Error(
          absl::StrCat("the file requires the extension ", Printable(Shortened(extension, 80)), ", which is not read"));
    }
  }
  if (const std::optional<JsonView> animations = root.Find("animations")) {
    if (!animations->value().empty()) return animations->Error("animations are not read");
  }
  return absl::OkStatus();
}

absl::StatusOr<Point3> GltfRtcCenter(const JsonView& root) {
  const std::optional<JsonView> rtc = root.Extension("CESIUM_RTC");
  if (!rtc) return Point3(0, 0, 0);
  TILEMEND_ASSIGN_OR_RETURN(const std::vector<double> center, rtc->NumbersOr("center", {0, 0, 0}));
  return Point3(center[0], center[1], center[2]);
}

absl::StatusOr<int64_t> GltfSceneIndex(const JsonView& root) { return root.IntegerOr("scene", 0, kMaxIndex, 0); }

absl::StatusOr<std::vector<GltfInstance>> GltfInstances(const JsonView& root) {
  TILEMEND_ASSIGN_OR_RETURN(const int64_t index, GltfSceneIndex(root));
  TILEMEND_ASSIGN_OR_RETURN(const JsonView scenes, root.Get("scenes"));
  TILEMEND_ASSIGN_OR_RETURN(const JsonView scene, scenes.At(index));
  TILEMEND_ASSIGN_OR_RETURN(const std::vector<JsonView> roots, scene.Elements("nodes"));
  if (roots.empty()) return std::vector<GltfInstance>();
  TILEMEND_ASSIGN_OR_RETURN(const JsonView nodes, root.Get("nodes"));
  SceneWalk walk(nodes);
  for (const JsonView& node : roots) {
    TILEMEND_RETURN_IF_ERROR(walk.Visit(node, -1, Eigen::Matrix4d::Identity(), 1));
  }
  return walk.TakeInstances();
}

absl::StatusOr<GltfMaterial> GltfMaterialOf(const JsonView& root, int64_t index) {
  GltfMaterial result;
  if (index < 0) return result;
  TILEMEND_ASSIGN_OR_RETURN(const JsonView materials, root.Get("materials"));
  TILEMEND_ASSIGN_OR_RETURN(const JsonView material, materials.At(index));
  const std::optional<JsonView> pbr = material.Find("pbrMetallicRoughness");
  if (!pbr) return result;
  TILEMEND_ASSIGN_OR_RETURN(const std::vector<double> colour, pbr->NumbersOr("baseColorFactor", {1, 1, 1, 1}));
  std::copy(colour.begin(), colour.end(), result.base_colour.begin());
  result.has_base_colour = pbr->Find("baseColorFactor").has_value();
  const std::optional<JsonView> texture = pbr->Find("baseColorTexture");
  if (!texture) return result;
  TILEMEND_ASSIGN_OR_RETURN(const int64_t texture_index, texture->Integer("index", 0, kMaxIndex));
  TILEMEND_ASSIGN_OR_RETURN(result.image, ImageOf(root, texture_index));
  TILEMEND_ASSIGN_OR_RETURN(result.texture_set, texture->IntegerOr("texCoord", 0, kMaxIndex, 0));
  if (const std::optional<JsonView> transform = texture->Extension("KHR_texture_transform")) {
    TILEMEND_RETURN_IF_ERROR(ReadTransform(*transform, result));
  }
  return result;
}

}  // namespace tilemend
