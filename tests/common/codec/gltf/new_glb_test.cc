#include "common/codec/gltf/new_glb.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tilemend {
namespace {

const std::vector<Point3> kPoints = {{1234.5, 10, 3}, {1235.5, 10, 3}, {1235.5, 11, 4.25f}};

TEST(NewGlbTest, IsReadAsItWasGiven) {
  const std::vector<GltfPatch> surfaces = {
      {kPoints, {{0.25f, 0.5f}, {1, 0}, {1, 1}}, {{0, 1, 2}}, "\xff\xd8\xff jpeg", "", {}},
      {kPoints, {}, {{0, 2, 1}}, "", "", {255, 0, 0}}};
  const auto bytes = NewGlb(surfaces, "a.glb");
  ASSERT_TRUE(bytes.ok()) << bytes.status();
  const auto read = ReadGltf(*bytes, GltfUpAxis::kY, "a.glb");
  ASSERT_TRUE(read.ok()) << read.status();
  ASSERT_EQ(read->primitives.size(), 2u);
  EXPECT_EQ(read->points[0], kPoints[0]);  // to the bit
  EXPECT_EQ(read->points[2], kPoints[2]);
  EXPECT_EQ(read->uv[0], (std::array<float, 2>{0.25f, 0.5f}));
  EXPECT_EQ(read->triangles[0], (Triangle{0, 1, 2}));
  ASSERT_EQ(read->images.size(), 1u);
  EXPECT_EQ(bytes->substr(read->images[0].offset, read->images[0].size), surfaces[0].image);
  EXPECT_EQ(read->primitives[0].texture, 0);
  EXPECT_EQ(read->primitives[1].texture, -1);
  EXPECT_EQ(read->primitives[1].base_colour, (std::array<double, 4>{1, 0, 0, 1}));
}

TEST(NewGlbTest, ASurfaceWithoutTrianglesIsRefused) {
  const std::vector<GltfPatch> surfaces = {{kPoints, {}, {}, "", "", {}}};
  EXPECT_THAT(std::string(NewGlb(surfaces, "a.glb").status().message()), testing::HasSubstr("a.glb"));
}

}  // namespace
}  // namespace tilemend
