#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_replace.h"
#include "common/grid/scene.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr char kScene[] =
    R"({"crs": "EPSG:32650", "origin": [500000, 4100000, 12.5], "cell_size": 250, "cols": 2, "rows": 2,
 "future": {"deep": [1]},
 "tiles": [{"col": 1, "row": 1, "path": null}, {"col": 0, "row": 0, "path": "tiles/a.ply"},
           {"col": 1, "row": 0, "path": "./tiles/b.OBJ", "note": 1}]})";

absl::StatusOr<ConvexHull> NoBounds(const std::string& path, const TileFrame&) {
  ADD_FAILURE() << "a scene with scene.json reads no mesh, but read " << path;
  return ConvexHull();
}

class SceneJsonTest : public testing::Test {
 protected:
  SceneJsonTest() {
    folder_.Write("tiles/a.ply", "");
    folder_.Write("tiles/b.OBJ", "");
  }
  absl::StatusOr<Scene> Load(const std::string& json) {
    folder_.Write("scene.json", json);
    return LoadScene(folder_.path(), NoBounds);
  }
  // The status of kScene with `from` replaced by `to`.
  absl::Status Changed(const std::string& from, const std::string& to) {
    std::string json(kScene);
    EXPECT_EQ(absl::StrReplaceAll({{from, to}}, &json), 1) << from;
    return Load(json).status();
  }
  void ExpectInvalid(const std::string& from, const std::string& to, const std::string& message) {
    const absl::Status status = Changed(from, to);
    EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument) << to;
    EXPECT_THAT(std::string(status.message()), AllOf(HasSubstr("scene.json: "), HasSubstr(message)));
  }
  TemporaryFolder folder_;
};

std::vector<std::string> Paths(const Scene& scene) {
  std::vector<std::string> paths;
  for (const SceneTile& tile : scene.tiles) paths.push_back(ToString(tile.cell) + " " + tile.path);
  return paths;
}

TEST_F(SceneJsonTest, ReadsEveryField) {
  const auto scene = Load(kScene);
  ASSERT_TRUE(scene.ok()) << scene.status();
  EXPECT_EQ(scene->root, folder_.path());
  EXPECT_EQ(scene->crs, "EPSG:32650");
  EXPECT_EQ(scene->origin, Point3(500000, 4100000, 12.5));
  EXPECT_EQ(scene->grid.cell_size, Point2(250, 250));
  EXPECT_EQ(scene->grid.corner, Point2(0, 0));
  EXPECT_EQ(scene->cols, 2);
  EXPECT_EQ(scene->rows, 2);
  EXPECT_TRUE(scene->area_known);
  EXPECT_TRUE(scene->warnings.empty());
  EXPECT_THAT(Paths(*scene), ElementsAre("+000_+000 tiles/a.ply", "+001_+000 tiles/b.OBJ", "+001_+001 "));
}

TEST_F(SceneJsonTest, ReadsTheFileItselfAndOblongCells) {
  EXPECT_TRUE(Changed("\"cell_size\": 250", "\"cell_size\": [20.5, 15.25], \"grid_corner\": [54.5, -211.75]").ok());
  const auto scene = LoadScene(folder_ / "scene.json", nullptr);
  ASSERT_TRUE(scene.ok()) << scene.status();
  EXPECT_EQ(scene->grid.cell_size, Point2(20.5, 15.25));
  EXPECT_EQ(scene->grid.corner, Point2(54.5, -211.75));
}

TEST_F(SceneJsonTest, WritesWhatItReadsBack) {
  Scene scene = Load(kScene).value();
  scene.crs = "PROJCS[\"quoted\",\n two lines]";
  scene.grid.corner = Point2(54.651863, -211.66050720214844);
  scene.grid.cell_size = Point2(20.196870, 15.118108);
  scene.area_known = false;
  const auto again = Load(SceneJson(scene));
  ASSERT_TRUE(again.ok()) << again.status();
  EXPECT_EQ(again->crs, scene.crs);
  EXPECT_EQ(again->grid.corner, scene.grid.corner);
  EXPECT_EQ(again->grid.cell_size, scene.grid.cell_size);
  EXPECT_FALSE(again->area_known);
  EXPECT_EQ(Paths(*again), Paths(scene));
  EXPECT_EQ(SceneJson(*again), SceneJson(scene));
}

