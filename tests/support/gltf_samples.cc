#include "tests/support/gltf_samples.h"

#include <meshoptimizer.h>

#include <array>
#include <cstdint>
#include <cstring>

#include "draco/compression/encode.h"
#include "draco/mesh/mesh.h"

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

template <typename T>
std::string Raw(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

std::string Raw32(uint32_t value) { return Raw(std::vector<uint32_t>{value}); }

void Pad(std::string& text, size_t multiple, char with) {
  text.append((multiple - text.size() % multiple) % multiple, with);
}

// Appends a view and returns its index.
int AddView(GltfSample& sample, const std::string& bytes, int target = 0) {
  Json view = {{"buffer", 0}, {"byteOffset", sample.bin.size()}, {"byteLength", bytes.size()}};
  if (target != 0) view["target"] = target;
  sample.bin += bytes;
  Pad(sample.bin, 4, '\0');
  sample.json["bufferViews"].push_back(view);
  sample.json["buffers"] = Json::array({{{"byteLength", sample.bin.size()}}});
  return static_cast<int>(sample.json["bufferViews"].size()) - 1;
}

int AddAccessor(GltfSample& sample, const Json& accessor) {
  sample.json["accessors"].push_back(accessor);
  return static_cast<int>(sample.json["accessors"].size()) - 1;
}

// A document with one scene of one node, a textured material, and a mesh without attributes yet.
GltfSample Base() {
  GltfSample sample;
  sample.json = Json::parse(R"({"asset": {"version": "2.0", "generator": "samples"}, "scene": 0,
    "scenes": [{"nodes": [0]}], "nodes": [{"name": "tile", "mesh": 0}],
    "meshes": [{"primitives": [{"attributes": {}, "material": 0}]}],
    "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, "metallicFactor": 0.0}}],
    "textures": [{"source": 0}], "images": [{"mimeType": "image/png", "name": "photo"}],
    "extras": {"survey": [1, 2.5, "three"]}})");
  sample.json["images"][0]["bufferView"] = AddView(sample, OnePixelPng());
  return sample;
}

Json& PrimitiveOf(GltfSample& sample) { return sample.json["meshes"][0]["primitives"][0]; }

void UseExtension(GltfSample& sample, const char* name) {
  sample.json["extensionsUsed"].push_back(name);
  sample.json["extensionsRequired"].push_back(name);
}

constexpr int kGrid = 4;  // squares in a row

std::vector<float> GridPoints() {
  std::vector<float> points;
  for (int z = 0; z <= kGrid; ++z) {
    for (int x = 0; x <= kGrid; ++x) {
      points.insert(points.end(), {static_cast<float>(x), 0.25F * static_cast<float>(x * z), static_cast<float>(-z)});
    }
  }
  return points;
}

std::vector<float> GridUv() {
  std::vector<float> uv;
  for (int z = 0; z <= kGrid; ++z) {
    for (int x = 0; x <= kGrid; ++x)
      uv.insert(uv.end(), {static_cast<float>(x) / kGrid, static_cast<float>(z) / kGrid});
  }
  return uv;
}

std::vector<uint32_t> GridIndices() {
  std::vector<uint32_t> indices;
  for (uint32_t z = 0; z < kGrid; ++z) {
    for (uint32_t x = 0; x < kGrid; ++x) {
      const uint32_t a = z * (kGrid + 1) + x, b = a + kGrid + 1;
      indices.insert(indices.end(), {a, a + 1, b, a + 1, b + 1, b});
    }
  }
  return indices;
}

Json GridPositionAccessor() {
  return {{"componentType", 5126}, {"count", 25}, {"type", "VEC3"}, {"min", {0, 0, -4}}, {"max", {4, 4, 0}}};
}

Json WithView(Json accessor, int view) {
  accessor["bufferView"] = view;
  return accessor;
}

const Json& UvAccessor() {
  static const Json accessor = {{"componentType", 5126}, {"count", 25}, {"type", "VEC2"}};
  return accessor;
}

