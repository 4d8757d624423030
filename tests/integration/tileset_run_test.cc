// Tilesets of 3D Tiles from the command line: every level of detail is filled alike, and all that was there stays.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "absl/strings/str_cat.h"
#include "common/codec/mesh_file.h"
#include "common/codec/tiles3d/tileset_tree.h"
#include "common/codec/tree/tile_tree.h"
#include "common/util/files.h"
#include "common/util/tile_files.h"
#include "tests/support/decisions.h"
#include "tests/support/image_builders.h"
#include "tests/support/osgb_scene.h"
#include "tests/support/output_checks.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/tileset_scene.h"
#include "tests/support/top_at.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;
using Json = nlohmann::json;
using Place = TilesetScene::Place;

class TilesetRunTest : public ::testing::Test {
 protected:
  Ended Tilemend(const std::vector<std::string>& words) {
    return Process(folder_.path(), TILEMEND_CLIENT, words).Wait();
  }
  void WriteScene(const TilesetScene& scene) {
    std::filesystem::remove_all(folder_ / "scene");
    for (const auto& [path, bytes] : scene.All()) folder_.Write("scene/" + path, bytes);
  }
  // The pond's polygon, in the scene's own coordinates.
  std::string PondPolygon(bool clear, const Point2& origin = {0, 0}) {
    Json ring = Json::array();
    for (int k = 0; k <= 60; ++k) {
      const double angle = (k % 60) * M_PI / 30;
      ring.push_back({OsgbScene::kCell - origin.x() + OsgbScene::kRadius * std::cos(angle),
                      OsgbScene::kCell / 2 - origin.y() + OsgbScene::kRadius * std::sin(angle)});
    }
    const Json feature = {{"type", "Feature"},
                          {"properties", {{"name", "pond"}, {"clear", clear}}},
                          {"geometry", {{"type", "Polygon"}, {"coordinates", {ring}}}}};
    return folder_.Write("pond.geojson", feature.dump());
  }

  // Of a run on two tilesets.
  void ExpectLevelPond(const Ended& ended, double tolerance, const Point2& origin);

  const TemporaryFolder folder_;
};

struct ReadTree {
  std::string bytes;
  TilesetTree models;  // as the files have them
  TileTree tree;
};

ReadTree Read(const std::string& path, const TileFrame& frame = {}) {
  ReadTree read{*ReadTileBytes(path, frame), {}, {}};
  auto models = ReadTilesetTree(read.bytes, path);
  auto tree = ReadTileTree(read.bytes, path);
  EXPECT_TRUE(models.ok() && tree.ok()) << models.status() << tree.status();
  if (models.ok() && tree.ok()) std::tie(read.models, read.tree) = std::pair(*std::move(models), *std::move(tree));
  return read;
}

// The primitives that were there have the same bits, but for triangles that `clear` took; images are the same bytes.
void ExpectOriginalsKept(const ReadTree& before, const ReadTree& after, bool cleared) {
  ASSERT_EQ(before.models.models.size(), after.models.models.size());
  for (size_t m = 0; m < before.models.models.size(); ++m) {
    const TilesetModel &was = before.models.models[m], &is = after.models.models[m];
    SCOPED_TRACE(before.models.packed[was.file].name);
    EXPECT_EQ(before.models.packed[was.file].name, after.models.packed[is.file].name);
    ASSERT_GE(is.gltf.primitives.size(), was.gltf.primitives.size());
    ASSERT_GE(is.gltf.images.size(), was.gltf.images.size());
    for (size_t i = 0; i < was.gltf.images.size(); ++i) {
      EXPECT_EQ(before.models.packed[was.file].bytes.substr(was.gltf.images[i].offset, was.gltf.images[i].size),
                after.models.packed[is.file].bytes.substr(is.gltf.images[i].offset, is.gltf.images[i].size));
    }
    for (size_t p = 0; p < was.gltf.primitives.size(); ++p) {
      const GltfPrimitive &old = was.gltf.primitives[p], &now = is.gltf.primitives[p];
      ASSERT_EQ(now.vertex_count, old.vertex_count);
      for (int32_t v = 0; v < old.vertex_count; ++v) {
        EXPECT_EQ(was.gltf.points[old.first_vertex + v], is.gltf.points[now.first_vertex + v]);
        EXPECT_EQ(was.gltf.uv[old.first_vertex + v], is.gltf.uv[now.first_vertex + v]);
      }
      EXPECT_TRUE(cleared ? now.triangle_count <= old.triangle_count : now.triangle_count == old.triangle_count);
    }
  }
}

