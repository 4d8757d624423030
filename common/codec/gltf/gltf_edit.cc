#include <Eigen/LU>
#include <algorithm>
#include <map>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/codec/gltf/gltf_builder.h"
#include "common/codec/gltf/gltf_container.h"
#include "common/codec/gltf/gltf_data.h"
#include "common/codec/gltf/gltf_file.h"
#include "common/codec/gltf/gltf_primitive.h"
#include "common/codec/gltf/gltf_scene.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

constexpr const char* kDracoExtension = "KHR_draco_mesh_compression";
constexpr const char* kUnlitExtension = "KHR_materials_unlit";

bool Mirrors(const GltfNode& node) { return node.matrix.topLeftCorner<3, 3>().determinant() < 0; }

// Whether two instances of one primitive lose the same triangles. Both have as many.
bool DropsSame(const GltfPrimitive& a, const GltfPrimitive& b, const std::vector<bool>& drop) {
  const auto begin = drop.begin();
  return std::equal(begin + a.first_triangle, begin + a.first_triangle + a.triangle_count, begin + b.first_triangle);
}

// The triangles of a primitive that stay, as its indices have them.
std::vector<Triangle> KeptTriangles(const GltfFile& file, const GltfPrimitive& primitive,
                                    const std::vector<bool>& drop) {
  const bool mirrors = Mirrors(file.nodes[static_cast<size_t>(primitive.node)]);
  std::vector<Triangle> kept;
  for (int32_t i = primitive.first_triangle; i < primitive.first_triangle + primitive.triangle_count; ++i) {
    if (drop[static_cast<size_t>(i)]) continue;
    Triangle triangle = file.triangles[static_cast<size_t>(i)];
    if (mirrors) std::swap(triangle[1], triangle[2]);
    for (int32_t& corner : triangle) corner -= primitive.first_vertex;
    kept.push_back(triangle);
  }
  return kept;
}

absl::Status CheckPatch(const GltfPatch& patch, const GltfFile& file, const std::string& name) {
  const auto error = [&name](const char* what) {
    return absl::InvalidArgumentError(absl::StrCat(name, ": the patch ", what));
  };
  if (patch.node < 0 || patch.node >= static_cast<int32_t>(file.nodes.size())) {
    return error("is for a node that the file does not have");
  }
  if (patch.points.empty() || patch.triangles.empty()) return error("is empty");
  if (patch.uv.size() != (patch.image.empty() ? 0 : patch.points.size())) {
    return error("has not as many texture coordinates as points");
  }
  const auto count = static_cast<int32_t>(patch.points.size());
  for (const Triangle& triangle : patch.triangles) {
    for (const int32_t corner : triangle) {
      if (corner < 0 || corner >= count) return error("has a triangle without such a point");
    }
  }
  return absl::OkStatus();
}

// The points in the frame of their node.
absl::StatusOr<std::vector<Eigen::Vector3f>> LocalPoints(const GltfPatch& patch, const GltfNode& node,
                                                         const std::string& name) {
  const Eigen::Matrix3d linear = node.matrix.topLeftCorner<3, 3>();
  const Eigen::FullPivLU<Eigen::Matrix3d> inverse(linear);
  if (!inverse.isInvertible()) {
    return absl::InvalidArgumentError(absl::StrCat(name, ": the matrix of node ", patch.node, " cannot be inverted"));
  }
  const Point3 offset = node.matrix.topRightCorner<3, 1>();
  std::vector<Eigen::Vector3f> points;
  for (const Point3& point : patch.points) {
    points.push_back(inverse.solve(point - offset).cast<float>());
    if (!points.back().allFinite()) {
      return absl::InvalidArgumentError(absl::StrCat(name, ": the patch has a point that is no finite float32"));
    }
  }
  return points;
}

class GltfEditor {
 public:
  // `file` is what was read from `container`.
  GltfEditor(const GltfContainer& container, const GltfFile& file, const std::string& name)
      : root_(container.json, name),
        data_(container, root_),
        file_(file),
        name_(name),
        json_(container.json),
        builder_(json_, (container.bin.size() + 3) / 4 * 4) {}

  absl::Status Apply(const GltfEdit& edit) {
    TILEMEND_RETURN_IF_ERROR(CheckGltfArrays(root_));
    TILEMEND_RETURN_IF_ERROR(CheckBuffer());
    TILEMEND_ASSIGN_OR_RETURN(instances_, GltfInstances(root_));
    // Patches first: the nodes that they refer to still have their meshes.
    for (const GltfPatch& patch : edit.patches) TILEMEND_RETURN_IF_ERROR(AddPatch(patch));
    if (!edit.drop.empty()) TILEMEND_RETURN_IF_ERROR(Drop(edit.drop));
    builder_.SetBufferLength();
    return absl::OkStatus();
  }

