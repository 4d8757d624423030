// Scenes of OSGB tiles from the command line: every level of detail is filled alike, and all that was there stays.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "absl/strings/str_cat.h"
#include "common/codec/osgb/osgb_tile.h"
#include "common/codec/tree/tile_tree.h"
#include "common/image/image.h"
#include "common/util/files.h"
#include "common/util/tile_files.h"
#include "tests/support/decisions.h"
#include "tests/support/image_builders.h"
#include "tests/support/osgb_scene.h"
#include "tests/support/output_checks.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/top_at.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;
using Json = nlohmann::json;

// A tile before and after, with the bytes that both refer to.
struct Pair {
  std::string before_bytes, after_bytes;
  OsgbTile before, after;
};

class OsgbRunTest : public ::testing::Test {
 protected:
  Ended Tilemend(const std::vector<std::string>& words) {
    return Process(folder_.path(), TILEMEND_CLIENT, words).Wait();
  }
  void WriteScene(const OsgbScene& scene) {
    for (const auto& [path, bytes] : scene.Files()) folder_.Write("scene/" + path, bytes);
    Json json = {{"crs", "EPSG:25832"}, {"origin", {500000, 5600000, 0}}, {"cell_size", 64}, {"cols", 2}, {"rows", 1}};
    for (const int col : {0, 1}) {
      const std::string name = OsgbScene::TileName(col);
      json["tiles"].push_back({{"col", col}, {"row", 0}, {"path", "Data/" + name + "/" + name + ".osgb"}});
    }
    folder_.Write("scene/scene.json", json.dump());
  }
  // The pond's polygon; its surface is to be taken out if `clear`.
  std::string PondPolygon(bool clear) {
    Json ring = Json::array();
    for (int k = 0; k <= 60; ++k) {
      const double angle = (k % 60) * M_PI / 30;
      ring.push_back({500000 + OsgbScene::kCell + OsgbScene::kRadius * std::cos(angle),
                      5600000 + OsgbScene::kCell / 2 + OsgbScene::kRadius * std::sin(angle)});
    }
    const Json feature = {{"type", "Feature"},
                          {"crs", {{"type", "name"}, {"properties", {{"name", "EPSG:25832"}}}}},
                          {"properties", {{"name", "pond"}, {"clear", clear}}},
                          {"geometry", {{"type", "Polygon"}, {"coordinates", {ring}}}}};
    return folder_.Write("pond.geojson", feature.dump());
  }
  Pair Read(const std::string& before, const std::string& after) {
    Pair pair{*ReadTileBytes(before), *ReadTileBytes(after), {}, {}};
    auto was = ReadOsgbTile(pair.before_bytes, before), is = ReadOsgbTile(pair.after_bytes, after);
    EXPECT_TRUE(was.ok() && is.ok()) << was.status() << is.status();
    if (was.ok() && is.ok()) std::tie(pair.before, pair.after) = std::pair(*std::move(was), *std::move(is));
    return pair;
  }
  Pair MadeTile(int col) {
    const std::string name = OsgbScene::TileName(col), path = "/Data/" + name + "/" + name + ".osgb";
    return Read(folder_ / ("scene" + path), folder_ / ("out" + path));
  }

  const TemporaryFolder folder_;
};