// Of the places in the pond: which share one level of detail has at `level` metres, to `tolerance`.
void ExpectLevelPlaces(int32_t l, double level, double tolerance, const std::function<double(const Point2&)>& top_at) {
  int all = 0, flat = 0;
  for (double x = OsgbScene::kCell - 16.9; x < OsgbScene::kCell + 17; x += 1.3) {
    for (double y = OsgbScene::kCell / 2 - 16.9; y < OsgbScene::kCell / 2 + 17; y += 1.3) {
      if (!OsgbScene::InPond(x, y)) continue;
      const double top = top_at({x, y});
      EXPECT_FALSE(std::isnan(top)) << "level " << l << ": a hole at " << x << ", " << y;
      ++all;
      flat += std::abs(top - level) <= tolerance ? 1 : 0;
    }
  }
  // The rim of the coarsest level, with edges of 4 m, reaches into the pond.
  EXPECT_GE(flat, (l == 0 ? 0.7 : 0.8) * all) << "level " << l;
}

void ExpectLevelWater(const TileTree& tree, double level, double tolerance, const Point2& origin = {0, 0}) {
  for (int32_t l = 0; l < tree.levels; ++l) {
    const TreeLevel is = LevelOf(tree, l);
    ExpectLevelPlaces(l, level, tolerance, [&](const Point2& p) { return TopAt(is.mesh, p - origin); });
  }
}

TEST_F(TilesetRunTest, APondIsFilledAtOneHeightInAllLevels) {
  for (const Place place : {Place::kLocal, Place::kOnEarth}) {
    WriteScene({.place = place});
    const Ended ended =
        Tilemend({"run", folder_ / "scene", "--out", folder_ / "out", "--overwrite", "--water", PondPolygon(false)});
    ASSERT_TRUE(ended.code == 0 || ended.code == 100) << ended.err;
    const Json report = ReportOf(folder_ / "out");
    ASSERT_EQ(report["water"].size(), 1U) << ended.out << ended.err;
    const ReadTree before = Read(folder_ / "scene/tileset.json"), after = Read(folder_ / "out/tileset.json");
    ExpectOriginalsKept(before, after, false);
    ExpectLevelWater(after.tree, report["water"][0]["level_m"], 1e-6);
  }
}

TEST_F(TilesetRunTest, ADecisionSetsTheLevelInAllLevels) {
  WriteScene({.place = Place::kOnEarth});
  const std::string water = PondPolygon(false);
  const Ended first = Tilemend({"run", folder_ / "scene", "--out", folder_ / "out", "--water", water});
  ASSERT_TRUE(first.code == 0 || first.code == 100) << first.err;
  const double level = ReportOf(folder_ / "out")["water"][0]["level_m"].get<double>() - 0.5;
  const std::string marks = folder_.Write("marks.geojson", DecisionsOnHoles(folder_ / "out", "water", level));
  const Ended again =
      Tilemend({"run", folder_ / "scene", "--out", folder_ / "out", "--water", water, "--decisions", marks});
  ASSERT_TRUE(again.code == 0 || again.code == 100) << again.err;
  const ReadTree before = Read(folder_ / "scene/tileset.json"), after = Read(folder_ / "out/tileset.json");
  ExpectOriginalsKept(before, after, false);
  ExpectLevelWater(after.tree, level, 1e-6);
}

TEST_F(TilesetRunTest, EarthCentredTilesAreFilledLevel) {
  WriteScene({.place = Place::kEarthCentred});
  const Point2 middle(64, 32);
  const Ended ended =
      Tilemend({"run", folder_ / "scene", "--out", folder_ / "out", "--water", PondPolygon(false, middle)});
  ASSERT_TRUE(ended.code == 0 || ended.code == 100) << ended.err;
  const Json report = ReportOf(folder_ / "out");
  ASSERT_EQ(report["water"].size(), 1U) << ended.out << ended.err;
  const ReadTree before = Read(folder_ / "scene/tileset.json"), after = Read(folder_ / "out/tileset.json");
  ExpectOriginalsKept(before, after, false);
  ExpectLevelWater(after.tree, report["water"][0]["level_m"], 2e-5, middle);  // of float32 in the models
}