  const OrderedJson& json() const { return json_; }
  const std::string& added() const { return builder_.added(); }

 private:
  // The first buffer, if there is one, is the binary chunk.
  absl::Status CheckBuffer() const {
    TILEMEND_ASSIGN_OR_RETURN(const std::vector<JsonView> buffers, root_.Elements("buffers"));
    if (buffers.empty()) return absl::OkStatus();
    if (buffers[0].Find("uri") || !buffers[0].value().is_object()) {
      return buffers[0].Error("the first buffer is not the binary chunk");
    }
    return absl::OkStatus();
  }

  absl::StatusOr<GltfShading> ShadingOf(const GltfInstance& instance) const {
    TILEMEND_ASSIGN_OR_RETURN(const std::vector<JsonView> primitives, GltfPrimitivesOf(root_, instance.mesh));
    if (primitives.empty()) return GltfShading{};
    TILEMEND_ASSIGN_OR_RETURN(const int64_t index, GltfMaterialIndex(primitives[0]));
    if (index < 0) return GltfShading{};
    TILEMEND_ASSIGN_OR_RETURN(const JsonView materials, root_.Get("materials"));
    TILEMEND_ASSIGN_OR_RETURN(const JsonView material, materials.At(index));
    GltfShading shading;
    shading.is_unlit = material.Extension(kUnlitExtension).has_value();
    TILEMEND_ASSIGN_OR_RETURN(shading.is_double_sided, material.BoolOr("doubleSided", false));
    return shading;
  }

  absl::Status AddPatch(const GltfPatch& patch) {
    TILEMEND_RETURN_IF_ERROR(CheckPatch(patch, file_, name_));
    const auto index = static_cast<size_t>(patch.node);
    const GltfInstance& instance = instances_[index];
    TILEMEND_ASSIGN_OR_RETURN(const std::vector<Eigen::Vector3f> points, LocalPoints(patch, file_.nodes[index], name_));
    std::vector<Triangle> triangles = patch.triangles;
    if (Mirrors(file_.nodes[index])) {
      for (Triangle& triangle : triangles) std::swap(triangle[1], triangle[2]);
    }
    TILEMEND_ASSIGN_OR_RETURN(const GltfShading shading, ShadingOf(instance));
    if (shading.is_unlit) UseExtension(kUnlitExtension);
    OrderedJson node = {{"mesh", builder_.AddPatchMesh(patch, points, triangles, shading)}};
    for (const char* key : {"matrix", "translation", "rotation", "scale"}) {
      const OrderedJson& old = json_["nodes"][static_cast<size_t>(instance.node)];
      if (old.contains(key)) node[key] = old[key];
    }
    const int64_t added = builder_.Append("nodes", std::move(node));
    if (instance.parent >= 0) {
      json_["nodes"][static_cast<size_t>(instance.parent)]["children"].push_back(added);
    } else {
      TILEMEND_ASSIGN_OR_RETURN(const int64_t scene, GltfSceneIndex(root_));
      json_["scenes"][static_cast<size_t>(scene)]["nodes"].push_back(added);
    }
    return absl::OkStatus();
  }

  void UseExtension(const char* extension) {
    OrderedJson& used = json_["extensionsUsed"];
    if (std::ranges::find(used, OrderedJson(extension)) == used.end()) used.push_back(extension);
  }

  absl::Status Drop(const std::vector<bool>& drop) {
    if (drop.size() != file_.triangles.size()) {
      return absl::InvalidArgumentError(absl::StrCat(name_, ": triangles to drop: ", drop.size(), " entries for ",
                                                     file_.triangles.size(), " triangles"));
    }
    std::map<std::pair<int32_t, int32_t>, const GltfPrimitive*> first;
    for (const GltfPrimitive& primitive : file_.primitives) {
      const auto [it, is_new] = first.emplace(std::pair(primitive.mesh, primitive.primitive), &primitive);
      if (!is_new && !DropsSame(*it->second, primitive, drop)) {
        return absl::InvalidArgumentError(
            absl::StrCat(name_, ": two nodes share mesh ", primitive.mesh, ", but not what is dropped of it"));
      }
    }
    std::map<int32_t, std::vector<int32_t>> emptied;  // primitives without triangles, by mesh
    for (const auto& [key, primitive] : first) {
      std::vector<Triangle> kept = KeptTriangles(file_, *primitive, drop);
      if (kept.size() == static_cast<size_t>(primitive->triangle_count)) continue;
      if (kept.empty()) {
        emptied[key.first].push_back(key.second);
      } else {
        TILEMEND_RETURN_IF_ERROR(Rewrite(*primitive, kept));
      }
    }
    for (const auto& [mesh, primitives] : emptied) Remove(mesh, primitives);
    return absl::OkStatus();
  }

