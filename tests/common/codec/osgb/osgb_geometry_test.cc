#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/common/codec/osgb/osgb_checks.h"
#include "tests/support/osgb_builder.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class OsgbGeometryTest : public ::testing::TestWithParam<uint32_t> {
 protected:
  std::string Refusal(const BuiltGeometry& geometry) const {
    return OsgbRefusal(BuiltOsgbGeometry(geometry, GetParam()));
  }
  std::vector<Triangle> Triangles(const BuiltGeometry& geometry) const {
    const absl::StatusOr<OsgbFile> file = ReadOsgb(BuiltOsgbGeometry(geometry, GetParam()), "a.osgb");
    EXPECT_TRUE(file.ok()) << file.status();
    return file.ok() ? file->triangles : std::vector<Triangle>();
  }
};
INSTANTIATE_TEST_SUITE_P(Versions, OsgbGeometryTest, ::testing::Values(80u, 97u, 100u, 130u, 147u, 154u, 161u));

TEST_P(OsgbGeometryTest, ReadsIndicesOfEveryWidth) {
  for (const uint32_t type : {52u, 53u, 54u}) {
    EXPECT_THAT(Triangles({.type = type}), ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3})) << type;
  }
}

TEST_P(OsgbGeometryTest, ReadsConsecutiveVertices) {
  EXPECT_THAT(Triangles({.indices = {1, 3}, .type = 50}), ElementsAre(Triangle{1, 2, 3}));
  EXPECT_THAT(Triangles({.indices = {0, 4}, .type = 50, .mode = 5}), ElementsAre(Triangle{0, 1, 2}, Triangle{2, 1, 3}));
  EXPECT_THAT(Refusal({.indices = {2, 3}, .type = 50}), HasSubstr("vertices 2 to 5 of a geometry with 4"));
}

TEST_P(OsgbGeometryTest, TurnsStripsAndFansIntoTriangles) {
  EXPECT_THAT(Triangles({.indices = {0, 1, 3, 2}, .mode = 5}), ElementsAre(Triangle{0, 1, 3}, Triangle{3, 1, 2}));
  EXPECT_THAT(Triangles({.indices = {0, 1, 2, 3}, .mode = 6}), ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}));
  EXPECT_TRUE(Triangles({.indices = {0}, .mode = 5}).empty());
}

TEST_P(OsgbGeometryTest, LeavesOutAnIncompleteTriangle) {
  EXPECT_THAT(Triangles({.indices = {0, 1, 2, 3, 0}}), ElementsAre(Triangle{0, 1, 2}));
}

TEST_P(OsgbGeometryTest, RefusesOtherPrimitivesByName) {
  EXPECT_THAT(Refusal({.mode = 7}), HasSubstr("primitives of mode QUADS are not supported"));
  EXPECT_THAT(Refusal({.mode = 0}), HasSubstr("primitives of mode POINTS are not supported"));
  EXPECT_THAT(Refusal({.mode = 99}), HasSubstr("primitives of mode 99 are not supported"));
  EXPECT_THAT(Refusal({.type = 51}), HasSubstr("osg::DrawArrayLengths"));
}

TEST_P(OsgbGeometryTest, RefusesIndicesOutOfRangeWithTheirPlace) {
  BuiltGeometry geometry;
  geometry.indices = {0, 1, 2, 0, 4, 3};
  const std::string bytes = BuiltOsgbGeometry(geometry, GetParam());
  const size_t place = bytes.find(std::string("\x04\0\0\0\x03\0\0\0", 8));
  EXPECT_EQ(OsgbRefusal(bytes),
            "a.osgb: byte " + std::to_string(place) + ": vertex index 4 in a geometry with 4 vertices");
}

TEST_P(OsgbGeometryTest, ReadsCoordinatesExactly) {
  BuiltGeometry geometry;
  geometry.points[1] = {-0.0F, 1e-45F, 999999.9375F};
  const absl::StatusOr<OsgbFile> file = ReadOsgb(BuiltOsgbGeometry(geometry, GetParam()), "a.osgb");
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_TRUE(std::signbit(file->points[1].x()));
  EXPECT_EQ(file->points[1].y(), double{1e-45F});
  EXPECT_EQ(file->points[1].z(), 999999.9375);
}