// Every level of the two tilesets; their frames are those of the scene.
void ExpectLevelTiles(const std::string& scene, const std::string& out, double level, double tolerance,
                      const Point2& origin) {
  const Json tiles = Json::parse(*ReadFile(out + "/scene.json"))["tiles"];
  ASSERT_EQ(tiles.size(), 2U);
  std::vector<TileTree> trees;
  std::vector<std::string> kept;
  for (const Json& tile : tiles) {
    const std::string path = "/" + tile["path"].get<std::string>();
    const TileFrame frame = tile["frame"];
    ExpectOriginalsKept(Read(scene + path, frame), Read(out + path, frame), false);
    kept.push_back(*ReadTileBytes(out + path, frame));
  }
  for (const std::string& bytes : kept) trees.push_back(*ReadTileTree(bytes, "t.json"));
  for (int32_t l = 0; l < 3; ++l) {
    const TreeLevel left = LevelOf(trees[0], l), right = LevelOf(trees[1], l);
    ExpectLevelPlaces(l, level, tolerance, [&](const Point2& p) {
      return TopAt((p.x() < OsgbScene::kCell ? left : right).mesh, p - origin);
    });
  }
}

void TilesetRunTest::ExpectLevelPond(const Ended& ended, double tolerance, const Point2& origin) {
  ASSERT_TRUE(ended.code == 0 || ended.code == 100) << ended.err;
  const Json report = ReportOf(folder_ / "out");
  ASSERT_EQ(report["water"].size(), 1U) << ended.out << ended.err;
  ExpectLevelTiles(folder_ / "scene", folder_ / "out", report["water"][0]["level_m"], tolerance, origin);
  const Ended check = Tilemend({"check", folder_ / "scene", folder_ / "out"});
  EXPECT_EQ(check.code, 0) << check.out << check.err;
}

TEST_F(TilesetRunTest, TilesetsOfTilesAreCells) {
  for (const Place place : {Place::kLocal, Place::kOnEarth, Place::kEarthCentred}) {
    SCOPED_TRACE(static_cast<int>(place));
    const Point2 origin = place == Place::kEarthCentred ? Point2(64, 32) : Point2(0, 0);
    WriteScene({.files = TilesetScene::Files::kOfTiles, .place = place});
    const Ended ended = Tilemend(
        {"run", folder_ / "scene", "--out", folder_ / "out", "--overwrite", "--water", PondPolygon(false, origin)});
    ExpectLevelPond(ended, place == Place::kEarthCentred ? 2e-5 : 1e-6, origin);
    EXPECT_EQ(*ReadFile(folder_ / "out/tileset.json"), *ReadFile(folder_ / "scene/tileset.json"))
        << "the fills lie within the volumes";
  }
}

TEST_F(TilesetRunTest, TilesMayBeCutAlongTheAxesOfAMap) {
  for (const Place place : {Place::kLocal, Place::kOnEarth, Place::kEarthCentred}) {
    SCOPED_TRACE(static_cast<int>(place));
    const double turn = 0.02;
    const Point2 origin = place == Place::kEarthCentred ? Eigen::Rotation2Dd(-turn) * Point2(64, 32) : Point2(0, 0);
    WriteScene({.files = TilesetScene::Files::kOfTiles, .place = place, .turn = turn});
    const Ended ended = Tilemend(
        {"run", folder_ / "scene", "--out", folder_ / "out", "--overwrite", "--water", PondPolygon(false, origin)});
    EXPECT_THAT(ReportOf(folder_ / "out")["warnings"].dump(), HasSubstr("cut along axes that are turned by 1.14"));
    EXPECT_THAT(Json::parse(*ReadFile(folder_ / "out/scene.json")).dump(),
                HasSubstr(place == Place::kLocal ? "" : "+gamma=46.14"));
    ExpectLevelPond(ended, 2e-5, origin);
  }
}

