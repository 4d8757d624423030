#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "common/grid/scene.h"
#include "common/grid/scene_sources.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using testing::HasSubstr;

constexpr char kTileset[] = R"({"asset": {"version": "1.1"}, "root": {}})";

class SceneTilesetTest : public testing::Test {
 protected:
  static ConvexHull Square(const Point2& lo, const Point2& hi) { return {lo, {hi.x(), lo.y()}, hi, {lo.x(), hi.y()}}; }
  // A tile of 100 m with an overlap of 1 m.
  void Add(const std::string& path, int col, int row) {
    tiles_.tiles.push_back({path, TileFrame(16, col)});
    hulls_[path] = Square({100.0 * col - 1, 100.0 * row - 1}, {100.0 * col + 101, 100.0 * row + 101});
  }
  // Turns what is there about the origin.
  void Turn(double angle) {
    for (auto& [path, hull] : hulls_) {
      for (Point2& p : hull) p = Eigen::Rotation2Dd(angle) * p;
    }
  }
  absl::StatusOr<Scene> Load(const std::string& path) {
    const auto read_hull = [&](const std::string& file, const TileFrame&) -> absl::StatusOr<ConvexHull> {
      return hulls_.at(std::filesystem::path(file).lexically_relative(folder_.path()).string());
    };
    turn_ = 0;
    return LoadScene(path, read_hull, [&](const std::string& folder, const std::string& entry, double turn) {
      EXPECT_EQ(folder, folder_.path());
      EXPECT_EQ(entry, entry_);
      turn_ = turn;
      return tiles_;
    });
  }
  std::string Problem() { return std::string(Load(folder_.path()).status().message()); }

  const TemporaryFolder folder_;
  std::string entry_ = "tileset.json";
  TilesetTiles tiles_;
  std::map<std::string, ConvexHull> hulls_;
  double turn_ = 0;  // that the tileset was last read with
};

TEST_F(SceneTilesetTest, ATilesetWithoutOthersIsOneCell) {
  folder_.Write("tileset.json", kTileset);
  folder_.Write("Data/Tile_+000_+001.ply", "not looked at");
  tiles_ = {"+proj=ortho", 50, {{"tileset.json", {}}}, "why"};
  hulls_["tileset.json"] = Square({-3.5, 10}, {96.2, 10.5});
  const auto scene = Load(folder_.path());
  ASSERT_TRUE(scene.ok()) << scene.status();
  ASSERT_EQ(scene->tiles.size(), 1u);
  EXPECT_EQ(scene->tiles[0].path, "tileset.json");
  EXPECT_EQ(scene->tileset, "");
  EXPECT_EQ(scene->crs, "+proj=ortho");
  EXPECT_EQ(scene->origin, Point3(0, 0, 50));
  EXPECT_EQ(scene->grid.corner, Point2(-4, 10));
  EXPECT_EQ(scene->grid.cell_size, Point2(101, 1));
  EXPECT_FALSE(scene->area_known);
  EXPECT_EQ(scene->warnings[0], "why");
  EXPECT_THAT(scene->warnings[1], HasSubstr("one cell of 101 x 1 m"));
  EXPECT_TRUE(Load(folder_ / "tileset.json").ok()) << "the entry's path is the scene's as well";
}

TEST_F(SceneTilesetTest, TilesetsAreCellsByTheirNames) {
  folder_.Write(entry_ = "Production_1.json", kTileset);
  folder_.Write("options.json", R"({"asset": 1})");
  Add("Data/Tile_m001_p002/Tile_m001_p002.json", 3, 2);
  Add("Data/Tile_p000_p002/tileset.json", 4, 2);
  auto scene = Load(folder_.path());
  ASSERT_TRUE(scene.ok()) << scene.status();
  ASSERT_EQ(scene->tiles.size(), 2u);
  EXPECT_EQ(scene->tileset, "Production_1.json");
  EXPECT_EQ(scene->tiles[0].cell, (CellId{0, 2}));
  EXPECT_EQ(scene->tiles[1].cell, (CellId{1, 2}));
  EXPECT_EQ(scene->tiles[1].frame, TileFrame(16, 4));
  EXPECT_EQ(scene->grid.cell_size.x(), 100);
  for (const SceneTile& tile : scene->tiles) folder_.Write(tile.path, kTileset);
  folder_.Write("scene.json", SceneJson(*scene));
  const auto again = LoadScene(folder_.path(), nullptr);
  ASSERT_TRUE(again.ok()) << again.status();
  EXPECT_EQ(again->tileset, scene->tileset);
  EXPECT_EQ(again->tiles[1].frame, scene->tiles[1].frame);
}