// The geometries that were there have the same bits, but for triangles that `clear` took; images are the same bytes.
void ExpectOriginalsKept(const Pair& pair, bool cleared) {
  ASSERT_EQ(pair.before.packed.size(), pair.after.packed.size());
  for (size_t f = 0; f < pair.before.files.size(); ++f) {
    SCOPED_TRACE(pair.before.packed[f].name);
    EXPECT_EQ(pair.before.packed[f].name, pair.after.packed[f].name);
    const OsgbFile &was = pair.before.files[f], &is = pair.after.files[f];
    ASSERT_GE(is.geometries.size(), was.geometries.size());
    std::vector<std::string_view> left_images;  // those of fills lie between
    for (const OsgbImage& image : is.images) {
      left_images.push_back(pair.after.packed[f].bytes.substr(image.offset, image.size));
    }
    auto image_at = left_images.begin();
    for (const OsgbImage& image : was.images) {
      image_at = std::find(image_at, left_images.end(), pair.before.packed[f].bytes.substr(image.offset, image.size));
      ASSERT_NE(image_at++, left_images.end());
    }
    std::map<int32_t, std::vector<const OsgbGeometry*>> left;  // of the output, by geode
    for (const OsgbGeometry& g : is.geometries) left[g.geode].push_back(&g);
    std::map<int32_t, size_t> next;
    for (const OsgbGeometry& g : was.geometries) {
      const OsgbGeometry& now = *left.at(g.geode).at(next[g.geode]++);
      ASSERT_EQ(now.vertex_count, g.vertex_count);
      for (int32_t v = 0; v < g.vertex_count; ++v) {
        EXPECT_EQ(was.points[g.first_vertex + v], is.points[now.first_vertex + v]);
        EXPECT_EQ(was.uv[g.first_vertex + v], is.uv[now.first_vertex + v]);
      }
      EXPECT_TRUE(cleared ? now.triangle_count <= g.triangle_count : now.triangle_count == g.triangle_count);
    }
    for (size_t l = 0; l < was.paged_lods.size(); ++l) {
      EXPECT_EQ(was.paged_lods[l].center, is.paged_lods[l].center);
      EXPECT_EQ(was.paged_lods[l].radius, is.paged_lods[l].radius);
      EXPECT_EQ(was.paged_lods[l].children[1].file, is.paged_lods[l].children[1].file);
    }
  }
}

// Of the places in the pond over a tile: which share each level has at `level` metres.
void ExpectLevelWater(const Pair& pair, int col, double level) {
  const auto after = ReadTileTree(pair.after_bytes, "after.osgb");
  ASSERT_TRUE(after.ok()) << after.status();
  for (int32_t l = 0; l < after->levels; ++l) {
    const TreeLevel is = LevelOf(*after, l);
    int all = 0, flat = 0;
    for (double x = OsgbScene::kCell - 16.9; x < OsgbScene::kCell + 17; x += 1.3) {
      for (double y = OsgbScene::kCell / 2 - 16.9; y < OsgbScene::kCell / 2 + 17; y += 1.3) {
        if (!OsgbScene::InPond(x, y) || (col == 0) != (x < OsgbScene::kCell)) continue;
        const double top = TopAt(is.mesh, {x, y});
        EXPECT_FALSE(std::isnan(top)) << "level " << l << ": a hole at " << x << ", " << y;
        ++all;
        flat += std::abs(top - level) <= 1e-6 ? 1 : 0;
      }
    }
    // The rim of the coarsest level, with edges of 4 m, reaches into the pond.
    EXPECT_GE(flat, (l == 0 ? 0.7 : 0.8) * all) << "level " << l;
  }
}

TEST_F(OsgbRunTest, APondIsFilledAtOneHeightInAllLevels) {
  for (const uint32_t version : {80u, 161u}) {
    SCOPED_TRACE(version);
    WriteScene(OsgbScene(OsgbScene::Pond::kHole, version));
    const Ended ended =
        Tilemend({"run", folder_ / "scene", "--out", folder_ / "out", "--overwrite", "--water", PondPolygon(false)});
    ASSERT_EQ(ended.code, 0) << ended.err;
    const Json report = ReportOf(folder_ / "out");
    ASSERT_EQ(report["water"].size(), 1U);
    const double level = report["water"][0]["level_m"];
    for (const int col : {0, 1}) {
      const Pair pair = MadeTile(col);
      ExpectOriginalsKept(pair, false);
      ExpectLevelWater(pair, col, level);
    }
    EXPECT_EQ(*ReadFile(folder_ / "scene/metadata.xml"), OsgbScene().Files().at("metadata.xml"));
  }
}

TEST_F(OsgbRunTest, ADecisionSetsTheLevelInAllLevels) {
  WriteScene(OsgbScene());
  ASSERT_EQ(Tilemend({"run", folder_ / "scene", "--out", folder_ / "out"}).code, 0);
  const double level = 2.5;
  const std::string marks = folder_.Write("marks.geojson", DecisionsOnHoles(folder_ / "out", "water", level, false));
  const Ended ended = Tilemend({"run", folder_ / "scene", "--out", folder_ / "out", "--decisions", marks});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(ReportOf(folder_ / "out")["water"][0]["level_m"], level);
  for (const int col : {0, 1}) {
    const Pair pair = MadeTile(col);
    ExpectOriginalsKept(pair, false);
    ExpectLevelWater(pair, col, level);
  }
  const std::string open = folder_.Write("open.geojson", DecisionsOnHoles(folder_ / "out", "open", {}, false));
  const Ended left = Tilemend({"run", folder_ / "scene", "--out", folder_ / "out", "--decisions", open});
  ASSERT_EQ(left.code, 0) << left.err;
  EXPECT_EQ(FilesBelow(folder_ / "out/Data"), FilesBelow(folder_ / "scene/Data"));
}