TEST_F(SceneJsonTest, AnAreaIsAPolygonOrAFile) {
  const auto with = [this](const std::string& area) {
    std::string json(kScene);
    absl::StrReplaceAll({{R"("future")", absl::StrCat(R"("area": )", area, R"(, "future")")}}, &json);
    return Load(json);
  };
  const auto polygon = with(R"({"type": "Polygon", "coordinates": [[[0, 0], [9, 0.5], [9, 9], [0, 0]]]})");
  ASSERT_TRUE(polygon.ok()) << polygon.status();
  EXPECT_THAT(polygon->area.rings, ElementsAre(ElementsAre(Point2(0, 0), Point2(9, 0.5), Point2(9, 9))));
  const auto several = with(
      R"({"type": "MultiPolygon", "coordinates": [[[[0, 0], [9, 0], [9, 9], [0, 0]]], [[[20, 0], [29, 0], [29, 9], [20, 0]]]]})");
  ASSERT_TRUE(several.ok()) << several.status();
  ASSERT_EQ(several->area.rings.size(), 2U);
  const auto again = Load(SceneJson(*several));
  ASSERT_TRUE(again.ok()) << again.status();
  EXPECT_EQ(again->area.rings, several->area.rings);
  EXPECT_THAT(SceneJson(*several), HasSubstr("MultiPolygon")) << "in a Polygon the second would be a hole";
  const auto file = with(R"("area.gpkg")");
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_EQ(file->area_file, folder_ / "area.gpkg");
  for (const char* bad : {"7", R"("")", R"({"type": "Point", "coordinates": [0, 0]})", R"({"type": "Polygon"})",
                          R"({"type": "Polygon", "coordinates": []})", R"({"type": "Polygon", "coordinates": [7]})",
                          R"({"type": "Polygon", "coordinates": [[[0, 0], [9, 0], [0, 0]]]})",
                          R"({"type": "Polygon", "coordinates": [[[0, 0], [9, 0], [9, 9], [1, 0]]]})",
                          R"({"type": "Polygon", "coordinates": [[[0, 0], [9e9, 0], [9, 9], [0, 0]]]})"}) {
    const absl::Status status = with(bad).status();
    EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument) << bad;
    EXPECT_THAT(std::string(status.message()), HasSubstr("scene.json: area: ")) << bad;
  }
}

TEST_F(SceneJsonTest, WarnsOfAFieldThatIsNearlyCalledAsOneThatIsMissing) {
  std::string json(kScene);
  absl::StrReplaceAll({{"\"future\"", "\"area_knwon\""}}, &json);
  const auto scene = Load(json);
  ASSERT_TRUE(scene.ok()) << scene.status();
  EXPECT_THAT(
      scene->warnings,
      ElementsAre(HasSubstr(R"(scene.json: the field "area_knwon" has no effect; one that has is "area_known")")));
  const auto both = Load(absl::StrReplaceAll(json, {{"\"cell_size\"", "\"area_known\": true, \"cell_size\""}}));
  ASSERT_TRUE(both.ok()) << both.status();
  EXPECT_THAT(both->warnings, IsEmpty());
  EXPECT_THAT(Load(kScene)->warnings, IsEmpty()) << "other fields";
}

TEST_F(SceneJsonTest, NamesThePlaceOfASyntaxError) {
  const absl::Status status = Load("{\n \"cols\": 2,\n \"rows\": ]\n}").status();
  EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument);
  EXPECT_THAT(std::string(status.message()),
              AllOf(HasSubstr("scene.json: not JSON"), HasSubstr("line 3"), HasSubstr("byte")));
  EXPECT_THAT(std::string(Load("").status().message()), HasSubstr("not JSON"));
  EXPECT_THAT(std::string(Load("[]").status().message()), HasSubstr("expected an object"));
  EXPECT_THAT(std::string(Load(std::string(100000, '[')).status().message()), HasSubstr("not JSON"));
  EXPECT_THAT(std::string(Load("{\"cols\": 1e999}").status().message()), HasSubstr("not JSON"));
}

TEST_F(SceneJsonTest, RefusesWrongGrids) {
  ExpectInvalid("\"cell_size\": 250", "\"cell_size\": 0", "cell_size: must be finite and greater than 0");
  ExpectInvalid("\"cell_size\": 250", "\"cell_size\": [250, -1]", "cell_size: must be");
  ExpectInvalid("\"cell_size\": 250", "\"cell_size\": \"250\"", "cell_size: expected a number");
  ExpectInvalid("\"cell_size\": 250", "\"cell_size\": [250]", "cell_size: expected a number");
  ExpectInvalid("\"cell_size\": 250,", "", "cell_size: missing");
  ExpectInvalid("\"cols\": 2", "\"cols\": 0", "cols: expected 1 to 100000, found 0");
  ExpectInvalid("\"cols\": 2", "\"cols\": 100001", "cols: expected 1 to 100000");
  ExpectInvalid("\"cols\": 2", "\"cols\": 18446744073709551615", "cols: expected 1 to 100000");
  ExpectInvalid("\"rows\": 2", "\"rows\": 2.5", "rows: expected an integer");
  ExpectInvalid("12.5]", "12.5, 1]", "origin: expected an array of 3 numbers");
  ExpectInvalid("12.5]", "null]", "origin: expected an array of 3 numbers");
  ExpectInvalid("\"EPSG:32650\"", "32650", "crs: expected a text");
}

