#include "common/codec/gltf/gltf_file.h"

#include <Eigen/LU>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/codec/gltf/gltf_container.h"
#include "common/codec/gltf/gltf_data.h"
#include "common/codec/gltf/gltf_primitive.h"
#include "common/codec/gltf/gltf_scene.h"
#include "common/util/status_macros.h"
#include "common/util/text.h"

namespace tilemend {
namespace {

constexpr int64_t kMaxViews = INT64_C(1) << 31;

class GltfReader {
 public:
  GltfReader(const GltfContainer& container, GltfUpAxis up, const std::string& name, const GltfLimits& limits)
      : root_(container.json, name), data_(container, root_), to_z_up_(GltfToZUp(up)), name_(name), limits_(limits) {
    file_.is_b3dm = container.is_b3dm;
    file_.origin = container.origin;
  }

  absl::StatusOr<GltfFile> Read() && {
    TILEMEND_RETURN_IF_ERROR(CheckGltfExtensions(root_));
    TILEMEND_ASSIGN_OR_RETURN(const Point3 center, GltfRtcCenter(root_));
    file_.origin += center;
    TILEMEND_RETURN_IF_ERROR(ReadImages());
    TILEMEND_ASSIGN_OR_RETURN(const std::vector<GltfInstance> instances, GltfInstances(root_));
    for (const GltfInstance& instance : instances) {
      file_.nodes.push_back({.name = instance.name, .matrix = to_z_up_ * instance.matrix, .number = instance.node});
      TILEMEND_ASSIGN_OR_RETURN(const std::vector<JsonView> primitives, GltfPrimitivesOf(root_, instance.mesh));
      for (size_t i = 0; i < primitives.size(); ++i) {
        TILEMEND_RETURN_IF_ERROR(ReadPrimitive(primitives[i], instance.mesh, static_cast<int32_t>(i)));
      }
    }
    return std::move(file_);
  }

 private:
  absl::Status ReadImages() {
    TILEMEND_ASSIGN_OR_RETURN(const std::vector<JsonView> images, root_.Elements("images"));
    for (const JsonView& view : images) {
      GltfImage image;
      TILEMEND_ASSIGN_OR_RETURN(image.mime_type, view.TextOr("mimeType", ""));
      TILEMEND_ASSIGN_OR_RETURN(const std::string uri, view.TextOr("uri", ""));
      TILEMEND_ASSIGN_OR_RETURN(image.name, view.TextOr("name", Shortened(uri, 200)));
      if (view.Find("bufferView")) {
        TILEMEND_ASSIGN_OR_RETURN(const int64_t index, view.Integer("bufferView", 0, kMaxViews));
        TILEMEND_ASSIGN_OR_RETURN(const GltfBytes bytes, data_.View(index));
        if (bytes.is_compressed) return view.Error("the image lies in a compressed view");
        image.offset = bytes.offset;
        image.size = bytes.bytes.size();
      }
      file_.images.push_back(std::move(image));
    }
    return absl::OkStatus();
  }

  absl::Status ReadPrimitive(const JsonView& view, int64_t mesh, int32_t index) {
    TILEMEND_ASSIGN_OR_RETURN(const int64_t material_index, GltfMaterialIndex(view));
    TILEMEND_ASSIGN_OR_RETURN(const GltfMaterial material, GltfMaterialOf(root_, material_index));
    TILEMEND_ASSIGN_OR_RETURN(const GltfPrimitiveData data, ReadGltfPrimitive(view, material.texture_set, data_));
    const auto points = static_cast<int64_t>(data.positions.count);
    const auto triangles = static_cast<int64_t>(data.triangles.size());
    if (points > limits_.max_points - static_cast<int64_t>(file_.points.size()) ||
        triangles > limits_.max_triangles - static_cast<int64_t>(file_.triangles.size())) {
      return absl::ResourceExhaustedError(absl::StrCat(name_, ": JSON ", view.path(), ": more than ",
                                                       limits_.max_points, " points or ", limits_.max_triangles,
                                                       " triangles in the file"));
    }
    GltfPrimitive primitive;
    primitive.first_vertex = static_cast<int32_t>(file_.points.size());
    primitive.vertex_count = static_cast<int32_t>(points);
    primitive.first_triangle = static_cast<int32_t>(file_.triangles.size());
    primitive.triangle_count = static_cast<int32_t>(triangles);
    primitive.material = static_cast<int32_t>(material_index);
    primitive.texture = static_cast<int32_t>(material.image);
    primitive.node = static_cast<int32_t>(file_.nodes.size()) - 1;
    primitive.mesh = static_cast<int32_t>(mesh);
    primitive.primitive = index;
    primitive.is_draco = data.draco != nullptr;
    primitive.base_colour = material.base_colour;
    primitive.has_base_colour = material.has_base_colour;
    file_.primitives.push_back(primitive);
    AddTriangles(data, primitive.first_vertex);
    AddUv(data, material);
    return AddPoints(data.positions, view);
  }

  absl::Status AddPoints(const GltfValues& positions, const JsonView& view) {
    const Eigen::Matrix4d& matrix = file_.nodes.back().matrix;
    const Eigen::Matrix3d linear = matrix.topLeftCorner<3, 3>();
    const Point3 offset = matrix.topRightCorner<3, 1>();
    for (size_t i = 0; i < positions.count; ++i) {
      const Point3 point = linear * Point3(positions.At(i, 0), positions.At(i, 1), positions.At(i, 2)) + offset;
      if (!point.allFinite()) return view.Error(absl::StrCat("vertex ", i, " is not finite"));
      file_.points.push_back(point);
    }
    return absl::OkStatus();
  }

  void AddUv(const GltfPrimitiveData& data, const GltfMaterial& material) {
    for (size_t i = 0; i < data.positions.count; ++i) {
      std::array<float, 2> uv = {0, 0};
      if (data.uv) {
        const Point2 at = material.uv_transform * Point3(data.uv->At(i, 0), data.uv->At(i, 1), 1);
        uv = {static_cast<float>(at[0]), static_cast<float>(1 - at[1])};
      }
      file_.uv.push_back(uv);
    }
  }

  // A matrix that mirrors turns the triangles round.
  void AddTriangles(const GltfPrimitiveData& data, int32_t first_vertex) {
    const bool mirrors = file_.nodes.back().matrix.topLeftCorner<3, 3>().determinant() < 0;
    for (Triangle triangle : data.triangles) {
      if (mirrors) std::swap(triangle[1], triangle[2]);
      for (int32_t& corner : triangle) corner += first_vertex;
      file_.triangles.push_back(triangle);
    }
  }

  JsonView root_;
  GltfData data_;
  Eigen::Matrix4d to_z_up_;
  const std::string& name_;
  GltfLimits limits_;
  GltfFile file_;
};

}  // namespace

absl::StatusOr<GltfFile> ReadGltf(std::string_view bytes, GltfUpAxis up, const std::string& name,
                                  const GltfLimits& limits) {
  TILEMEND_ASSIGN_OR_RETURN(const GltfContainer container, ParseGltfContainer(bytes, name));
  return GltfReader(container, up, name, limits).Read();
}

}  // namespace tilemend