TEST_P(OsgbGeometryTest, RefusesCoordinatesThatAreNoPlaces) {
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), -2e9F}) {
    BuiltGeometry geometry;
    geometry.points[3] = {0, bad, 0};
    EXPECT_THAT(Refusal(geometry), HasSubstr("expected coordinates of at most 1e9 m"));
  }
}

TEST_P(OsgbGeometryTest, ToleratesNormalsAndMissingTextureCoordinates) {
  EXPECT_EQ(Refusal({.has_normals = true}), "");
  const absl::StatusOr<OsgbFile> file = ReadOsgb(BuiltOsgbGeometry({.uv = {}}, GetParam()), "a.osgb");
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_EQ(file->uv.size(), 4u);
  EXPECT_THAT(file->uv[2], ElementsAre(0, 0));
}

TEST_P(OsgbGeometryTest, RefusesArraysThatAreNotOfVertices) {
  EXPECT_THAT(Refusal({.binding = 1}), HasSubstr("the binding of osg::Vec3Array is 1; only BIND_PER_VERTEX"));
  EXPECT_THAT(Refusal({.vertex_class = "Vec3dArray"}),
              HasSubstr("expected an osg::Vec3Array, found an osg::Vec3dArray"));
  EXPECT_THAT(Refusal({.uv = {{0, 0}, {1, 1}}}), HasSubstr("2 texture coordinates for 4 vertices"));
}

TEST_P(OsgbGeometryTest, HasNoTextureWithoutAStateSet) {
  const absl::StatusOr<OsgbFile> file = ReadOsgb(BuiltOsgbGeometry({.image = ""}, GetParam()), "a.osgb");
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_EQ(file->geometries[0].texture, -1);
  EXPECT_TRUE(file->images.empty());
}

// Primitive sets of consecutive vertices take 16 bytes each, whatever number of triangles they stand for.
TEST(OsgbAmplificationTest, TrianglesAreBoundedByTheFile) {
  constexpr uint32_t kVertices = 5000;
  BuiltGeometry geometry;
  geometry.points.assign(kVertices, {1, 2, 3});
  geometry.uv.clear();
  geometry.type = 50;
  geometry.mode = 5;
  geometry.indices = {0, kVertices};
  std::string bytes = BuiltOsgbGeometry(geometry);
  ASSERT_EQ(OsgbRefusal(bytes), "");
  const std::string set("\x32\0\0\0\x05\0\0\0\0\0\0\0\x88\x13\0\0", 16);
  const size_t place = bytes.find(set);
  ASSERT_NE(place, std::string::npos);
  for (int i = 0; i < 200; ++i) bytes.insert(place, set);
  bytes[place - 4] = static_cast<char>(201);
  EXPECT_THAT(OsgbRefusal(bytes), HasSubstr("the geometries have more triangles than the file has bytes"));
}

// A geometry that shares its array of vertices takes about 100 bytes, whatever their number.
TEST(OsgbAmplificationTest, VerticesAreBoundedByTheFile) {
  OsgbBuilder builder;
  BuiltGeometry geometry;
  geometry.points.assign(2000, {1, 2, 3});
  geometry.uv.clear();
  geometry.image.clear();
  const auto sharing = [&](size_t geometries) {
    return builder.Scene([&] {
      std::vector<OsgbBuilder::Body> bodies(geometries, [&] {
        const size_t before = builder.out.size();
        builder.next_array_id = 1;
        builder.Geometry(geometry);
        if (before < 1000) return;
        // From the second on: without the array's type and values.
        const size_t values = builder.out.find(std::string("\x10\0\0\0\xd0\x07\0\0", 8), before);
        builder.out.erase(values, 8 + 2000 * 12);
      });
      builder.Geode(bodies);
    });
  };
  builder.next_id = 1;
  EXPECT_EQ(OsgbRefusal(sharing(3)), "");
  builder.next_id = 1;
  EXPECT_THAT(OsgbRefusal(sharing(100)), HasSubstr("the geometries have more vertices than the file has bytes"));
}

}  // namespace
}  // namespace tilemend