TEST_F(SceneTilesetTest, TilesetsWithOtherNamesAreCellsByTheirPlaces) {
  folder_.Write("tileset.json", kTileset);
  Add("Data/a/tileset.json", 1, 1);
  Add("Data/b/tileset.json", 0, 1);
  Add("Data/c/tileset.json", 0, 0);
  const auto scene = Load(folder_.path());
  ASSERT_TRUE(scene.ok()) << scene.status();
  EXPECT_EQ(scene->tiles[0].path, "Data/c/tileset.json");
  EXPECT_EQ(scene->tiles[2].path, "Data/a/tileset.json");
  EXPECT_EQ(scene->tiles[2].cell, (CellId{1, 1}));
  EXPECT_EQ(scene->cols, 2);
  hulls_[tiles_.tiles[1].path] = hulls_[tiles_.tiles[0].path];
  EXPECT_THAT(Problem(), HasSubstr("are both in cell +001_+001; the tilesets have to lie in a regular plane grid"));
}

TEST_F(SceneTilesetTest, TheScenesAxesAreThoseOfTheCut) {
  folder_.Write("tileset.json", kTileset);
  for (int i = 0; i < 6; ++i) Add(absl::StrCat("Data/Tile_p00", i % 2, "_p00", i / 2, "/t.json"), i % 2, i / 2);
  hulls_.begin()->second.erase(hulls_.begin()->second.begin());  // a tile at the edge of the survey
  Turn(0.02);
  const auto scene = Load(folder_.path());
  ASSERT_TRUE(scene.ok()) << scene.status();
  EXPECT_NEAR(turn_, 0.02, 1e-9);
  EXPECT_EQ(scene->grid.cell_size, Point2(100, 100));
  EXPECT_LT((scene->grid.corner - Point2(0, 0)).norm(), 1e-6);
  EXPECT_THAT(scene->warnings[0],
              HasSubstr("tileset.json: its tiles were cut along axes that are turned by 1.146 degrees"));
}

TEST_F(SceneTilesetTest, TilesetsWithOtherNamesMayBeTurned) {
  folder_.Write("tileset.json", kTileset);
  for (int i = 0; i < 60; ++i) Add(absl::StrCat("Data/", i, "/t.json"), i % 30, i / 30);
  Turn(-0.05);
  const auto scene = Load(folder_.path());
  ASSERT_TRUE(scene.ok()) << scene.status();
  EXPECT_NEAR(turn_, -0.05, 1e-9);
  EXPECT_EQ(scene->cols, 30);
  EXPECT_EQ(scene->rows, 2);
}

TEST_F(SceneTilesetTest, AGridMayBeTurnedByMoreThanHalfAQuarter) {
  folder_.Write("tileset.json", kTileset);
  for (int i = 0; i < 6; ++i) Add(absl::StrCat("Data/Tile_p00", i % 2, "_p00", i / 2, "/t.json"), i % 2, i / 2);
  Turn(1);
  const auto scene = Load(folder_.path());
  ASSERT_TRUE(scene.ok()) << scene.status();
  EXPECT_NEAR(turn_, 1, 1e-9);
}

TEST_F(SceneTilesetTest, TilesThatGapeAreNotTurnedByNoise) {
  folder_.Write("tileset.json", kTileset);
  for (int i = 0; i < 6; ++i) {
    const std::string path = absl::StrCat("Data/Tile_p00", i % 2, "_p00", i / 2, "/t.json");
    Add(path, i % 2, i / 2);
    const double x = 100 * (i % 2), y = 100 * (i / 2);
    hulls_[path] = {{x + 1, y + 1}, {x + 98.9, y + 1.05}, {x + 99, y + 99}, {x + 1, y + 98.95}};
  }
  ASSERT_TRUE(Load(folder_.path()).ok());
  EXPECT_EQ(turn_, 0);
}

