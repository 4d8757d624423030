#include "common/codec/gltf/gltf_primitive.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/codec/gltf/gltf_checks.h"

namespace tilemend {
namespace {

using testing::HasSubstr;

// The refusal of a sample with one value replaced.
std::string RefusalWith(GltfSample sample, const char* path, const OrderedJson& value) {
  sample.json[OrderedJson::json_pointer(path)] = value;
  return GltfRefusal(sample.Glb());
}

TEST(GltfPrimitiveTest, ReadsTrianglesAndTextureCoordinates) {
  const std::string bytes = SquareSample().Glb();
  const GltfContainer container = ParseGltfContainer(bytes, kGltfName).value();
  const std::string name = kGltfName;
  const JsonView root(container.json, name);
  GltfData data(container, root);
  const std::vector<JsonView> primitives = GltfPrimitivesOf(root, 0).value();
  ASSERT_EQ(primitives.size(), 1u);
  EXPECT_EQ(GltfMaterialIndex(primitives[0]).value(), 0);
  const absl::StatusOr<GltfPrimitiveData> primitive = ReadGltfPrimitive(primitives[0], 0, data);
  ASSERT_TRUE(primitive.ok()) << primitive.status();
  EXPECT_THAT(primitive->triangles, testing::ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}));
  EXPECT_TRUE(primitive->uv.has_value());
  EXPECT_FALSE(ReadGltfPrimitive(primitives[0], 1, data)->uv.has_value());
  EXPECT_EQ(primitive->draco, nullptr);
}

TEST(GltfPrimitiveTest, ReadsTrianglesWithoutIndices) {
  GltfSample sample = SquareSample();
  sample.json["meshes"][0]["primitives"][0].erase("indices");
  EXPECT_THAT(GltfRefusal(sample.Glb()), HasSubstr("the number of vertices is no multiple of 3"));
  sample.json["accessors"][0]["count"] = 3;
  sample.json["accessors"][1]["count"] = 3;
  EXPECT_THAT(ReadGltfSample(sample.Glb()).triangles, testing::ElementsAre(Triangle{0, 1, 2}));
}

TEST(GltfPrimitiveTest, RefusesByName) {
  const std::string primitive = "/meshes/0/primitives/0";
  const auto with = [&](const std::string& key, const OrderedJson& value) {
    return RefusalWith(SquareSample(), (primitive + key).c_str(), value);
  };
  EXPECT_EQ(with("/mode", 5), "a.glb: JSON /meshes/0/primitives/0: mode 5 is not read; expected triangles");
  EXPECT_THAT(with("/targets", OrderedJson::array()), HasSubstr("morph targets are not read"));
  EXPECT_THAT(with("/attributes", OrderedJson::object()), HasSubstr("expected the attribute POSITION"));
  EXPECT_THAT(with("/attributes/POSITION", 1), HasSubstr("POSITION has not 3 components"));
  EXPECT_THAT(with("/attributes/TEXCOORD_0", 0), HasSubstr("not 2 components for each vertex"));
  EXPECT_THAT(with("/indices", 0), HasSubstr("expected unsigned scalars"));
  EXPECT_THAT(with("/material", 9), HasSubstr("JSON /materials: no element 9"));
  EXPECT_THAT(RefusalWith(SquareSample(), "/accessors/2/count", 5), HasSubstr("no multiple of 3"));
}

TEST(GltfPrimitiveTest, RefusesIndicesWithoutVertex) {
  GltfSample sample = SquareSample();
  sample.json["accessors"][0]["count"] = 3;
  sample.json["accessors"][1]["count"] = 3;
  EXPECT_THAT(GltfRefusal(sample.Glb()), HasSubstr("/indices: index 5 is 3, but there are 3 vertices"));
}

TEST(GltfPrimitiveTest, RefusesDracoAttributesThatAreNotThere) {
  const char* const extension = "/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression/attributes/POSITION";
  EXPECT_THAT(RefusalWith(DracoSample(true), extension, 7), HasSubstr("the Draco stream has no such attribute"));
}

}  // namespace
}  // namespace tilemend
