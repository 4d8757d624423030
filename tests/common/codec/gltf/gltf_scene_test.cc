#include "common/codec/gltf/gltf_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/gltf_samples.h"

namespace tilemend {
namespace {

using testing::HasSubstr;
const std::string kScene = "scene.glb";

Point3 Moved(const Eigen::Matrix4d& matrix, const Point3& point) { return (matrix * point.homogeneous()).head<3>(); }

TEST(GltfSceneTest, TurnsTheAxisUp) {
  EXPECT_EQ(Moved(GltfToZUp(GltfUpAxis::kY), {1, 2, 3}), Point3(1, -3, 2));
  EXPECT_EQ(Moved(GltfToZUp(GltfUpAxis::kX), {1, 2, 3}), Point3(-3, 2, 1));
  EXPECT_EQ(Moved(GltfToZUp(GltfUpAxis::kZ), {1, 2, 3}), Point3(1, 2, 3));
}

TEST(GltfSceneTest, MultipliesMatricesDownTheTree) {
  OrderedJson json = SquareSample().json;
  json["nodes"][1]["rotation"] = {0, 0, 0.7071067811865476, 0.7071067811865476};  // 90 degrees about z
  const absl::StatusOr<std::vector<GltfInstance>> instances = GltfInstances(JsonView(json, kScene));
  ASSERT_TRUE(instances.ok()) << instances.status();
  ASSERT_EQ(instances->size(), 1u);
  EXPECT_EQ(instances->front().node, 1);
  EXPECT_EQ(instances->front().parent, 0);
  EXPECT_EQ(instances->front().name, "tile");
  EXPECT_TRUE(Moved(instances->front().matrix, {1, 0, 0}).isApprox(Point3(20, 42, 60)));
}

TEST(GltfSceneTest, RefusesScenesThatAreNoTrees) {
  const auto message = [](const char* path, const OrderedJson& value) {
    OrderedJson json = SquareSample().json;
    json[OrderedJson::json_pointer(path)] = value;
    return std::string(GltfInstances(JsonView(json, kScene)).status().message());
  };
  EXPECT_EQ(message("/nodes/1/children", {0}), "scene.glb: JSON /nodes/0: the scene reaches this node twice");
  EXPECT_EQ(message("/nodes/0/children", {1, 1}), "scene.glb: JSON /nodes/1: the scene reaches this node twice");
  EXPECT_EQ(message("/nodes/0/children", {7}), "scene.glb: JSON /nodes: no element 7");
  EXPECT_EQ(message("/nodes/1/skin", 0), "scene.glb: JSON /nodes/1: skins are not read");
  EXPECT_EQ(message("/nodes/1/matrix", {1, 2}), "scene.glb: JSON /nodes/1/matrix: expected 16 numbers");
  EXPECT_EQ(message("/scene", 3), "scene.glb: JSON /scenes: no element 3");
  EXPECT_THAT(message("/nodes/1/extensions", {{"EXT_mesh_gpu_instancing", 1}}), HasSubstr("is not read"));
  EXPECT_THAT(message("/nodes/1/translation", {1e308, 0, 0}), HasSubstr("the matrix is not finite"));
}

TEST(GltfSceneTest, LimitsTheDepthOfNodes) {
  OrderedJson json = {{"scenes", {{{"nodes", {0}}}}}};
  for (int i = 0; i < 65; ++i) json["nodes"].push_back({{"children", {i + 1}}});
  json["nodes"][64].erase("children");
  EXPECT_THAT(std::string(GltfInstances(JsonView(json, kScene)).status().message()),
              HasSubstr("deeper than 64 levels"));
}

TEST(GltfSceneTest, RefusesRequiredExtensionsByName) {
  OrderedJson json = {{"extensionsRequired", {"KHR_materials_unlit", "KHR_mesh_quantization"}}};
  EXPECT_TRUE(CheckGltfExtensions(JsonView(json, kScene)).ok());
  json["extensionsRequired"].push_back("EXT_other");
  EXPECT_EQ(std::string(CheckGltfExtensions(JsonView(json, kScene)).message()),
            "scene.glb: JSON /extensionsRequired/2: the file requires the extension EXT_other, which is not read");
  const OrderedJson animated = {{"animations", {1}}};
  EXPECT_THAT(std::string(CheckGltfExtensions(JsonView(animated, kScene)).message()), HasSubstr("animations"));
}

TEST(GltfSceneTest, ReadsCesiumRtc) {
  const OrderedJson json = OrderedJson::parse(R"({"extensions":{"CESIUM_RTC":{"center":[1,2,3]}}})");
  EXPECT_EQ(GltfRtcCenter(JsonView(json, kScene)).value(), Point3(1, 2, 3));
}

TEST(GltfSceneTest, ReadsMaterials) {
  OrderedJson json = QuantizedSample().json;
  json["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] = {0.5, 1, 1, 1};
  const absl::StatusOr<GltfMaterial> material = GltfMaterialOf(JsonView(json, kScene), 0);
  ASSERT_TRUE(material.ok()) << material.status();
  EXPECT_EQ(material->image, 0);
  EXPECT_EQ(material->base_colour[0], 0.5);
  EXPECT_TRUE(material->has_base_colour);
  EXPECT_TRUE((material->uv_transform * Point3(1, 1, 1)).isApprox(Point2(1, 0.75)));
  EXPECT_EQ(GltfMaterialOf(JsonView(json, kScene), -1)->image, -1);
  EXPECT_FALSE(GltfMaterialOf(JsonView(json, kScene), -1)->has_base_colour);
  EXPECT_FALSE(GltfMaterialOf(JsonView(json, kScene), 1).ok());
}

TEST(GltfSceneTest, PrefersImagesThatEveryViewerShows) {
  OrderedJson json = SquareSample().json;
  json["images"].push_back({{"mimeType", "image/ktx2"}});
  json["textures"][0]["extensions"]["KHR_texture_basisu"]["source"] = 1;
  EXPECT_EQ(GltfMaterialOf(JsonView(json, kScene), 0)->image, 0);
  json["textures"][0].erase("source");
  EXPECT_EQ(GltfMaterialOf(JsonView(json, kScene), 0)->image, 1);
}

}  // namespace
}  // namespace tilemend
