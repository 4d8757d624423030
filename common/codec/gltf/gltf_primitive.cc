#include "common/codec/gltf/gltf_primitive.h"

#include <string>

#include "absl/strings/str_cat.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

constexpr int64_t kMaxElements = INT64_C(1) << 31;
constexpr int64_t kTrianglesMode = 4;

// The attribute `name` of a compressed primitive; none if the primitive or the stream has none.
absl::StatusOr<std::optional<GltfValues>> DracoValues(const JsonView& primitive, const JsonView& extension,
                                                      const std::string& name, const GltfDracoMesh& mesh) {
  TILEMEND_ASSIGN_OR_RETURN(const JsonView listed, primitive.Get("attributes"));
  TILEMEND_ASSIGN_OR_RETURN(const JsonView attributes, extension.Get("attributes"));
  const std::optional<JsonView> id = attributes.Find(name);
  if (!id || !listed.Find(name)) return std::nullopt;
  TILEMEND_ASSIGN_OR_RETURN(const int64_t unique_id, id->AsInteger(0, kMaxElements));
  for (const GltfDracoAttribute& attribute : mesh.attributes) {
    if (attribute.id != unique_id) continue;
    GltfValues values;
    values.bytes = attribute.values;
    values.component_type = attribute.component_type;
    values.components = static_cast<size_t>(attribute.components);
    values.stride = values.components * GltfComponentBytes(attribute.component_type);
    values.count = static_cast<size_t>(mesh.points);
    return values;
  }
  return id->Error("the Draco stream has no such attribute");
}

// The attribute `name`; none if the primitive has none.
absl::StatusOr<std::optional<GltfValues>> Attribute(const JsonView& primitive, const std::string& name,
                                                    GltfData& data) {
  TILEMEND_ASSIGN_OR_RETURN(const JsonView attributes, primitive.Get("attributes"));
  const std::optional<JsonView> accessor = attributes.Find(name);
  if (!accessor) return std::nullopt;
  TILEMEND_ASSIGN_OR_RETURN(const int64_t index, accessor->AsInteger(0, kMaxElements));
  TILEMEND_ASSIGN_OR_RETURN(const GltfValues values, data.Accessor(index));
  return values;
}

// Whether the values of a compressed attribute are normalized stands in its accessor alone.
absl::Status SetNormalized(const JsonView& root, const JsonView& primitive, const std::string& name,
                           std::optional<GltfValues>& values) {
  TILEMEND_ASSIGN_OR_RETURN(const JsonView attributes, primitive.Get("attributes"));
  const std::optional<JsonView> index = attributes.Find(name);
  if (!values || !index) return absl::OkStatus();
  TILEMEND_ASSIGN_OR_RETURN(const JsonView accessors, root.Get("accessors"));
  TILEMEND_ASSIGN_OR_RETURN(const int64_t i, index->AsInteger(0, kMaxElements));
  TILEMEND_ASSIGN_OR_RETURN(const JsonView accessor, accessors.At(i));
  TILEMEND_ASSIGN_OR_RETURN(values->normalized, accessor.BoolOr("normalized", false));
  return absl::OkStatus();
}

absl::Status CheckAttributes(const JsonView& primitive, const std::optional<GltfValues>& positions,
                             const std::optional<GltfValues>& uv) {
  if (!positions) return primitive.Error("expected the attribute POSITION");
  if (positions->components != 3) return primitive.Error("POSITION has not 3 components");
  if (positions->count >= static_cast<size_t>(kMaxElements)) return primitive.Error("too many vertices");
  if (uv && (uv->components != 2 || uv->count != positions->count)) {
    return primitive.Error("the texture coordinates have not 2 components for each vertex");
  }
  return absl::OkStatus();
}

