#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "common/codec/osgb/osgb_parse.h"
#include "tests/common/codec/osgb/osgb_checks.h"
#include "tests/support/osgb_builder.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class OsgbVersionTest : public ::testing::TestWithParam<uint32_t> {};
INSTANTIATE_TEST_SUITE_P(Versions, OsgbVersionTest, ::testing::ValuesIn(kOsgbVersions));

TEST_P(OsgbVersionTest, ReadsGeometryImagesAndPaging) {
  const std::string bytes = BuiltOsgbScene(GetParam());
  const absl::StatusOr<OsgbFile> file = ReadOsgb(bytes, "a.osgb");
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_EQ(file->version, GetParam());
  EXPECT_EQ(file->has_brackets, GetParam() >= 99);
  ASSERT_EQ(file->geometries.size(), 3u);
  EXPECT_EQ(file->points.size(), 12u);
  EXPECT_EQ(file->points[2], Point3(2, 2, 1.5));
  EXPECT_THAT(file->uv[2], ElementsAre(1, 1));
  EXPECT_THAT(file->triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}, Triangle{4, 5, 7}, Triangle{7, 5, 6},
                                           Triangle{8, 9, 10}, Triangle{8, 10, 11}));
  EXPECT_EQ(file->geometries[1].first_vertex, 4);
  EXPECT_EQ(file->geometries[1].first_triangle, 2);
  EXPECT_EQ(file->geometries[1].triangle_count, 2);
  EXPECT_EQ(file->geometries[1].geode, 0);
  EXPECT_EQ(file->geometries[2].geode, 1);
  EXPECT_EQ(file->geometries[2].texture, 2);
  ASSERT_EQ(file->images.size(), 3u);
  EXPECT_EQ(file->images[2].name, "tile_0.jpg");
  EXPECT_EQ(bytes.substr(file->images[2].offset, file->images[2].size), BuiltGeometry().image);
}

TEST_P(OsgbVersionTest, ReadsPagedLods) {
  const absl::StatusOr<OsgbFile> file = ReadOsgb(BuiltOsgbScene(GetParam()), "a.osgb");
  ASSERT_TRUE(file.ok()) << file.status();
  ASSERT_EQ(file->paged_lods.size(), 2u);
  const OsgbPagedLod& lod = file->paged_lods[1];
  EXPECT_TRUE(lod.has_center);
  EXPECT_TRUE(lod.range_is_pixels);
  EXPECT_EQ(lod.center, Point3(1, 1.5, 2));
  EXPECT_EQ(lod.radius, 8);
  ASSERT_EQ(lod.children.size(), 2u);
  EXPECT_EQ(lod.children[0].file, "");
  EXPECT_EQ(lod.children[0].range_hi, 16);
  EXPECT_EQ(lod.children[1].file, "tile_L20_01.osgb");
  EXPECT_EQ(lod.children[1].range_lo, 16);
  ASSERT_EQ(file->geodes.size(), 2u);
  EXPECT_EQ(file->geodes[1].paged_lod, 1);
}

TEST_P(OsgbVersionTest, RefusesEveryTruncationWithAPlace) {
  const std::string bytes = BuiltOsgbScene(GetParam());
  for (size_t size = 0; size < bytes.size(); ++size) {
    ASSERT_THAT(OsgbRefusal(std::string_view(bytes).substr(0, size)), StartsWith("a.osgb: byte ")) << size;
  }
}

TEST_P(OsgbVersionTest, RefusesBytesBehindTheEnd) {
  EXPECT_THAT(OsgbRefusal(BuiltOsgbScene(GetParam()) + "xyz"), HasSubstr("3 bytes follow the end of the scene"));
}

TEST(OsgbSceneTest, BracketsAreReadByTheirAttributeNotByVersion) {
  OsgbBuilder builder(130);
  builder.has_brackets = false;
  const std::string bytes = builder.Scene([&] { builder.Geode({[&] { builder.Geometry({}); }}); });
  EXPECT_EQ(OsgbRefusal(bytes), "");
}

TEST(OsgbSceneTest, RefusesOtherHeadersByName) {
  const auto refusal = [](const std::function<void(OsgbBuilder&)>& change) {
    OsgbBuilder builder;
    change(builder);
    return OsgbRefusal(builder.Scene([&] { builder.Geode({}); }));
  };
  EXPECT_EQ(refusal([](OsgbBuilder&) {}), "");
  EXPECT_THAT(refusal([](OsgbBuilder& b) { b.compressor = "zlib"; }),
              HasSubstr("the compressor zlib is not supported"));
  EXPECT_THAT(refusal([](OsgbBuilder& b) { b.attributes = 2; }), HasSubstr("schema data is not supported"));
  EXPECT_THAT(refusal([](OsgbBuilder& b) { b.attributes = 1; }), HasSubstr("versions of further libraries"));
  EXPECT_THAT(refusal([](OsgbBuilder& b) { b.attributes = 8; }), HasSubstr("the attributes 8 are not supported"));
  EXPECT_THAT(refusal([](OsgbBuilder& b) { b.version = 79; }), HasSubstr("version 79 is not supported"));
  EXPECT_THAT(refusal([](OsgbBuilder& b) { b.version = 162; }), HasSubstr("versions 80 to 161 are"));
}

TEST(OsgbSceneTest, RefusesOtherSignaturesAndKinds) {
  std::string bytes = BuiltOsgbScene(80);
  std::string image = bytes;
  image[8] = 2;
  EXPECT_THAT(OsgbRefusal(image), HasSubstr("expected a scene"));
  std::reverse(bytes.begin(), bytes.begin() + 4);
  EXPECT_THAT(OsgbRefusal(bytes), HasSubstr("byte 0: expected the signature of a little-endian OSGB file"));
}