TEST_F(OsgbRunTest, WaterThatIsNoiseIsTakenOutOfAllLevels) {
  WriteScene(OsgbScene(OsgbScene::Pond::kNoise));
  const Ended ended = Tilemend({"run", folder_ / "scene", "--out", folder_ / "out", "--water", PondPolygon(true)});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const Json report = ReportOf(folder_ / "out");
  const double level = report["water"][0]["level_m"];
  EXPECT_NEAR(level, OsgbScene::kLevel, 0.1);
  EXPECT_GT(report["cleared"]["triangles"].get<int64_t>(), 1000);
  for (const int col : {0, 1}) {
    const Pair pair = MadeTile(col);
    ExpectOriginalsKept(pair, true);
    ExpectLevelWater(pair, col, level);
  }
}

TEST_F(OsgbRunTest, FillsHaveTheColourOfTheirRim) {
  WriteScene(OsgbScene(OsgbScene::Pond::kHole, 80, PngImage(4, 4, [](int32_t, int32_t) { return Rgb{20, 120, 40}; })));
  ASSERT_EQ(Tilemend({"run", folder_ / "scene", "--out", folder_ / "out"}).code, 0);
  const Json report = ReportOf(folder_ / "out");
  EXPECT_THAT(report.dump(), HasSubstr("#147828"));
}

// How far the mean colour of all images of new geometries is from `colour`, by level.
std::vector<double> DistancesOfFills(const TileTree& before, const TileTree& after, Rgb colour) {
  std::vector<double> distances(static_cast<size_t>(after.levels), NAN);
  for (const TreePiece& piece : after.pieces) {
    const auto f = static_cast<size_t>(piece.file);
    const TreeFile& file = after.files[f];
    if (file.geometries.size() == before.files[f].geometries.size()) continue;
    for (const TreeGeometry& geometry : file.geometries) {
      if (geometry.texture < 0 || geometry.part != piece.part) continue;
      const TreeImage& image = file.images[static_cast<size_t>(geometry.texture)];
      if (image.name.find("tilemend") == std::string::npos) continue;
      const auto pixels = DecodeImage(after.packed[f].bytes.substr(image.offset, image.size), image.name);
      EXPECT_TRUE(pixels.ok()) << pixels.status();
      if (!pixels.ok()) continue;
      const auto& uv = file.uv[static_cast<size_t>(geometry.first_vertex)];
      const Rgb seen = TexelAt(*pixels, double{uv[0]}, double{uv[1]});
      distances[static_cast<size_t>(piece.level)] =
          std::max({std::abs(seen.r - colour.r), std::abs(seen.g - colour.g), std::abs(seen.b - colour.b)});
    }
  }
  return distances;
}

TEST_F(OsgbRunTest, FillsOfAllLevelsHaveATexture) {
  const Rgb ground = {90, 120, 40};
  WriteScene(OsgbScene(OsgbScene::Pond::kHole, 161, JpegImage(64, 64, [&](int32_t, int32_t) { return ground; })));
  ASSERT_EQ(Tilemend({"run", folder_ / "scene", "--out", folder_ / "out"}).code, 0);
  for (const int col : {0, 1}) {
    const Pair pair = MadeTile(col);
    ExpectOriginalsKept(pair, false);
    const auto before = ReadTileTree(pair.before_bytes, "before.osgb"),
               after = ReadTileTree(pair.after_bytes, "a.osgb");
    ASSERT_TRUE(before.ok() && after.ok());
    for (const double distance : DistancesOfFills(*before, *after, ground)) EXPECT_LE(distance, 25);
  }
  ASSERT_EQ(Tilemend({"run", folder_ / "scene", "--out", folder_ / "four", "--workers", "4"}).code, 0);
  EXPECT_EQ(FilesBelow(folder_ / "out/Data"), FilesBelow(folder_ / "four/Data"));
  ASSERT_EQ(Tilemend({"run", folder_ / "scene", "--out", folder_ / "flat", "--texture", "flat"}).code, 0);
  EXPECT_NE(FilesBelow(folder_ / "out/Data"), FilesBelow(folder_ / "flat/Data"));
}