// The triangles of an uncompressed primitive.
absl::StatusOr<std::vector<Triangle>> PlainTriangles(const JsonView& primitive, size_t vertices, GltfData& data) {
  const std::optional<JsonView> indices = primitive.Find("indices");
  std::vector<Triangle> triangles;
  if (!indices) {
    if (vertices % 3 != 0) return primitive.Error("the number of vertices is no multiple of 3");
    triangles.resize(vertices / 3);
    for (size_t i = 0; i < vertices; ++i) triangles[i / 3][i % 3] = static_cast<int32_t>(i);
    return triangles;
  }
  TILEMEND_ASSIGN_OR_RETURN(const int64_t accessor, indices->AsInteger(0, kMaxElements));
  TILEMEND_ASSIGN_OR_RETURN(const GltfValues values, data.Accessor(accessor));
  const bool is_unsigned =
      values.component_type == 5121 || values.component_type == 5123 || values.component_type == 5125;
  if (!is_unsigned || values.components != 1) return indices->Error("expected unsigned scalars");
  if (values.count % 3 != 0) return indices->Error("the number of indices is no multiple of 3");
  triangles.resize(values.count / 3);
  for (size_t i = 0; i < values.count; ++i) {
    const uint32_t index = values.IndexAt(i);
    if (index >= vertices) {
      return indices->Error(absl::StrCat("index ", i, " is ", index, ", but there are ", vertices, " vertices"));
    }
    triangles[i / 3][i % 3] = static_cast<int32_t>(index);
  }
  return triangles;
}

absl::Status ReadDraco(const JsonView& extension, const JsonView& primitive, const std::string& uv_name, GltfData& data,
                       GltfPrimitiveData& result) {
  TILEMEND_ASSIGN_OR_RETURN(const int64_t view, extension.Integer("bufferView", 0, kMaxElements));
  TILEMEND_ASSIGN_OR_RETURN(result.draco, data.Draco(view));
  TILEMEND_ASSIGN_OR_RETURN(std::optional<GltfValues> positions,
                            DracoValues(primitive, extension, "POSITION", *result.draco));
  TILEMEND_ASSIGN_OR_RETURN(result.uv, DracoValues(primitive, extension, uv_name, *result.draco));
  if (!result.uv) {  // it may lie beside the stream
    TILEMEND_ASSIGN_OR_RETURN(result.uv, Attribute(primitive, uv_name, data));
  }
  TILEMEND_RETURN_IF_ERROR(SetNormalized(data.root(), primitive, "POSITION", positions));
  TILEMEND_RETURN_IF_ERROR(SetNormalized(data.root(), primitive, uv_name, result.uv));
  TILEMEND_RETURN_IF_ERROR(CheckAttributes(primitive, positions, result.uv));
  result.positions = *positions;
  result.triangles.reserve(result.draco->faces.size());
  for (const std::array<uint32_t, 3>& face : result.draco->faces) {
    result.triangles.push_back(
        {static_cast<int32_t>(face[0]), static_cast<int32_t>(face[1]), static_cast<int32_t>(face[2])});
  }
  return absl::OkStatus();
}

}  // namespace

absl::StatusOr<std::vector<JsonView>> GltfPrimitivesOf(const JsonView& root, int64_t mesh) {
  TILEMEND_ASSIGN_OR_RETURN(const JsonView meshes, root.Get("meshes"));
  TILEMEND_ASSIGN_OR_RETURN(const JsonView view, meshes.At(mesh));
  return view.Elements("primitives");
}

absl::StatusOr<int64_t> GltfMaterialIndex(const JsonView& primitive) {
  return primitive.IntegerOr("material", 0, kMaxElements, -1);
}

absl::StatusOr<GltfPrimitiveData> ReadGltfPrimitive(const JsonView& primitive, int64_t texture_set, GltfData& data) {
  GltfPrimitiveData result;
  TILEMEND_ASSIGN_OR_RETURN(const int64_t mode, primitive.IntegerOr("mode", 0, 6, kTrianglesMode));
  if (mode != kTrianglesMode) return primitive.Error(absl::StrCat("mode ", mode, " is not read; expected triangles"));
  if (primitive.Find("targets")) return primitive.Error("morph targets are not read");
  TILEMEND_ASSIGN_OR_RETURN(result.material, GltfMaterialIndex(primitive));
  const std::string uv_name = absl::StrCat("TEXCOORD_", texture_set);
  if (const std::optional<JsonView> extension = primitive.Extension("KHR_draco_mesh_compression")) {
    TILEMEND_RETURN_IF_ERROR(ReadDraco(*extension, primitive, uv_name, data, result));
    return result;
  }
  TILEMEND_ASSIGN_OR_RETURN(const std::optional<GltfValues> positions, Attribute(primitive, "POSITION", data));
  TILEMEND_ASSIGN_OR_RETURN(result.uv, Attribute(primitive, uv_name, data));
  TILEMEND_RETURN_IF_ERROR(CheckAttributes(primitive, positions, result.uv));
  result.positions = *positions;
  TILEMEND_ASSIGN_OR_RETURN(result.triangles, PlainTriangles(primitive, positions->count, data));
  return result;
}

}  // namespace tilemend
