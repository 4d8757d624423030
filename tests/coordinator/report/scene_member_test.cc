#include "coordinator/report/scene_member.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace tilemend {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
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

absl::StatusOr<std::string> Checked(const Scene& other) {
  return CheckSceneMember(FileOf(SceneMemberOf(other)), "d.geojson", CityScene());
}

TEST(SceneMemberTest, AFileOfTheSceneIsTaken) {
  Scene moved = CityScene();
  moved.root = "/elsewhere/city";
  EXPECT_EQ(Checked(moved).value(), "");
}

TEST(SceneMemberTest, AFolderOfAnotherNameIsWarnedOf) {
  Scene renamed = CityScene();
  renamed.root = "/data/harbour";
  EXPECT_EQ(
      Checked(renamed).value(),
      "d.geojson: its decisions are on a scene in folder 'harbour', and this one is in 'city'; they have the same "
      "grid; if it is another scene, give the file of this one");
}

TEST(SceneMemberTest, AFileOfAnotherGridIsRefused) {
  Scene crs = CityScene(), corner = CityScene(), size = CityScene();
  crs.crs = "";
  corner.grid.corner.x() += 1;
  size.grid.cell_size.y() = 100;
  const auto message_of = [](const Scene& other) {
    const absl::Status refused = Checked(other).status();
    EXPECT_TRUE(absl::IsInvalidArgument(refused)) << other.root;
    return std::string(refused.message());
  };
  EXPECT_THAT(
      message_of(corner),
      AllOf(HasSubstr("d.geojson: its decisions are on scene 'city' (EPSG:25832, cells of 80 x 80 m from 499921, "
                      "4100000), not on 'city' ("),
            HasSubstr("; different: the corner of the grid; give the file of this scene")));
  EXPECT_THAT(message_of(crs), HasSubstr("; different: the CRS; give"));
  EXPECT_THAT(message_of(size), HasSubstr("; different: the cell size; give"));
  size.crs = "";
  EXPECT_THAT(message_of(size), HasSubstr("; different: the CRS, the cell size; give"));
}

TEST(SceneMemberTest, AFileWithoutTheMemberIsTaken) {
  for (const char* text : {"{}", "[", "PK", "", R"({"tilemend_scene": null})",
                           R"({"features": [{"tilemend_scene": 3}]})", R"({"tilemend_scene": 3)"}) {
    EXPECT_EQ(CheckSceneMember(text, "d.geojson", CityScene()).value(), "") << text;
  }
  EXPECT_FALSE(CheckSceneMember(R"({"tilemend_scene": {"name": "\u0007"}})", "d.geojson", CityScene()).ok());
}

TEST(SceneMemberTest, AMemberThatIsNoObjectIsRefusedWithItsLine) {
  for (const auto& [value, what] :
       {std::pair("3", "a number"), {"\"city\"", "text"}, {"[1]", "a list"}, {"true", "true"}}) {
    const std::string text =
        std::string("{\n\"type\": \"FeatureCollection\",\n\"tilemend_scene\": ") + value + ",\n\"a\": 1}";
    const absl::Status refused = CheckSceneMember(text, "d.geojson", CityScene()).status();
    EXPECT_TRUE(absl::IsInvalidArgument(refused)) << value;
    EXPECT_THAT(
        std::string(refused.message()),
        AllOf(HasSubstr(std::string("d.geojson: line 3: tilemend_scene is ") + what), HasSubstr("expected an object")));
  }
}

}  // namespace
}  // namespace tilemend
