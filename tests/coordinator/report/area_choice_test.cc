#include "coordinator/report/area_choice.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/store/digest.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

constexpr char kHalf[] = R"({"type": "Polygon", "coordinates": [[[0, 0], [50, 0], [50, 100], [0, 100], [0, 0]]]})";

Scene OneCell() {
  Scene scene;
  scene.grid = {{0, 0}, {100, 100}};
  scene.cols = scene.rows = 1;
  scene.tiles = {{{0, 0}, "a.ply"}};
  return scene;
}

TEST(AreaChoiceTest, WithoutAnyTheSceneStaysAsItIs) {
  Scene scene = OneCell();
  const auto digest = ApplyAreaChoice("", scene);
  ASSERT_TRUE(digest.ok()) << digest.status();
  EXPECT_EQ(*digest, "");
  EXPECT_FALSE(scene.area_known);
  EXPECT_TRUE(scene.area.empty());
}

TEST(AreaChoiceTest, AFileIsTheAreaAndCountsByItsContent) {
  const TemporaryFolder folder;
  const std::string path = folder.Write("area.geojson", kHalf);
  for (const bool by_scene : {false, true}) {
    Scene scene = OneCell();
    if (by_scene) scene.area_file = path;
    const auto digest = ApplyAreaChoice(by_scene ? "" : path, scene);
    ASSERT_TRUE(digest.ok()) << digest.status();
    EXPECT_EQ(*digest, Sha256Hex(kHalf));
    EXPECT_TRUE(scene.area_known);
    EXPECT_TRUE(Contains(scene.area, {25, 50}));
    EXPECT_FALSE(Contains(scene.area, {75, 50}));
  }
}

TEST(AreaChoiceTest, SaysThatTheAreaIsNotKnownWhereItIsNot) {
  const TemporaryFolder folder;
  const std::string path = folder.Write("area.geojson", kHalf);
  for (const bool given : {false, true}) {
    Scene scene = OneCell();
    scene.found_by_name = true;
    ASSERT_TRUE(ApplyAreaChoice(given ? path : "", scene).ok());
    EXPECT_EQ(scene.warnings.size(), given ? 0U : 1U);
    if (!given) {
      EXPECT_THAT(scene.warnings[0], HasSubstr("the area is not known"));
    }
  }
}

TEST(AreaChoiceTest, AnAreaInTheSceneAddsItsCells) {
  Scene scene = OneCell();
  scene.area = {{{{0, 0}, {150, 0}, {150, 100}, {0, 100}}}};
  ASSERT_TRUE(ApplyAreaChoice("", scene).ok());
  EXPECT_THAT(scene.tiles, SizeIs(2));
}

TEST(AreaChoiceTest, NamesAFileThatCannotBeUsed) {
  const TemporaryFolder folder;
  Scene scene = OneCell();
  EXPECT_TRUE(absl::IsNotFound(ApplyAreaChoice(folder / "none.geojson", scene).status()));
  const std::string flat =
      folder.Write("flat.geojson", R"({"type": "Polygon", "coordinates": [[[0, 0], [50, 0], [20, 0], [0, 0]]]})");
  const absl::Status status = ApplyAreaChoice(flat, scene).status();
  EXPECT_TRUE(absl::IsInvalidArgument(status)) << status;
  EXPECT_THAT(std::string(status.message()), HasSubstr("flat.geojson: "));
}

TEST(CheckCrsTest, WarnsOfOneThatNobodyKnows) {
  for (const char* crs : {"EPSG:999999", "rubbish", "EPSG:4326"}) {
    Scene scene = OneCell();
    scene.root = "/scene";
    scene.crs = crs;
    CheckCrs(scene);
    ASSERT_THAT(scene.warnings, SizeIs(1)) << crs;
    EXPECT_THAT(scene.warnings[0], HasSubstr(std::string("/scene/scene.json: crs: '") + crs + "': "));
  }
}

TEST(CheckCrsTest, IsQuietAboutOthers) {
  for (const char* crs : {"", "EPSG:25832", "ENU:48.1,11.5", "+proj=utm +zone=32 +datum=WGS84"}) {
    Scene scene = OneCell();
    scene.crs = crs;
    CheckCrs(scene);
    EXPECT_THAT(scene.warnings, SizeIs(0)) << crs;
  }
}

}  // namespace
}  // namespace tilemend