TEST(OsgbSceneTest, TranslationsMovePointsGeodesAndCentres) {
  for (const uint32_t version : {80u, 161u}) {
    OsgbBuilder builder(version);
    const auto geode = [&] { builder.Geode({[&] { builder.Geometry({}); }}); };
    const absl::StatusOr<OsgbFile> file = ReadOsgb(builder.Scene([&] {
      builder.Group({[&] {
                       builder.Translation(100, 0, 0, {[&] {
                                             builder.Translation(0, 200, 0.5, {[&] { builder.PagedLod("x", geode); }});
                                           }});
                     },
                     geode});
    }),
                                                   "a.osgb");
    ASSERT_TRUE(file.ok()) << file.status();
    EXPECT_EQ(file->points[1], Point3(102, 200, 1.5));
    EXPECT_EQ(file->points[5], Point3(2, 0, 1));
    EXPECT_EQ(file->geodes[0].translation, Point3(100, 200, 0.5));
    EXPECT_EQ(file->geodes[1].translation, Point3(0, 0, 0));
    EXPECT_EQ(file->paged_lods[0].center, Point3(101, 201.5, 2.5));
  }
}

TEST(OsgbSceneTest, RefusesOtherTransforms) {
  const auto refusal = [](const std::array<double, 16>& matrix, uint32_t frame) {
    OsgbBuilder builder;
    return OsgbRefusal(builder.Scene([&] { builder.Transform(matrix, {[&] { builder.Geode({}); }}, frame); }));
  };
  const std::array<double, 16> identity = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  EXPECT_EQ(refusal(identity, 0), "");
  EXPECT_THAT(refusal(identity, 1), HasSubstr("an osg::MatrixTransform that does more than translate"));
  EXPECT_THAT(refusal({0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, 0), HasSubstr("osg::MatrixTransform"));
  EXPECT_THAT(refusal({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, NAN, 0, 0, 1}, 0), HasSubstr("osg::MatrixTransform"));
}

TEST(OsgbSceneTest, RefusesOtherNodesByName) {
  OsgbBuilder builder;
  EXPECT_THAT(OsgbRefusal(builder.Scene([&] { builder.Node("osg::Switch", {}); })),
              HasSubstr("an object of class osg::Switch is not supported here"));
  OsgbBuilder drawable;
  EXPECT_THAT(OsgbRefusal(drawable.Scene([&] { drawable.Geode({[&] { drawable.Node("osg::ShapeDrawable", {}); }}); })),
              HasSubstr("osg::ShapeDrawable"));
}

TEST(OsgbSceneTest, RefusesNodesWithSeveralParents) {
  OsgbBuilder nodes;
  EXPECT_THAT(OsgbRefusal(nodes.Scene([&] {
                nodes.Group({[&] { nodes.Geode({}); }, [&] { nodes.Reference("osg::Geode", 2); }});
              })),
              HasSubstr("an osg::Geode with several parents is not supported"));
  OsgbBuilder drawables;
  EXPECT_THAT(OsgbRefusal(drawables.Scene([&] {
                drawables.Geode({[&] { drawables.Geometry({}); }, [&] { drawables.Reference("osg::Geometry", 2); }});
              })),
              HasSubstr("a geometry in several geodes is not supported"));
}

// Those of one node are a geode of their own.
TEST(OsgbSceneTest, ReadsGeometryWithoutAGeode) {
  OsgbBuilder builder(161);
  const auto geometry = [&] { builder.Geometry({}); };
  const absl::StatusOr<OsgbFile> file = ReadOsgb(builder.Scene([&] {
    builder.Group({geometry, [&] { builder.Geode({geometry}); }, geometry});
  }),
                                                 "a.osgb");
  ASSERT_TRUE(file.ok()) << file.status();
  ASSERT_EQ(file->geodes.size(), 2u);
  EXPECT_EQ(file->geometries.at(0).geode, 0);
  EXPECT_EQ(file->geometries.at(1).geode, 1);
  EXPECT_EQ(file->geometries.at(2).geode, 0);
}

TEST(OsgbSceneTest, LimitsTheDepthOfNodes) {
  const auto refusal = [](int depth) {
    OsgbBuilder builder;
    std::function<void(int)> nest = [&](int left) {
      if (left == 0) {
        builder.Geode({[&] { builder.Geometry({}); }});
      } else {
        builder.Group({[&] { nest(left - 1); }});
      }
    };
    return OsgbRefusal(builder.Scene([&] { nest(depth); }));
  };
  EXPECT_EQ(refusal(50), "");
  EXPECT_THAT(refusal(60), HasSubstr("nodes are nested over 56 deep"));
}

TEST(OsgbSceneTest, LayoutHasTheLargestIds) {
  const absl::StatusOr<OsgbLayout> old = ParseOsgb(BuiltOsgbScene(80), "a.osgb");
  ASSERT_TRUE(old.ok());
  EXPECT_EQ(old->max_object_id, 17u);  // group, 2 PagedLODs, 2 geodes, 3 times geometry, state set, texture, image
  EXPECT_EQ(old->max_array_id, 7u);
  const absl::StatusOr<OsgbLayout> recent = ParseOsgb(BuiltOsgbScene(130), "a.osgb");
  ASSERT_TRUE(recent.ok());
  EXPECT_EQ(recent->max_object_id, 27u);  // and 7 arrays and 3 primitive sets
  EXPECT_EQ(recent->max_array_id, 0u);
}

}  // namespace
}  // namespace tilemend