const Json& IndexAccessor() {
  static const Json accessor = {{"componentType", 5125}, {"count", 96}, {"type", "SCALAR"}};
  return accessor;
}

// A Draco stream of the grid: attribute 0 positions, 1 texture coordinates.
std::string GridStream(bool is_edgebreaker) {
  draco::Mesh mesh;
  mesh.set_num_points(25);
  const auto add = [&mesh](draco::GeometryAttribute::Type type, int8_t components, const std::vector<float>& values) {
    draco::GeometryAttribute attribute;
    attribute.Init(type, nullptr, components, draco::DT_FLOAT32, false, 4 * components, 0);
    const int id = mesh.AddAttribute(attribute, true, 25);
    for (uint32_t i = 0; i < 25; ++i) {
      mesh.attribute(id)->SetAttributeValue(draco::AttributeValueIndex(i),
                                            values.data() + i * static_cast<size_t>(components));
    }
  };
  add(draco::GeometryAttribute::POSITION, 3, GridPoints());
  add(draco::GeometryAttribute::TEX_COORD, 2, GridUv());
  const std::vector<uint32_t> indices = GridIndices();
  for (size_t i = 0; i < indices.size(); i += 3) {
    mesh.AddFace({draco::PointIndex(indices[i]), draco::PointIndex(indices[i + 1]), draco::PointIndex(indices[i + 2])});
  }
  draco::Encoder encoder;
  encoder.SetEncodingMethod(is_edgebreaker ? draco::MESH_EDGEBREAKER_ENCODING : draco::MESH_SEQUENTIAL_ENCODING);
  encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, 14);
  encoder.SetAttributeQuantization(draco::GeometryAttribute::TEX_COORD, 12);
  draco::EncoderBuffer buffer;
  return encoder.EncodeMeshToBuffer(mesh, &buffer).ok() ? std::string(buffer.data(), buffer.size()) : "";
}

// A view whose bytes are compressed, with room for them in a second buffer that is not there.
int AddMeshoptView(GltfSample& sample, const std::string& compressed, size_t count, size_t stride, const char* mode) {
  const int index = AddView(sample, compressed);
  Json& view = sample.json["bufferViews"][static_cast<size_t>(index)];
  const Json extension = {{"buffer", 0},
                          {"byteOffset", view["byteOffset"]},
                          {"byteLength", compressed.size()},
                          {"byteStride", stride},
                          {"count", count},
                          {"mode", mode}};
  view = {{"buffer", 1}, {"byteLength", count * stride}, {"extensions", {{"EXT_meshopt_compression", extension}}}};
  if (std::strcmp(mode, "ATTRIBUTES") == 0) view["byteStride"] = stride;
  return index;
}

std::string EncodedVertices(const std::vector<float>& values, size_t stride) {
  const size_t count = values.size() * sizeof(float) / stride;
  std::string out(meshopt_encodeVertexBufferBound(count, stride), '\0');
  out.resize(meshopt_encodeVertexBuffer(reinterpret_cast<unsigned char*>(out.data()), out.size(), values.data(), count,
                                        stride));
  return out;
}

std::string EncodedIndices(const std::vector<uint32_t>& indices) {
  std::string out(meshopt_encodeIndexBufferBound(indices.size(), 25), '\0');
  out.resize(meshopt_encodeIndexBuffer(reinterpret_cast<unsigned char*>(out.data()), out.size(), indices.data(),
                                       indices.size()));
  return out;
}

}  // namespace

std::string GltfSample::Glb() const { return GlbOf(json.dump(), bin); }

std::string OnePixelPng() {
  static constexpr unsigned char kBytes[] = {
      0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48, 0x44, 0x52, 0x00, 0x00,
      0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x08, 0x06, 0x00, 0x00, 0x00, 0x1f, 0x15, 0xc4, 0x89, 0x00, 0x00, 0x00,
      0x0d, 0x49, 0x44, 0x41, 0x54, 0x78, 0x9c, 0x63, 0xf8, 0xcf, 0xc0, 0xf0, 0x1f, 0x00, 0x05, 0x00, 0x01, 0xff,
      0x89, 0x99, 0x3d, 0x1d, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};
  return {reinterpret_cast<const char*>(kBytes), sizeof(kBytes)};
}

