#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/common/codec/osgb/osgb_checks.h"
#include "tests/fuzz/osgb_property.h"
#include "tests/support/osgb_builder.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string Refusal(const absl::StatusOr<std::string>& result) {
  return result.ok() ? "" : std::string(result.status().message());
}

std::string AppendRefusal(std::string_view bytes, const OsgbPatch& patch) {
  return Refusal(AppendOsgb(bytes, {&patch, 1}, "a.osgb"));
}

class OsgbEditTest : public ::testing::TestWithParam<uint32_t> {
 protected:
  const std::string scene_ = BuiltOsgbScene(GetParam());
};
INSTANTIATE_TEST_SUITE_P(Versions, OsgbEditTest, ::testing::ValuesIn(kOsgbVersions));

TEST_P(OsgbEditTest, KeepsEverythingElse) { EXPECT_EQ(OsgbPropertyViolation(scene_), ""); }

TEST_P(OsgbEditTest, AppendsToTheGeodesThatArePicked) {
  const std::vector<OsgbPatch> patches = {OsgbTriangle(1), OsgbTriangle(0), OsgbTriangle(1)};
  const absl::StatusOr<std::string> bytes = AppendOsgb(scene_, patches, "a.osgb");
  ASSERT_TRUE(bytes.ok()) << bytes.status();
  const absl::StatusOr<OsgbFile> file = ReadOsgb(*bytes, "b.osgb");
  ASSERT_TRUE(file.ok()) << file.status();
  std::vector<int32_t> geodes;
  for (const OsgbGeometry& geometry : file->geometries) geodes.push_back(geometry.geode);
  EXPECT_THAT(geodes, ElementsAre(0, 0, 0, 1, 1, 1));
  const OsgbGeometry& last = file->geometries.back();
  EXPECT_EQ(file->points[static_cast<size_t>(last.first_vertex) + 2], Point3(10, 21, -30));
  EXPECT_EQ(file->images[static_cast<size_t>(last.texture)].name, "fill.jpg");
}

// Cuts what was inserted out again, and takes the counts and sizes back.
TEST_P(OsgbEditTest, EveryOtherByteStays) {
  const absl::StatusOr<std::string> appended = AppendOsgb(scene_, std::vector{OsgbTriangle(1)}, "a.osgb");
  ASSERT_TRUE(appended.ok()) << appended.status();
  const size_t added = appended->size() - scene_.size();
  const size_t end = scene_.size();  // the second geode ends with the file
  EXPECT_EQ(appended->find("osg::Geometry", end), end + 4);
  EXPECT_GT(added, 400u);
  size_t changed = 0;
  for (size_t i = 0; i < end; ++i) changed += scene_[i] != (*appended)[i] ? 1 : 0;
  // The count, and the sizes of the brackets of list, geode, list, PagedLOD, list and group: two bytes change in each.
  EXPECT_LE(changed, GetParam() < 99 ? 1u : 1u + 6 * 2);
}

TEST_P(OsgbEditTest, WithoutPatchesTheBytesAreTheSame) {
  EXPECT_EQ(*AppendOsgb(scene_, {}, "a.osgb"), scene_);
  EXPECT_EQ(*DropOsgbTriangles(scene_, std::vector<bool>(6), "a.osgb"), scene_);
}

TEST_P(OsgbEditTest, DropsTrianglesOfListsAndWholeStrips) {
  const absl::StatusOr<std::string> bytes = DropOsgbTriangles(scene_, {false, true, true, true, true, true}, "a.osgb");
  ASSERT_TRUE(bytes.ok()) << bytes.status();
  const absl::StatusOr<OsgbFile> file = ReadOsgb(*bytes, "b.osgb");
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_THAT(file->triangles, ElementsAre(Triangle{0, 1, 2}));
  EXPECT_EQ(file->points.size(), 12u);
  EXPECT_EQ(file->images.size(), 3u);
}

TEST_P(OsgbEditTest, RefusesToDropAPartOfAStrip) {
  EXPECT_THAT(Refusal(DropOsgbTriangles(scene_, {false, false, true, false, false, false}, "a.osgb")),
              HasSubstr("1 of 2 triangles cannot be taken out of a primitive set that is no list of triangles"));
}

TEST_P(OsgbEditTest, DropsWhatWasAppended) {
  const absl::StatusOr<std::string> appended = AppendOsgb(scene_, std::vector{OsgbTriangle(0)}, "a.osgb");
  ASSERT_TRUE(appended.ok()) << appended.status();
  const absl::StatusOr<std::string> bytes =
      DropOsgbTriangles(*appended, {false, false, false, false, true, false, false}, "a.osgb");
  ASSERT_TRUE(bytes.ok()) << bytes.status();
  const absl::StatusOr<OsgbFile> file = ReadOsgb(*bytes, "b.osgb");
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_EQ(file->triangles.size(), 6u);
  EXPECT_EQ(file->geometries[2].triangle_count, 0);
  EXPECT_EQ(file->geometries[2].vertex_count, 3);
}