TEST_F(SceneJsonTest, AnAreaIsWrittenWithItsIslandsInTheirOutlines) {
  const auto square = [](double low, double high) {
    return std::vector<Point2>{{low, low}, {high, low}, {high, high}, {low, high}};
  };
  auto scene = Load(kScene);
  ASSERT_TRUE(scene.ok()) << scene.status();
  scene->area.rings = {square(4, 5), square(40, 50), square(0, 20), square(2, 9)};
  const auto again = Load(SceneJson(*scene));
  ASSERT_TRUE(again.ok()) << again.status();
  EXPECT_THAT(again->area.rings, ElementsAre(square(4, 5), square(40, 50), square(0, 20), square(2, 9)));
  EXPECT_EQ(AreaOf(again->area), AreaOf(scene->area));
  scene->area.rings = {square(2, 9), square(0, 20)};
  const auto one = Load(SceneJson(*scene));
  ASSERT_TRUE(one.ok()) << one.status();
  EXPECT_THAT(one->area.rings, ElementsAre(square(0, 20), square(2, 9))) << "the outline comes first";
}

TEST_F(SceneJsonTest, RefusesAnAreaThatCrossesItself) {
  ExpectInvalid(
      "\"cell_size\": 250",
      R"("area": {"type": "Polygon", "coordinates": [[[0, 0], [9, 9], [9, 0], [0, 9], [0, 0]]]}, "cell_size": 250)",
      "area: ring 0 crosses itself at (4.5, 4.5)");
}

TEST_F(SceneJsonTest, RefusesWrongTiles) {
  ExpectInvalid("\"col\": 1, \"row\": 0", "\"col\": \"1\", \"row\": 0", "tiles[2].col: expected an integer");
  ExpectInvalid("\"col\": 1, \"row\": 0", "\"col\": 2, \"row\": 0", "tiles[2].col: expected 0 to 1, found 2");
  ExpectInvalid("\"col\": 1, \"row\": 0", "\"col\": -1, \"row\": 0", "tiles[2].col: expected 0 to 1, found -1");
  ExpectInvalid("\"col\": 1, \"row\": 0", "\"col\": 1", "tiles[2].row: missing");
  ExpectInvalid("\"tiles/a.ply\"", "7", "tiles[1].path: expected a file name or null");
  ExpectInvalid("\"tiles/a.ply\"", "\"\"", "tiles[1].path: expected a file name or null");
  ExpectInvalid(", \"path\": null", "", "tiles[0].path: missing");
  ExpectInvalid("{\"col\": 1, \"row\": 1, \"path\": null}", "null", "tiles[0]: expected an object");
}

TEST_F(SceneJsonTest, RefusesPathsOutOfTheFolderAndOtherFormats) {
  ExpectInvalid("tiles/a.ply", "/etc/a.ply", "tiles[1].path: \"/etc/a.ply\" is absolute");
  ExpectInvalid("tiles/a.ply", "tiles/../../a.ply", "leaves the scene's folder");
  ExpectInvalid("tiles/a.ply", "tiles/a.b3dm",
                "format \".b3dm\" is not read; tiles are .ply, .obj, .osgb or a tileset.json");
  ExpectInvalid("tiles/a.ply", "tiles/a", "format \"\" is not read");
}

TEST_F(SceneJsonTest, NamesBothTilesOfOneCell) {
  ExpectInvalid("\"col\": 1, \"row\": 0", "\"col\": 0, \"row\": 0",
                "tiles[1] and tiles[2] are both cell +000_+000 (tiles/a.ply, tiles/b.OBJ)");
  ExpectInvalid("./tiles/b.OBJ", "tiles//a.ply", "tiles[1] and tiles[2] are both the file tiles/a.ply");
}

TEST_F(SceneJsonTest, TwoTreesInOneFolderAreAnError) {
  std::string json(kScene);
  absl::StrReplaceAll({{"tiles/a.ply", "tiles/a.osgb"}, {"./tiles/b.OBJ", "tiles/b.OSGB"}}, &json);
  const absl::Status status = Load(json).status();
  EXPECT_THAT(std::string(status.message()), HasSubstr("are both all files of trees in the folder tiles/"));
}

TEST_F(SceneJsonTest, NamesTheMissingFile) {
  const absl::Status status = Changed("tiles/a.ply", "tiles/gone.ply");
  EXPECT_EQ(status.code(), absl::StatusCode::kNotFound);
  EXPECT_THAT(std::string(status.message()),
              AllOf(HasSubstr("cell +000_+000"), HasSubstr("tiles/gone.ply: no such file")));
  EXPECT_EQ(LoadScene(folder_ / "nowhere", nullptr).status().code(), absl::StatusCode::kNotFound);
  EXPECT_EQ(LoadScene(folder_ / "tiles/a.ply", nullptr).status().code(), absl::StatusCode::kInvalidArgument);
}

}  // namespace
}  // namespace tilemend