std::string GlbOf(std::string_view json, std::string_view bin) {
  std::string text(json), data(bin);
  Pad(text, 4, ' ');
  Pad(data, 4, '\0');
  std::string chunks = Raw32(static_cast<uint32_t>(text.size())) + "JSON" + text;
  if (!data.empty()) chunks += Raw32(static_cast<uint32_t>(data.size())) + std::string("BIN\0", 4) + data;
  return "glTF" + Raw32(2) + Raw32(static_cast<uint32_t>(12 + chunks.size())) + chunks;
}

std::string B3dmOf(const std::string& glb, std::string feature_table, std::string batch_table) {
  while ((28 + feature_table.size()) % 8 != 0) feature_table += ' ';
  Pad(batch_table, 8, ' ');
  const size_t size = 28 + feature_table.size() + batch_table.size() + glb.size();
  return "b3dm" + Raw32(1) + Raw32(static_cast<uint32_t>(size)) + Raw32(static_cast<uint32_t>(feature_table.size())) +
         Raw32(0) + Raw32(static_cast<uint32_t>(batch_table.size())) + Raw32(0) + feature_table + batch_table + glb;
}

GltfSample SquareSample() {
  GltfSample sample = Base();
  sample.json["nodes"] = Json::parse(R"([{"scale": [2, 2, 2], "children": [1]},
    {"name": "tile", "mesh": 0, "translation": [10, 20, 30]}])");
  const std::vector<float> points = {0, 0, 0, 2, 0, 0, 2, 1, -2, 0, 0, -2};
  const std::vector<float> uv = {0, 1, 1, 1, 1, 0, 0, 0};
  const std::vector<uint16_t> indices = {0, 1, 2, 0, 2, 3};
  Json& attributes = PrimitiveOf(sample)["attributes"];
  attributes["POSITION"] = AddAccessor(sample, {{"bufferView", AddView(sample, Raw(points), 34962)},
                                                {"componentType", 5126},
                                                {"count", 4},
                                                {"type", "VEC3"},
                                                {"min", {0, 0, -2}},
                                                {"max", {2, 1, 0}}});
  attributes["TEXCOORD_0"] = AddAccessor(
      sample,
      {{"bufferView", AddView(sample, Raw(uv), 34962)}, {"componentType", 5126}, {"count", 4}, {"type", "VEC2"}});
  PrimitiveOf(sample)["indices"] = AddAccessor(sample, {{"bufferView", AddView(sample, Raw(indices), 34963)},
                                                        {"componentType", 5123},
                                                        {"count", 6},
                                                        {"type", "SCALAR"}});
  return sample;
}

GltfSample QuantizedSample() {
  GltfSample sample = Base();
  UseExtension(sample, "KHR_mesh_quantization");
  UseExtension(sample, "KHR_texture_transform");
  sample.json["nodes"][0]["matrix"] = {0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 0.5, 0, 100, 200, 300, 1};
  sample.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["extensions"] = {
      {"KHR_texture_transform", {{"offset", {0.5, 0.25}}, {"scale", {0.5, 0.5}}}}};
  // Strides are multiples of 4: three coordinates and a filler.
  const std::vector<int16_t> points = {0, 0, 0, 0, 1000, 0, 0, 0, 1000, 10, -1000, 0, 0, 0, -1000, 0};
  const std::vector<uint16_t> uv = {0, 65535, 65535, 65535, 65535, 0, 0, 0};
  Json& attributes = PrimitiveOf(sample)["attributes"];
  const int view = AddView(sample, Raw(points), 34962);
  sample.json["bufferViews"][static_cast<size_t>(view)]["byteStride"] = 8;
  attributes["POSITION"] = AddAccessor(sample, {{"bufferView", view},
                                                {"componentType", 5122},
                                                {"count", 4},
                                                {"type", "VEC3"},
                                                {"min", {0, 0, -1000}},
                                                {"max", {1000, 10, 0}}});
  attributes["TEXCOORD_0"] = AddAccessor(sample, {{"bufferView", AddView(sample, Raw(uv), 34962)},
                                                  {"componentType", 5123},
                                                  {"normalized", true},
                                                  {"count", 4},
                                                  {"type", "VEC2"}});
  PrimitiveOf(sample)["indices"] =
      AddAccessor(sample, {{"bufferView", AddView(sample, Raw(std::vector<uint8_t>{0, 1, 2, 0, 2, 3}), 34963)},
                           {"componentType", 5121},
                           {"count", 6},
                           {"type", "SCALAR"}});
  return sample;
}

