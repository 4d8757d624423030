#include "coordinator/report/scene_member.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace tilemend {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using Json = nlohmann::ordered_json;

Scene CityScene() {
  Scene scene;
  scene.root = "/data/city/";
  scene.crs = "EPSG:25832";
  scene.origin = {500000, 4100000, 0};
  scene.grid = {{-80, 0}, {80, 80}};
  return scene;
}

std::string FileOf(const Json& member) {
  return Json{{"type", "FeatureCollection"}, {kSceneMember, member}, {"features", {{{"a", {1, 2}}}}}}.dump();
}

TEST(SceneMemberTest, NamesTheFolderTheCrsAndTheGrid) {
  EXPECT_EQ(SceneMemberOf(CityScene()), Json::parse(R"({"name": "city", "crs": "EPSG:25832",
                                                        "grid_corner": [499920, 4100000], "cell_size": [80, 80]})"));
  Scene stored = CityScene();
  stored.root = "s3://bucket/city";
  EXPECT_EQ(SceneMemberOf(stored), SceneMemberOf(CityScene()));
}

TEST(SceneMemberTest, AFileOfTheSceneIsTaken) {
  Scene moved = CityScene();
  moved.root = "/elsewhere/city";
  EXPECT_TRUE(CheckSceneMember(FileOf(SceneMemberOf(moved)), "d.geojson", CityScene()).ok());
}

TEST(SceneMemberTest, AFileOfAnotherSceneIsRefusedByName) {
  Scene name = CityScene(), crs = CityScene(), corner = CityScene(), size = CityScene();
  name.root = "/data/harbour";
  crs.crs = "";
  corner.grid.corner.x() += 1;
  size.grid.cell_size.y() = 100;
  const auto message_of = [](const Scene& other) {
    const absl::Status refused = CheckSceneMember(FileOf(SceneMemberOf(other)), "d.geojson", CityScene());
    EXPECT_TRUE(absl::IsInvalidArgument(refused)) << other.root;
    return std::string(refused.message());
  };
  const std::string hint = "take the member tilemend_scene out of the file";
  EXPECT_THAT(message_of(name),
              AllOf(HasSubstr("d.geojson: its decisions are on scene 'harbour' (EPSG:25832, cells of 80 x 80 m from "
                              "499920, 4100000), not on 'city' ("),
                    HasSubstr("; different: the name of the scene's folder; give the file of this scene, or, if this "
                              "is the same scene, take the member tilemend_scene out of the file")));
  EXPECT_THAT(message_of(crs), AllOf(HasSubstr("; different: the CRS; give"), Not(HasSubstr(hint))));
  EXPECT_THAT(message_of(corner), AllOf(HasSubstr("; different: the corner of the grid; give"), Not(HasSubstr(hint))));
  EXPECT_THAT(message_of(size), AllOf(HasSubstr("; different: the cell size; give"), Not(HasSubstr(hint))));
  size.root = name.root;
  EXPECT_THAT(message_of(size), AllOf(HasSubstr("; different: the name of the scene's folder, the cell size; give"),
                                      Not(HasSubstr(hint))));
}

TEST(SceneMemberTest, AFileWithoutTheMemberIsTaken) {
  for (const char* text : {"{}", "[", "PK", "", R"({"tilemend_scene": 3})", R"({"tilemend_scene": null})"}) {
    EXPECT_TRUE(CheckSceneMember(text, "d.geojson", CityScene()).ok()) << text;
  }
  EXPECT_FALSE(CheckSceneMember(R"({"tilemend_scene": {"name": "\u0007"}})", "d.geojson", CityScene()).ok());
}

}  // namespace
}  // namespace tilemend