  // `primitives` ascend.
  void Remove(int32_t mesh, const std::vector<int32_t>& primitives) {
    OrderedJson& array = json_["meshes"][static_cast<size_t>(mesh)]["primitives"];
    if (array.size() == primitives.size()) {
      for (OrderedJson& node : json_["nodes"]) {
        if (node.contains("mesh") && node["mesh"] == mesh) node.erase("mesh");
      }
      return;
    }
    for (auto it = primitives.rbegin(); it != primitives.rend(); ++it) array.erase(static_cast<size_t>(*it));
  }

  absl::Status Rewrite(const GltfPrimitive& primitive, const std::vector<Triangle>& kept) {
    TILEMEND_ASSIGN_OR_RETURN(const std::vector<JsonView> views, GltfPrimitivesOf(root_, primitive.mesh));
    const auto index = static_cast<size_t>(primitive.primitive);
    OrderedJson& json = json_["meshes"][static_cast<size_t>(primitive.mesh)]["primitives"][index];
    if (primitive.is_draco) TILEMEND_RETURN_IF_ERROR(WritePlainly(views[index], json));
    json["indices"] = builder_.AddIndices(kept);
    return absl::OkStatus();
  }

  // Writes what a Draco stream holds into accessors of their own.
  absl::Status WritePlainly(const JsonView& view, OrderedJson& json) {
    constexpr int64_t kMaxIndex = INT64_C(1) << 31;
    TILEMEND_ASSIGN_OR_RETURN(const GltfPrimitiveData data, ReadGltfPrimitive(view, -1, data_));
    TILEMEND_ASSIGN_OR_RETURN(const JsonView accessors, root_.Get("accessors"));
    TILEMEND_ASSIGN_OR_RETURN(const JsonView attributes, view.Get("attributes"));
    const JsonView ids = *view.Extension(kDracoExtension)->Find("attributes");
    for (const auto& item : ids.value().items()) {
      if (!attributes.Find(item.key())) continue;
      TILEMEND_ASSIGN_OR_RETURN(const int64_t id, ids.Integer(item.key(), 0, kMaxIndex));
      TILEMEND_ASSIGN_OR_RETURN(const int64_t index, attributes.Integer(item.key(), 0, kMaxIndex));
      TILEMEND_ASSIGN_OR_RETURN(const JsonView accessor, accessors.At(index));
      TILEMEND_ASSIGN_OR_RETURN(const int64_t type, accessor.Integer("componentType", 5120, 5126));
      TILEMEND_ASSIGN_OR_RETURN(const std::string shape, accessor.TextOr("type", ""));
      const auto same = std::ranges::find_if(data.draco->attributes, [&](const GltfDracoAttribute& attribute) {
        return attribute.id == id && attribute.component_type == type &&
               attribute.components == static_cast<int64_t>(GltfComponents(shape));
      });
      if (same == data.draco->attributes.end()) return accessor.Error("the Draco stream has another type");
      const size_t size = static_cast<size_t>(same->components) * GltfComponentBytes(type);
      json["attributes"][item.key()] =
          builder_.AddCopy(accessor.value(), same->values, size, item.key() == "POSITION" && type == 5126);
    }
    json["extensions"].erase(kDracoExtension);
    if (json["extensions"].empty()) json.erase("extensions");
    return absl::OkStatus();
  }

  JsonView root_;
  GltfData data_;
  const GltfFile& file_;
  const std::string& name_;
  OrderedJson json_;
  GltfBuilder builder_;
  std::vector<GltfInstance> instances_;
};

}  // namespace

absl::StatusOr<std::string> ChangeGltf(std::string_view bytes, GltfUpAxis up, const GltfEdit& edit,
                                       const std::string& name) {
  TILEMEND_ASSIGN_OR_RETURN(const GltfFile file, ReadGltf(bytes, up, name));
  TILEMEND_ASSIGN_OR_RETURN(const GltfContainer container, ParseGltfContainer(bytes, name));
  GltfEditor editor(container, file, name);
  TILEMEND_RETURN_IF_ERROR(editor.Apply(edit));
  return WriteGltfContainer(container, editor.json(), editor.added(), name);
}

}  // namespace tilemend
