#include "common/codec/gltf/gltf_builder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <utility>

#include "common/util/status_macros.h"
#include "common/util/texture_wrap.h"

namespace tilemend {
namespace {

constexpr const char* kArrays[] = {"accessors", "buffers", "bufferViews", "images", "materials",
                                   "meshes",    "nodes",   "samplers",    "scenes", "textures"};
constexpr int64_t kVertexTarget = 34962, kIndexTarget = 34963;

template <typename T>
void AppendRaw(T value, std::string& out) {
  out.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

// sRGB to linear.
double LinearOf(uint8_t channel) {
  const double value = channel / 255.0;
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

// JPEG and PNG are told by their first bytes.
const char* MimeType(std::string_view image) { return image.substr(0, 4) == "\x89PNG" ? "image/png" : "image/jpeg"; }

void SetBounds(std::string_view float_positions, OrderedJson& accessor) {
  std::array<float, 3> low, high, point;
  for (size_t at = 0; at + sizeof(point) <= float_positions.size(); at += sizeof(point)) {
    std::memcpy(point.data(), float_positions.data() + at, sizeof(point));
    if (at == 0) low = high = point;
    for (size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], point[k]);
      high[k] = std::max(high[k], point[k]);
    }
  }
  accessor["min"] = low;
  accessor["max"] = high;
}

}  // namespace

absl::Status CheckGltfArrays(const JsonView& root) {
  for (const char* name : kArrays) TILEMEND_RETURN_IF_ERROR(root.Elements(name).status());
  return root.Elements("extensionsUsed").status();
}

int64_t GltfBuilder::Append(const char* array, OrderedJson element) {
  OrderedJson& elements = json_[array];
  elements.push_back(std::move(element));
  return static_cast<int64_t>(elements.size()) - 1;
}

int64_t GltfBuilder::AddView(std::string_view bytes, int64_t target, size_t stride) {
  OrderedJson view = {{"buffer", 0}, {"byteOffset", bin_bytes_ + added_.size()}, {"byteLength", bytes.size()}};
  if (stride != 0) view["byteStride"] = stride;
  if (target != 0) view["target"] = target;
  added_ += bytes;
  added_.append((4 - added_.size() % 4) % 4, '\0');
  return Append("bufferViews", std::move(view));
}

int64_t GltfBuilder::AddIndices(std::span<const Triangle> triangles) {
  int32_t highest = 0;
  for (const Triangle& triangle : triangles) highest = std::max({highest, triangle[0], triangle[1], triangle[2]});
  const bool is_short = highest < 65535;  // that one restarts a primitive
  std::string bytes;
  bytes.reserve(triangles.size() * (is_short ? 6 : 12));
  for (const Triangle& triangle : triangles) {
    for (const int32_t corner : triangle) {
      if (is_short) {
        AppendRaw(static_cast<uint16_t>(corner), bytes);
      } else {
        AppendRaw(static_cast<uint32_t>(corner), bytes);
      }
    }
  }
  return Append("accessors", {{"bufferView", AddView(bytes, kIndexTarget)},
                              {"componentType", is_short ? 5123 : 5125},
                              {"count", 3 * triangles.size()},
                              {"type", "SCALAR"}});
}

int64_t GltfBuilder::AddPositions(std::span<const Eigen::Vector3f> points) {
  std::string bytes;
  for (const Eigen::Vector3f& point : points) {
    for (int k = 0; k < 3; ++k) AppendRaw(point[k], bytes);
  }
  OrderedJson accessor = {{"bufferView", AddView(bytes, kVertexTarget)},
                          {"componentType", 5126},
                          {"count", points.size()},
                          {"type", "VEC3"}};
  SetBounds(bytes, accessor);
  return Append("accessors", std::move(accessor));
}

int64_t GltfBuilder::AddCopy(const OrderedJson& accessor, std::string_view values, size_t size,
                             bool is_float_position) {
  // Vertices begin at multiples of 4.
  const size_t stride = (size + 3) / 4 * 4;
  std::string bytes;
  for (size_t at = 0; at < values.size(); at += size) {
    bytes += values.substr(at, size);
    bytes.append(stride - size, '\0');
  }
  OrderedJson copy = accessor;
  copy["bufferView"] = AddView(bytes, kVertexTarget, stride == size ? 0 : stride);
  copy["byteOffset"] = 0;
  copy["count"] = values.size() / size;
  copy.erase("sparse");
  if (is_float_position) SetBounds(bytes, copy);
  return Append("accessors", std::move(copy));
}

int64_t GltfBuilder::AddTexture(const GltfPatch& patch) {
  OrderedJson image = {{"bufferView", AddView(patch.image, 0)}, {"mimeType", MimeType(patch.image)}};
  if (!patch.image_name.empty()) image["name"] = patch.image_name;
  const int64_t source = Append("images", std::move(image));
  constexpr int kClampToEdge = 33071, kRepeat = 10497;
  const int wrap = RepeatsImage(patch.uv) ? kRepeat : kClampToEdge;
  const int64_t sampler =
      Append("samplers", {{"magFilter", 9729}, {"minFilter", 9987}, {"wrapS", wrap}, {"wrapT", wrap}});
  return Append("textures", {{"sampler", sampler}, {"source", source}});
}

int64_t GltfBuilder::AddMaterial(const GltfPatch& patch, const GltfShading& shading) {
  OrderedJson pbr;
  if (patch.image.empty()) {
    pbr["baseColorFactor"] = {LinearOf(patch.colour.r), LinearOf(patch.colour.g), LinearOf(patch.colour.b), 1.0};
  } else {
    pbr["baseColorTexture"] = {{"index", AddTexture(patch)}};
  }
  pbr["metallicFactor"] = 0.0;
  pbr["roughnessFactor"] = 1.0;
  OrderedJson material = {{"pbrMetallicRoughness", std::move(pbr)}};
  if (shading.is_double_sided) material["doubleSided"] = true;
  if (shading.is_unlit) material["extensions"] = {{"KHR_materials_unlit", OrderedJson::object()}};
  return Append("materials", std::move(material));
}

int64_t GltfBuilder::AddPatchMesh(const GltfPatch& patch, std::span<const Eigen::Vector3f> points,
                                  std::span<const Triangle> triangles, const GltfShading& shading) {
  OrderedJson attributes = {{"POSITION", AddPositions(points)}};
  if (!patch.image.empty()) {
    std::string bytes;
    for (const std::array<float, 2>& uv : patch.uv) {
      AppendRaw(uv[0], bytes);
      AppendRaw(1 - uv[1], bytes);
    }
    attributes["TEXCOORD_0"] = Append("accessors", {{"bufferView", AddView(bytes, kVertexTarget)},
                                                    {"componentType", 5126},
                                                    {"count", patch.uv.size()},
                                                    {"type", "VEC2"}});
  }
  OrderedJson primitive = {{"attributes", std::move(attributes)}, {"indices", AddIndices(triangles)}};
  primitive["material"] = AddMaterial(patch, shading);
  OrderedJson mesh;
  mesh["primitives"].push_back(std::move(primitive));
  return Append("meshes", std::move(mesh));
}

void GltfBuilder::SetBufferLength() {
  if (added_.empty()) return;
  OrderedJson& buffers = json_["buffers"];
  if (buffers.empty()) buffers.push_back(OrderedJson::object());
  buffers[0]["byteLength"] = bin_bytes_ + added_.size();
}

}  // namespace tilemend
