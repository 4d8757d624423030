#include "common/codec/osgb/osgb_encode.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/codec/osgb/osgb_checks.h"
#include "tests/support/osgb_builder.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// A file whose geode holds the encoded geometry of `patch` alone.
std::string SceneOf(const OsgbPatch& patch, uint32_t version, const Point3& translation = Point3::Zero()) {
  OsgbBuilder builder(version);
  OsgbEncoding encoding{.version = version,
                        .bracket_bytes = !builder.has_brackets ? size_t{0}
                                         : version >= 149      ? 8
                                                               : 4,
                        .next_object_id = 100};
  return builder.Scene(
      [&] { builder.Geode({[&] { builder.out += EncodeOsgbGeometry(patch, translation, encoding); }}); });
}

class OsgbEncodeTest : public ::testing::TestWithParam<uint32_t> {};
INSTANTIATE_TEST_SUITE_P(Versions, OsgbEncodeTest, ::testing::ValuesIn(kOsgbVersions));

TEST_P(OsgbEncodeTest, ReadsBackAsEncoded) {
  const OsgbPatch patch = OsgbTriangle();
  const std::string bytes = SceneOf(patch, GetParam());
  const absl::StatusOr<OsgbFile> file = ReadOsgb(bytes, "a.osgb");
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_EQ(file->points, patch.points);
  EXPECT_EQ(file->uv, patch.uv);
  EXPECT_EQ(file->triangles, patch.triangles);
  ASSERT_EQ(file->images.size(), 1u);
  EXPECT_EQ(file->images[0].name, "fill.jpg");
  EXPECT_EQ(bytes.substr(file->images[0].offset, file->images[0].size), patch.image);
  EXPECT_EQ(file->geometries[0].texture, 0);
}

TEST_P(OsgbEncodeTest, PlainColourHasNoTexture) {
  OsgbPatch patch = OsgbTriangle();
  patch.image.clear();
  patch.colour = {255, 51, 0};
  const std::string bytes = SceneOf(patch, GetParam());
  const absl::StatusOr<OsgbFile> file = ReadOsgb(bytes, "a.osgb");
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_EQ(file->points, patch.points);
  EXPECT_TRUE(file->images.empty());
  EXPECT_THAT(bytes, Not(HasSubstr("osg::Texture2D")));
  EXPECT_THAT(bytes, HasSubstr(std::string("\0\0\x80\x3f\xcd\xcc\x4c\x3e\0\0\0\0\0\0\x80\x3f", 16)));
}

TEST_P(OsgbEncodeTest, TakesTheTranslationOff) {
  const absl::StatusOr<OsgbFile> file = ReadOsgb(SceneOf(OsgbTriangle(), GetParam(), {5, -5, 0.5}), "a.osgb");
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_EQ(file->points[0], Point3(5, 25, 29.5));
}

TEST_P(OsgbEncodeTest, UsesNoMoreIdsThanItSays) {
  OsgbEncoding encoding{.version = GetParam(), .next_object_id = 100, .next_array_id = 10};
  EncodeOsgbGeometry(OsgbTriangle(), Point3::Zero(), encoding);
  EXPECT_EQ(encoding.next_object_id, GetParam() < 112 ? 105u : 108u);
  EXPECT_EQ(encoding.next_array_id, GetParam() < 112 ? 12u : 10u);
  EXPECT_LE(encoding.next_object_id, 100 + kOsgbIdsOfGeometry);
}

}  // namespace
}  // namespace tilemend
