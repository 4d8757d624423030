#include "common/codec/osgb/osgb_new.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/codec/osgb/osgb_checks.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;

TEST(NewOsgbTest, IsReadAsItWasMade) {
  const OsgbPatch triangle = OsgbTriangle();
  const std::vector<OsgbNode> nodes = {{{triangle}, "finer.osgb", {1, 2, 3}, 7, 300},
                                       {{triangle, triangle}, "", Point3::Zero(), 0, 0}};
  const auto bytes = NewOsgb(nodes, "a.osgb");
  ASSERT_TRUE(bytes.ok()) << bytes.status();
  const auto file = ReadOsgb(*bytes, "a.osgb");
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_EQ(file->version, 80U);
  ASSERT_EQ(file->geodes.size(), 2U);
  EXPECT_EQ(file->geodes[0].paged_lod, 0);
  EXPECT_EQ(file->geodes[1].paged_lod, -1);
  ASSERT_EQ(file->geometries.size(), 3U);
  EXPECT_EQ(std::vector<Point3>(file->points.begin(), file->points.begin() + 3), triangle.points);
  EXPECT_EQ(file->uv[1], triangle.uv[1]);
  EXPECT_EQ(file->triangles[0], triangle.triangles[0]);
  const OsgbImage& image = file->images.at(2);
  EXPECT_EQ(bytes->substr(image.offset, image.size), triangle.image);
  const OsgbPagedLod& lod = file->paged_lods.at(0);
  EXPECT_TRUE(lod.range_is_pixels);
  EXPECT_EQ(lod.center, Point3(1, 2, 3));
  EXPECT_EQ(lod.radius, 7);
  ASSERT_EQ(lod.children.size(), 2U);
  EXPECT_EQ(lod.children[0].file, "");
  EXPECT_EQ(lod.children[0].range_hi, 300);
  EXPECT_EQ(lod.children[1].file, "finer.osgb");
  EXPECT_EQ(lod.children[1].range_lo, 300);
}

TEST(NewOsgbTest, CanBeAppendedTo) {
  const OsgbNode node{{OsgbTriangle()}, "", Point3::Zero(), 0, 0};
  const auto bytes = NewOsgb({&node, 1}, "a.osgb");
  ASSERT_TRUE(bytes.ok()) << bytes.status();
  const auto more = AppendOsgb(*bytes, std::vector{OsgbTriangle()}, "a.osgb");
  ASSERT_TRUE(more.ok()) << more.status();
  EXPECT_EQ(ReadOsgb(*more, "a.osgb")->geometries.size(), 2U);
}

TEST(NewOsgbTest, RefusesNothingAndWrongIndices) {
  EXPECT_THAT(std::string(NewOsgb({}, "a.osgb").status().message()), HasSubstr("a.osgb: no geometry"));
  OsgbNode node{{OsgbTriangle()}, "", Point3::Zero(), 0, 0};
  node.geometries[0].triangles[0][2] = 3;
  EXPECT_THAT(std::string(NewOsgb({&node, 1}, "a.osgb").status().message()), HasSubstr("vertex index 3 of 3 vertices"));
}

}  // namespace
}  // namespace tilemend