TEST_F(OsgbRunTest, AScenesOutputHasNothingToFill) {
  WriteScene(OsgbScene());
  ASSERT_EQ(Tilemend({"run", folder_ / "scene", "--out", folder_ / "out"}).code, 0);
  ASSERT_EQ(Tilemend({"run", folder_ / "out", "--out", folder_ / "again"}).code, 0);
  EXPECT_EQ(ReportOf(folder_ / "again")["holes"].dump(), ReportOf(folder_ / "again")["filled"].dump());
  for (const auto& [path, bytes] : FilesBelow(folder_ / "out/Data")) {
    EXPECT_EQ(bytes, *ReadFile(folder_ / ("again/Data/" + path))) << path;
  }
}

TEST_F(OsgbRunTest, TheAcceptanceCheckComparesAllLevels) {
  WriteScene(OsgbScene());
  ASSERT_EQ(Tilemend({"run", folder_ / "scene", "--out", folder_ / "out", "--water", PondPolygon(false)}).code, 0);
  const Ended good = Tilemend({"check", folder_ / "scene", folder_ / "out"});
  EXPECT_EQ(good.code, 0) << good.out << good.err;
  // The coarsest level without a triangle.
  const std::string name = OsgbScene::TileName(0), path = "out/Data/" + name + "/" + name + ".osgb";
  const std::string bytes = *ReadFile(folder_ / path);
  const auto file = ReadOsgb(bytes, path);
  ASSERT_TRUE(file.ok()) << file.status();
  std::vector<bool> drop(file->triangles.size(), false);
  drop[0] = true;
  folder_.Write(path, *DropOsgbTriangles(bytes, drop, path));
  const Ended bad = Tilemend({"check", folder_ / "scene", folder_ / "out"});
  EXPECT_EQ(bad.code, 100);
  EXPECT_THAT(bad.out, HasSubstr("1  original face that is missing or changed"));
  // And as it was in the scene, with its hole.
  folder_.Write(path, *ReadFile(folder_ / ("scene/Data/" + name + "/" + name + ".osgb")));
  const Ended unfilled = Tilemend({"check", folder_ / "scene", folder_ / "out"});
  EXPECT_EQ(unfilled.code, 100);
  EXPECT_THAT(unfilled.out, HasSubstr("1  level of detail of tiles that was not filled"));
}

TEST_F(OsgbRunTest, AnyNumberOfWorkersGivesTheSameBytes) {
  WriteScene(OsgbScene());
  ASSERT_EQ(Tilemend({"run", folder_ / "scene", "--out", folder_ / "one", "--workers", "1"}).code, 0);
  ASSERT_EQ(Tilemend({"run", folder_ / "scene", "--out", folder_ / "four", "--workers", "4"}).code, 0);
  EXPECT_EQ(FilesBelow(folder_ / "one/Data"), FilesBelow(folder_ / "four/Data"));
}

TEST_F(OsgbRunTest, DamagedFilesAreNamed) {
  WriteScene(OsgbScene());
  const std::string name = OsgbScene::TileName(1), damaged = "Data/" + name + "/" + name + "_L2_3.osgb";
  const std::string bytes = OsgbScene().Files().at(damaged);
  folder_.Write("scene/" + damaged, bytes.substr(0, bytes.size() / 2));
  const Ended ended = Tilemend({"run", folder_ / "scene", "--out", folder_ / "out"});
  EXPECT_NE(ended.code, 0);
  EXPECT_THAT(ended.err + ended.out, HasSubstr(name + "_L2_3.osgb"));
}

// In the middle of the canal.
void ExpectLevelCanal(const Pair& pair, double level) {
  const auto tile = ReadTileTree(pair.after_bytes, "after.osgb");
  ASSERT_TRUE(tile.ok()) << tile.status();
  for (int32_t l = 0; l < tile->levels; ++l) {
    const TreeLevel is = LevelOf(*tile, l);
    int all = 0, flat = 0;
    for (double x = 4; x < 95; x += 2.7) {
      for (double y = 1552; y < 1559; y += 1.7) {
        ++all;
        flat += std::abs(TopAt(is.mesh, {x, y}) - level) <= 0.02 ? 1 : 0;
      }
    }
    EXPECT_GE(flat, 0.97 * all) << "level " << l;
  }
}