TEST(OsgbAppendTest, PointsAreInTheFrameOfTheScene) {
  OsgbBuilder builder;
  const std::string scene = builder.Scene(
      [&] { builder.Translation(0.1, 4096, -7, {[&] { builder.Geode({[&] { builder.Geometry({}); }}); }}); });
  const absl::StatusOr<OsgbFile> before = ReadOsgb(scene, "a.osgb");
  ASSERT_TRUE(before.ok()) << before.status();
  OsgbPatch patch = OsgbTriangle();
  patch.points = {before->points[0], before->points[2], before->points[1]};
  const absl::StatusOr<std::string> bytes = AppendOsgb(scene, std::vector{patch}, "a.osgb");
  ASSERT_TRUE(bytes.ok()) << bytes.status();
  const absl::StatusOr<OsgbFile> after = ReadOsgb(*bytes, "b.osgb");
  ASSERT_TRUE(after.ok()) << after.status();
  EXPECT_EQ(after->points[4], before->points[0]);
  EXPECT_EQ(after->points[5], before->points[2]);
}

// In a group with geometries of its own, and in one below it that ends where it does.
TEST(OsgbAppendTest, AppendsBesideGeometriesWithoutAGeode) {
  for (const uint32_t version : {154u, 161u}) {
    OsgbBuilder builder(version);
    const auto geometry = [&] { builder.Geometry({}); };
    const std::string bytes = builder.Scene([&] { builder.Group({geometry, [&] { builder.Group({geometry}); }}); });
    const std::vector<OsgbPatch> patches = {OsgbTriangle(0), OsgbTriangle(1)};
    const absl::StatusOr<std::string> appended = AppendOsgb(bytes, patches, "a.osgb");
    ASSERT_TRUE(appended.ok()) << appended.status();
    const absl::StatusOr<OsgbFile> file = ReadOsgb(*appended, "b.osgb");
    ASSERT_TRUE(file.ok()) << version << ": " << file.status();
    std::vector<int32_t> geodes;
    for (const OsgbGeometry& g : file->geometries) geodes.push_back(g.geode);
    EXPECT_THAT(geodes, ElementsAre(0, 1, 1, 0)) << version;
  }
}

TEST(OsgbAppendTest, RefusesGeometryBelowAPagedLod) {
  OsgbBuilder builder(161);
  const std::string bytes = builder.Scene([&] { builder.PagedLod("b.osgb", [&] { builder.Geometry({}); }); });
  ASSERT_EQ(OsgbRefusal(bytes), "");
  EXPECT_THAT(AppendRefusal(bytes, OsgbTriangle(0)), HasSubstr("a child of an osg::PagedLOD"));
}

TEST(OsgbAppendTest, RefusesFilesWithoutAPlaceForIt) {
  OsgbBuilder empty;
  EXPECT_THAT(AppendRefusal(empty.Scene([&] { empty.Geode({}); }), OsgbTriangle()), HasSubstr("osg::Geode 0 is empty"));
  OsgbBuilder none;
  EXPECT_THAT(AppendRefusal(none.Scene([&] { none.Group({}); }), OsgbTriangle()),
              HasSubstr("a.osgb: new geometry 0: the file has 0 osg::Geode, none with index 0"));
  EXPECT_THAT(AppendRefusal(BuiltOsgbScene(80), OsgbTriangle(2)), HasSubstr("none with index 2"));
  EXPECT_THAT(AppendRefusal(BuiltOsgbScene(80), OsgbTriangle(-1)), HasSubstr("none with index -1"));
  EXPECT_THAT(AppendRefusal("", OsgbTriangle()), HasSubstr("a.osgb: byte 0: "));
}

TEST(OsgbAppendTest, RefusesInconsistentGeometry) {
  const auto refusal = [](const std::function<void(OsgbPatch&)>& change) {
    OsgbPatch patch = OsgbTriangle();
    change(patch);
    return AppendRefusal(BuiltOsgbScene(80), patch);
  };
  EXPECT_EQ(refusal([](OsgbPatch&) {}), "");
  EXPECT_THAT(refusal([](OsgbPatch& p) { p.triangles[0][1] = 3; }), HasSubstr("vertex index 3 of 3 vertices"));
  EXPECT_THAT(refusal([](OsgbPatch& p) { p.triangles[0][1] = -1; }), HasSubstr("vertex index -1"));
  EXPECT_THAT(refusal([](OsgbPatch& p) { p.points[1].x() = NAN; }), HasSubstr("at most 1e9 m"));
  EXPECT_THAT(refusal([](OsgbPatch& p) { p.uv.pop_back(); }), HasSubstr("2 texture coordinates for 3 vertices"));
}

TEST(OsgbAppendTest, RefusesFilesWithoutFreeIds) {
  OsgbBuilder builder;
  builder.next_id = 0xfffffff9;
  const std::string scene = builder.Scene([&] { builder.Geode({[&] { builder.Geometry({}); }}); });
  EXPECT_THAT(AppendRefusal(scene, OsgbTriangle()), HasSubstr("no ids are left for new objects"));
}

TEST(OsgbDropTest, DropsConsecutiveVerticesAsAWhole) {
  for (const uint32_t version : {80u, 161u}) {
    const std::string scene = BuiltOsgbGeometry({.indices = {0, 3}, .type = 50}, version);
    const absl::StatusOr<std::string> bytes = DropOsgbTriangles(scene, {true}, "a.osgb");
    ASSERT_TRUE(bytes.ok()) << bytes.status();
    EXPECT_EQ(bytes->size(), scene.size());
    EXPECT_TRUE(ReadOsgb(*bytes, "b.osgb")->triangles.empty());
  }
}

TEST(OsgbDropTest, RefusesAnotherNumberOfMarks) {
  EXPECT_THAT(Refusal(DropOsgbTriangles(BuiltOsgbScene(80), std::vector<bool>(5), "a.osgb")),
              HasSubstr("a.osgb: 5 marks for 6 triangles"));
}

}  // namespace
}  // namespace tilemend
