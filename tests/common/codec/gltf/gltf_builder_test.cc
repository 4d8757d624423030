#include "common/codec/gltf/gltf_builder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tilemend {
namespace {

TEST(GltfBuilderTest, AppendsViewsAtMultiplesOfFour) {
  OrderedJson json = {{"bufferViews", {{{"buffer", 0}}}}};
  GltfBuilder builder(json, 8);
  EXPECT_EQ(builder.AddView("12345", 0), 1);
  EXPECT_EQ(builder.AddView("x", 34962, 4), 2);
  EXPECT_EQ(json["bufferViews"][1].dump(), R"({"buffer":0,"byteOffset":8,"byteLength":5})");
  EXPECT_EQ(json["bufferViews"][2].dump(),
            R"({"buffer":0,"byteOffset":16,"byteLength":1,"byteStride":4,"target":34962})");
  builder.SetBufferLength();
  EXPECT_EQ(json["buffers"].dump(), R"([{"byteLength":20}])");
}

TEST(GltfBuilderTest, TakesTheSmallestIndices) {
  OrderedJson json;
  GltfBuilder builder(json, 0);
  const std::vector<Triangle> few = {{0, 1, 65534}}, many = {{0, 1, 65535}};
  builder.AddIndices(few);
  builder.AddIndices(many);
  EXPECT_EQ(json["accessors"][0]["componentType"], 5123);
  EXPECT_EQ(json["accessors"][1]["componentType"], 5125);
  EXPECT_EQ(builder.added().size(), 8u + 12u);
}

TEST(GltfBuilderTest, GivesPositionsBounds) {
  OrderedJson json;
  GltfBuilder builder(json, 0);
  const std::vector<Eigen::Vector3f> points = {{1, 2, 3}, {-1, 5, 0.5F}};
  builder.AddPositions(points);
  EXPECT_EQ(json["accessors"][0]["min"].dump(), "[-1.0,2.0,0.5]");
  EXPECT_EQ(json["accessors"][0]["max"].dump(), "[1.0,5.0,3.0]");
}

TEST(GltfBuilderTest, PadsCopiedVertices) {
  OrderedJson json;
  GltfBuilder builder(json, 0);
  const OrderedJson accessor = {{"componentType", 5121}, {"count", 9}, {"type", "VEC3"}, {"sparse", 1}};
  builder.AddCopy(accessor, "abcdef", 3, false);
  EXPECT_EQ(builder.added(), std::string_view("abc\0def\0", 8));
  EXPECT_EQ(json["bufferViews"][0]["byteStride"], 4);
  EXPECT_EQ(json["accessors"][0]["count"], 2);
  EXPECT_FALSE(json["accessors"][0].contains("sparse"));
}

TEST(GltfBuilderTest, GivesAPatchTheColourInLinearLight) {
  OrderedJson json;
  GltfBuilder builder(json, 0);
  GltfPatch patch;
  patch.colour = {255, 0, 188};
  const std::vector<Eigen::Vector3f> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const std::vector<Triangle> triangles = {{0, 1, 2}};
  EXPECT_EQ(builder.AddPatchMesh(patch, points, triangles, {.is_unlit = true, .is_double_sided = true}), 0);
  const OrderedJson& material = json["materials"][0];
  EXPECT_EQ(material["pbrMetallicRoughness"]["baseColorFactor"][0], 1.0);
  EXPECT_NEAR(material["pbrMetallicRoughness"]["baseColorFactor"][2].get<double>(), 0.5029, 1e-3);
  EXPECT_TRUE(material["doubleSided"]);
  EXPECT_TRUE(material["extensions"].contains("KHR_materials_unlit"));
  EXPECT_FALSE(json.contains("textures"));
}

TEST(GltfBuilderTest, ChecksThatArraysAreArrays) {
  const std::string name = "a";
  const OrderedJson good = {{"meshes", OrderedJson::array()}}, bad = {{"meshes", 1}};
  EXPECT_TRUE(CheckGltfArrays(JsonView(good, name)).ok());
  EXPECT_EQ(std::string(CheckGltfArrays(JsonView(bad, name)).message()), "a: JSON /meshes: expected an array");
}

}  // namespace
}  // namespace tilemend