GltfSample GridSample() {
  GltfSample sample = Base();
  Json& attributes = PrimitiveOf(sample)["attributes"];
  attributes["POSITION"] =
      AddAccessor(sample, WithView(GridPositionAccessor(), AddView(sample, Raw(GridPoints()), 34962)));
  attributes["TEXCOORD_0"] = AddAccessor(sample, WithView(UvAccessor(), AddView(sample, Raw(GridUv()), 34962)));
  PrimitiveOf(sample)["indices"] =
      AddAccessor(sample, WithView(IndexAccessor(), AddView(sample, Raw(GridIndices()), 34963)));
  return sample;
}

GltfSample DracoSample(bool is_edgebreaker) {
  GltfSample sample = Base();
  UseExtension(sample, "KHR_draco_mesh_compression");
  Json& primitive = PrimitiveOf(sample);
  primitive["attributes"]["POSITION"] = AddAccessor(sample, GridPositionAccessor());
  primitive["attributes"]["TEXCOORD_0"] = AddAccessor(sample, UvAccessor());
  primitive["indices"] = AddAccessor(sample, IndexAccessor());
  primitive["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", AddView(sample, GridStream(is_edgebreaker))},
                                                           {"attributes", {{"POSITION", 0}, {"TEXCOORD_0", 1}}}};
  return sample;
}

GltfSample MeshoptSample() {
  GltfSample sample = Base();
  UseExtension(sample, "EXT_meshopt_compression");
  Json& attributes = PrimitiveOf(sample)["attributes"];
  const int points = AddMeshoptView(sample, EncodedVertices(GridPoints(), 12), 25, 12, "ATTRIBUTES");
  attributes["POSITION"] = AddAccessor(sample, WithView(GridPositionAccessor(), points));
  const int uv = AddMeshoptView(sample, EncodedVertices(GridUv(), 8), 25, 8, "ATTRIBUTES");
  attributes["TEXCOORD_0"] = AddAccessor(sample, WithView(UvAccessor(), uv));
  const int indices = AddMeshoptView(sample, EncodedIndices(GridIndices()), 96, 4, "TRIANGLES");
  PrimitiveOf(sample)["indices"] = AddAccessor(sample, WithView(IndexAccessor(), indices));
  size_t room = 0;
  for (Json& view : sample.json["bufferViews"]) {
    if (view["buffer"] != 1) continue;
    view["byteOffset"] = room;
    room += (view["byteLength"].get<size_t>() + 3) / 4 * 4;
  }
  const Json fallback = {{"EXT_meshopt_compression", {{"fallback", true}}}};
  sample.json["buffers"].push_back({{"byteLength", room}, {"extensions", fallback}});
  return sample;
}

std::vector<std::pair<std::string, std::string>> GltfSampleFiles() {
  return {{"square.glb", SquareSample().Glb()},
          {"quantized.glb", QuantizedSample().Glb()},
          {"grid.glb", GridSample().Glb()},
          {"edgebreaker.glb", DracoSample(true).Glb()},
          {"sequential.glb", DracoSample(false).Glb()},
          {"meshopt.glb", MeshoptSample().Glb()},
          {"square.b3dm", B3dmOf(SquareSample().Glb(), R"({"BATCH_LENGTH":1,"RTC_CENTER":[1000.5,-2000.25,3000]})",
                                 R"({"name":["house"]})")}};
}

}  // namespace tilemend