TEST_F(TilesetRunTest, WaterThatIsNoiseIsTakenOutOfAllLevels) {
  WriteScene({.pond = TilesetScene::Pond::kNoise});
  const Ended ended = Tilemend({"run", folder_ / "scene", "--out", folder_ / "out", "--water", PondPolygon(true)});
  ASSERT_TRUE(ended.code == 0 || ended.code == 100) << ended.err;
  const Json report = ReportOf(folder_ / "out");
  EXPECT_NEAR(report["water"][0]["level_m"].get<double>(), OsgbScene::kLevel, 0.1);
  EXPECT_GT(report["cleared"]["triangles"].get<int64_t>(), 1000);
  const ReadTree before = Read(folder_ / "scene/tileset.json"), after = Read(folder_ / "out/tileset.json");
  ExpectOriginalsKept(before, after, true);
  ExpectLevelWater(after.tree, report["water"][0]["level_m"], 1e-6);
}

TEST_F(TilesetRunTest, InspectMeasuresTheTilesetsOfTilesWhereTheyAre) {
  WriteScene(
      {.pond = TilesetScene::Pond::kNoise, .files = TilesetScene::Files::kOfTiles, .place = Place::kEarthCentred});
  const std::string clear = PondPolygon(true, {64, 32});
  Tilemend({"run", folder_ / "scene", "--out", folder_ / "out", "--clear", clear});
  const Ended ended = Tilemend({"inspect", folder_ / "scene", "--clear", clear, "-o", "json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const Json water = Json::parse(ended.out)["water"], of_run = ReportOf(folder_ / "out")["water"];
  ASSERT_EQ(water.size(), 1U);
  ASSERT_EQ(of_run.size(), 1U);
  EXPECT_EQ(water[0]["level_m"], of_run[0]["level_m"]);
}

TEST_F(TilesetRunTest, CheckTellsPlacesInTheFrameOfTheScene) {
  WriteScene(
      {.pond = TilesetScene::Pond::kNoise, .files = TilesetScene::Files::kOfTiles, .place = Place::kEarthCentred});
  const Ended ended = Tilemend({"check", folder_ / "scene", "--crease-angle", "30", "-o", "json"});
  const Json places = Json::parse(ended.out)["defects"]["creased_edges"]["at"];
  EXPECT_FALSE(places.empty());
  for (const Json& place : places) {
    EXPECT_LT(std::hypot(place[0].get<double>(), place[1].get<double>()), OsgbScene::kRadius + 2) << "of the pond";
  }
}

TEST_F(TilesetRunTest, AggregateJoinsTilesetsOfTilesWhereTheyAre) {
  WriteScene({.files = TilesetScene::Files::kOfTiles, .place = Place::kEarthCentred});
  const Ended ended = Tilemend({"aggregate", folder_ / "scene", "--out", folder_ / "joined.ply"});
  const auto joined = ReadMeshFile(folder_ / "joined.ply");
  ASSERT_TRUE(joined.ok()) << ended.err << joined.status();
  double low = 0, high = 0;
  for (const Point3& p : joined->mesh.points) {
    low = std::min(low, p.x());
    high = std::max(high, p.x());
  }
  EXPECT_NEAR(low, -OsgbScene::kCell - OsgbScene::kReach, 0.01);
  EXPECT_NEAR(high, OsgbScene::kCell + OsgbScene::kReach, 0.01);
}

TEST_F(TilesetRunTest, FillsHaveTheColourOfTheirRim) {
  WriteScene({.image = PngImage(4, 4, [](int32_t, int32_t) { return Rgb{20, 120, 40}; })});
  Tilemend({"run", folder_ / "scene", "--out", folder_ / "out"});
  EXPECT_THAT(ReportOf(folder_ / "out").dump(), HasSubstr("#147828"));
}

TEST_F(TilesetRunTest, TheAcceptanceCheckComparesAllLevels) {
  WriteScene({});
  Tilemend({"run", folder_ / "scene", "--out", folder_ / "out", "--water", PondPolygon(false)});
  const Ended good = Tilemend({"check", folder_ / "scene", folder_ / "out"});
  EXPECT_EQ(good.code, 0) << good.out << good.err;
  const std::string path = "out/Data/Tile_p000_p000/Tile_p000_p000.glb";
  const std::string bytes = *ReadFile(folder_ / path);
  GltfEdit edit{std::vector<bool>(ReadGltf(bytes, GltfUpAxis::kY, path)->triangles.size(), false), {}};
  edit.drop[0] = true;
  folder_.Write(path, *ChangeGltf(bytes, GltfUpAxis::kY, edit, path));
  const Ended bad = Tilemend({"check", folder_ / "scene", folder_ / "out"});
  EXPECT_EQ(bad.code, 100);
  EXPECT_THAT(bad.out, HasSubstr("1  original face that is missing or changed"));
  // Finer levels would never be shown.
  const std::string entry = *ReadFile(folder_ / "out/tileset.json");
  Json changed = Json::parse(entry);
  changed["root"]["geometricError"] = 0;
  folder_.Write("out/tileset.json", changed.dump());
  EXPECT_THAT(Tilemend({"check", folder_ / "scene", folder_ / "out"}).out,
              HasSubstr("1  changed or missing file that says where tiles lie"));
  folder_.Write("out/tileset.json", entry);
  // The coarsest level as it was in the scene, with its hole.
  for (const char* model : {"Data/Tile_p000_p000/Tile_p000_p000.glb", "Data/Tile_p001_p000/Tile_p001_p000.glb"}) {
    folder_.Write(absl::StrCat("out/", model), *ReadFile(folder_ / absl::StrCat("scene/", model)));
  }
  const Ended unfilled = Tilemend({"check", folder_ / "scene", folder_ / "out"});
  EXPECT_EQ(unfilled.code, 100);
  EXPECT_THAT(unfilled.out, HasSubstr("1  level of detail of tiles that was not filled"));
}

TEST_F(TilesetRunTest, ImagesBesideTheModelsGoWithThem) {
  WriteScene({});
  folder_.Write("scene/Data/Tile_p000_p000/photo.jpg", "of a model");
  Tilemend({"run", folder_ / "scene", "--out", folder_ / "out"});
  EXPECT_EQ(*ReadFile(folder_ / "out/Data/Tile_p000_p000/photo.jpg"), "of a model");
}

TEST_F(TilesetRunTest, AnOutputHasNothingToFillAndIsTheSameForAllWorkers) {
  WriteScene({});
  Tilemend({"run", folder_ / "scene", "--out", folder_ / "one", "--workers", "1"});
  Tilemend({"run", folder_ / "scene", "--out", folder_ / "four", "--workers", "4"});
  EXPECT_EQ(FilesBelow(folder_ / "one/Data"), FilesBelow(folder_ / "four/Data"));
  EXPECT_EQ(*ReadFile(folder_ / "one/tileset.json"), *ReadFile(folder_ / "four/tileset.json"));
  Tilemend({"run", folder_ / "one", "--out", folder_ / "again"});
  EXPECT_EQ(FilesBelow(folder_ / "one/Data"), FilesBelow(folder_ / "again/Data"));
}

TEST_F(TilesetRunTest, DamagedAndUnknownFilesAreNamed) {
  WriteScene({});
  const std::string damaged = "scene/Data/Tile_p001_p000/Tile_p001_p000_L2_3.glb";
  const std::string bytes = *ReadFile(folder_ / damaged);
  folder_.Write(damaged, bytes.substr(0, bytes.size() / 2));
  Ended ended = Tilemend({"run", folder_ / "scene", "--out", folder_ / "out"});
  EXPECT_NE(ended.code, 0);
  EXPECT_THAT(ended.err + ended.out, HasSubstr("Tile_p001_p000_L2_3.glb: byte "));
  Json entry = Json::parse(*ReadFile(folder_ / "scene/tileset.json"));
  entry["root"]["children"][0]["refine"] = "ADD";
  folder_.Write("scene/tileset.json", entry.dump());
  ended = Tilemend({"run", folder_ / "scene", "--out", folder_ / "out"});
  EXPECT_EQ(ended.code, 4);
  EXPECT_THAT(ended.err, HasSubstr("tileset.json: JSON /root/children/0: refinement ADD is not read"));
}

}  // namespace
}  // namespace tilemend