TEST_F(SceneTilesetTest, TheEdgeOfASurveyTurnsNothing) {
  folder_.Write("tileset.json", kTileset);
  for (int i = 0; i < 3; ++i) {
    const std::string path = absl::StrCat("Data/Tile_p000_p00", i, "/t.json");
    Add(path, 0, i);
    // The surveyed area is a band that lies askew.
    const double lo = 100 * i - 1, hi = 100 * i + 101;
    hulls_[path] = {{40 + 0.1 * lo, lo}, {60 + 0.1 * lo, lo}, {60 + 0.1 * hi, hi}, {40 + 0.1 * hi, hi}};
  }
  const auto scene = Load(folder_.path());
  ASSERT_TRUE(scene.ok()) << scene.status();
  EXPECT_EQ(turn_, 0);
  EXPECT_EQ(scene->warnings.size(), 1U);
}

TEST_F(SceneTilesetTest, RefusesWhatIsNoGrid) {
  folder_.Write("tileset.json", kTileset);
  Add("Data/Tile_p000_p000_p000/t.json", 0, 0);
  EXPECT_THAT(Problem(), HasSubstr("a name with three numbers"));
  folder_.Write("tileset.json", kTileset);
  EXPECT_TRUE(absl::IsFailedPrecondition(LoadScene(folder_.path(), nullptr).status()));
}

TEST_F(SceneTilesetTest, FindsTheEntry) {
  EXPECT_EQ(*FindTileset(folder_.path()), "");
  folder_.Write("a.json", kTileset);
  folder_.Write("notes.json", "no JSON");
  EXPECT_EQ(*FindTileset(folder_.path()), "a.json");
  folder_.Write("b.json", kTileset);
  EXPECT_THAT(std::string(FindTileset(folder_.path()).status().message()), HasSubstr("a.json and b.json are both"));
  folder_.Write("tileset.json", "damaged");
  EXPECT_EQ(*FindTileset(folder_.path()), "tileset.json");
  EXPECT_TRUE(LooksLikeTileset(folder_ / "a.json"));
  EXPECT_FALSE(LooksLikeTileset(folder_ / "tileset.json"));
  EXPECT_FALSE(LooksLikeTileset(folder_ / "none.json"));
}

TEST_F(SceneTilesetTest, ErrorsOfTheTilesetAreThoseOfTheScene) {
  folder_.Write("tileset.json", "{}");
  const auto hull = [](const std::string&, const TileFrame&) { return ConvexHull(); };
  const auto scene = LoadScene(folder_.path(), hull, [](const std::string&, const std::string&, double) {
    return absl::InvalidArgumentError("bad");
  });
  EXPECT_EQ(scene.status(), absl::InvalidArgumentError("bad"));
}

TEST_F(SceneTilesetTest, ATilesetHasItsFolderForItself) {
  folder_.Write("a/tileset.json", "{}");
  folder_.Write("a/b/c.ply", "ply");
  folder_.Write("scene.json", R"({"cell_size": 10, "cols": 2, "rows": 1, "tiles": [
      {"col": 0, "row": 0, "path": "a/b/c.ply"}, {"col": 1, "row": 0, "path": "a/tileset.json"}]})");
  EXPECT_THAT(Problem(), HasSubstr("tiles[0] (a/b/c.ply) lies in the folder of the tileset tiles[1] (a/tileset.json)"));
}

TEST_F(SceneTilesetTest, ReadsFieldsOfTilesetsWithCare) {
  folder_.Write("a/tileset.json", "{}");
  const auto with = [&](const std::string& head, const std::string& frame) {
    folder_.Write("scene.json", R"({"cell_size": 10, "cols": 1, "rows": 1,)" + head +
                                    R"("tiles": [{"col": 0, "row": 0, "path": "a/tileset.json")" + frame + "}]}");
    return Problem();
  };
  EXPECT_EQ(with("", ""), "");
  EXPECT_THAT(with("", R"(, "frame": [1, 2])"), HasSubstr("frame"));
  EXPECT_THAT(with(R"("tileset": "../x.json",)", ""), HasSubstr("expected a name without folder"));
  EXPECT_THAT(with(R"("tileset": "report.json",)", ""), HasSubstr("expected the name of a .json file"));
}

}  // namespace
}  // namespace tilemend