// The canal of a real export is there as noise. Set TILEMEND_SHARED_DATA to run it.
class OsgbCanalTest : public OsgbRunTest {
 protected:
  static constexpr char kTile[] = "/Tile_+000_+015/Tile_+000_+015.osgb";

  // A decision gives the canal of the output another level, and only its tile changes.
  void ExpectDecisionOnCanal(const std::string& polygon, double level) {
    const auto tiles = FilesBelow(folder_ / "out");
    const std::string marks = folder_.Write("marks.geojson", DecisionsOnHoles(folder_ / "out", "water", level));
    const Ended again =
        Tilemend({"run", folder_ / "scene", "--out", folder_ / "out", "--water", polygon, "--decisions", marks});
    ASSERT_TRUE(again.code == 0 || again.code == 100) << again.err;
    ExpectLevelCanal(Read(folder_ / (std::string("scene") + kTile), folder_ / (std::string("out") + kTile)), level);
    EXPECT_EQ(ReportOf(folder_ / "out")["tasks"]["tiles_kept"], 3);
    for (const auto& [path, bytes] : FilesBelow(folder_ / "out")) {
      if (!path.ends_with(".osgb") || path.starts_with("Tile_+000_+015/")) continue;
      EXPECT_EQ(bytes, tiles.at(path)) << path;
    }
  }
};

TEST_F(OsgbCanalTest, OfARealExport) {
  const char* const variable = std::getenv("TILEMEND_SHARED_DATA");
  const std::string data = absl::StrCat(variable != nullptr ? variable : TILEMEND_SHARED_DATA, "/cc_tiles/osgb");
  if (!std::filesystem::exists(data)) GTEST_SKIP() << "NO OSGB EXPORT at " << data << "; set TILEMEND_SHARED_DATA";
  const std::string polygon = folder_.Write("canal.geojson", R"({"type": "Feature",
      "crs": {"type": "name", "properties": {"name": "EPSG:4547"}}, "properties": {"name": "canal", "clear": true},
      "geometry": {"type": "Polygon", "coordinates": [[[501029, 2490258], [501058, 2490262], [501088, 2490264],
      [501124, 2490273], [501124, 2490294], [501100, 2490292], [501080, 2490290], [501068, 2490288],
      [501050, 2490283], [501029, 2490280], [501029, 2490258]]]}})");
  std::filesystem::copy(data, folder_ / "scene", std::filesystem::copy_options::recursive);
  folder_.Write("scene/metadata.xml",
                "<ModelMetadata><SRS>EPSG:4547</SRS>"
                "<SRSOrigin>501027.524,2488718.808,0</SRSOrigin></ModelMetadata>");
  Json json = {
      {"crs", "EPSG:4547"}, {"origin", {501027.524, 2488718.808, 0}}, {"cell_size", 100}, {"cols", 1}, {"rows", 18}};
  for (int row = 14; row < 18; ++row) {
    const std::string name = absl::StrCat("Tile_+000_+0", row);
    json["tiles"].push_back({{"col", 0}, {"row", row}, {"path", name + "/" + name + ".osgb"}});
  }
  folder_.Write("scene/scene.json", json.dump());
  const Ended ended = Tilemend({"run", folder_ / "scene", "--out", folder_ / "out", "--water", polygon});
  ASSERT_TRUE(ended.code == 0 || ended.code == 100) << ended.err;
  const Json report = ReportOf(folder_ / "out");
  ASSERT_EQ(report["water"].size(), 1U) << ended.out << ended.err;
  const double level = report["water"][0]["level_m"];
  EXPECT_NEAR(level, 0.905, 0.05);
  const Pair pair = Read(folder_ / (std::string("scene") + kTile), folder_ / (std::string("out") + kTile));
  ExpectOriginalsKept(pair, true);
  ExpectLevelCanal(pair, level);
  ExpectDecisionOnCanal(polygon, level - 0.25);
}

}  // namespace
}  // namespace tilemend
