// Tiles in another format from the command line: each as the others, and what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <numeric>
#include <string>
#include <vector>

#include "absl/strings/str_cat.h"
#include "common/codec/mesh_file.h"
#include "common/codec/obj.h"
#include "common/codec/ply_colours.h"
#include "common/codec/tree/tile_tree.h"
#include "common/util/files.h"
#include "common/util/tile_files.h"
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

constexpr char kFirstTile[] = "out/Data/Tile_+000_+000/Tile_+000_+000.osgb";
const Point2 kMiddle = {OsgbScene::kCell, OsgbScene::kCell / 2};  // of the pond

class FormatRunTest : public ::testing::Test {
 protected:
  Ended Tilemend(const std::vector<std::string>& words) {
    return Process(folder_.path(), TILEMEND_CLIENT, words).Wait();
  }
  void WriteOsgb() {
    for (const auto& [path, bytes] : OsgbScene().Files()) folder_.Write("scene/" + path, bytes);
    WriteScene("osgb", "EPSG:25832");
  }
  void WriteScene(const std::string& ending, const std::string& crs) {
    Json json = {{"origin", {500000, 5600000, 0}}, {"cell_size", 64}, {"cols", 2}, {"rows", 1}};
    if (!crs.empty()) json["crs"] = crs;
    for (const int col : {0, 1}) {
      const std::string name = OsgbScene::TileName(col);
      json["tiles"].push_back({{"col", col}, {"row", 0}, {"path", "Data/" + name + "/" + name + "." + ending}});
    }
    folder_.Write("scene/scene.json", json.dump());
  }
  // Runs the job in the format of the tiles as well, and gives the tree of one tile of it.
  TileTree SameFormat(int col) {
    EXPECT_EQ(Tilemend({"run", folder_ / "scene", "--out", folder_ / "same", "--overwrite"}).code, 0);
    const std::string name = OsgbScene::TileName(col);
    same_ = *ReadTileBytes(folder_ / ("same/Data/" + name + "/" + name + ".osgb"));
    return *ReadTileTree(same_, "same.osgb");
  }

  // `check` accepts the output, and a run on it finds no hole.
  void ExpectNothingIsLeft() {
    EXPECT_EQ(Tilemend({"check", folder_ / "out"}).code, 0);
    EXPECT_EQ(Tilemend({"run", folder_ / "out", "--out", folder_ / "again"}).code, 0);
    EXPECT_EQ(ReportOf(folder_ / "again")["per_hole"].size(), 0U);
  }

  // How far beyond the pond the middle of a triangle lies, metres. Triangles that are missing have it within.
  static double BeyondPond(const TriMesh& mesh, size_t t) {
    const Triangle& corners = mesh.triangles[t];
    const Point3 middle = (mesh.points[corners[0]] + mesh.points[corners[1]] + mesh.points[corners[2]]) / 3;
    return (middle.head<2>() - kMiddle).norm() - OsgbScene::kRadius;
  }

  const TemporaryFolder folder_;
  std::string same_;
};

TEST_F(FormatRunTest, OsgbBecomesATilesetWithTheSameLevels) {
  WriteOsgb();
  const Ended ended = Tilemend({"run", folder_ / "scene", "--out", folder_ / "out", "--output-format", "3dtiles"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  for (const int col : {0, 1}) {
    const std::string name = absl::StrCat("Tile_p00", col, "_p000");
    const std::string bytes = *ReadTileBytes(folder_ / ("out/Data/" + name + "/" + name + ".json"));
    const auto tree = ReadTileTree(bytes, name);
    ASSERT_TRUE(tree.ok()) << tree.status();
    const TileTree same = SameFormat(col);
    ASSERT_EQ(tree->levels, same.levels);
    for (int32_t l = 0; l < same.levels; ++l) {
      const TreeLevel is = LevelOf(*tree, l), was = LevelOf(same, l);
      EXPECT_EQ(is.mesh.triangles.size(), was.mesh.triangles.size()) << "level " << l;
      const Point2 at = kMiddle + Point2(col == 0 ? -3 : 3, 1);
      EXPECT_EQ(TopAt(is.mesh, at), TopAt(was.mesh, at)) << "level " << l;
    }
  }
  // With its area and CRS, on the Earth at the meridian of the zone, and without a hole.
  ExpectNothingIsLeft();
  for (const char* const out : {"out", "again"}) {
    const Json json = Json::parse(*ReadFile(folder_ / (std::string(out) + "/scene.json")));
    EXPECT_EQ(json["crs"], "EPSG:25832") << out;
    EXPECT_EQ(json["tileset"], "tileset.json") << out;
    EXPECT_FALSE(json.contains("area_known")) << "it is";
  }
  EXPECT_EQ(*ReadFile(folder_ / "again/scene.json"), *ReadFile(folder_ / "out/scene.json"));
  const Json entry = Json::parse(*ReadFile(folder_ / "out/tileset.json"));
  EXPECT_EQ(entry["root"]["children"].size(), 2U);
  EXPECT_NEAR(std::atan2(entry["root"]["transform"][13].get<double>(), entry["root"]["transform"][12].get<double>()),
              9 * M_PI / 180, 1e-4);
}

// Its coordinates might be Earth-centred ones.
TEST_F(FormatRunTest, TilesFarFromTheOriginStayInTheirFrame) {
  std::string obj;
  for (int j = 0; j <= 8; ++j) {
    for (int i = 0; i <= 8; ++i) absl::StrAppend(&obj, "v ", i, " ", 6371000 + j, " 0\n");
  }
  for (int a = 1; a <= 72; ++a) {
    if (a % 9 == 0 || a == 41) continue;
    absl::StrAppend(&obj, "f ", a, " ", a + 1, " ", a + 10, "\nf ", a, " ", a + 10, " ", a + 9, "\n");
  }
  folder_.Write("scene/a.obj", obj);
  folder_.Write("scene/scene.json", R"({"grid_corner": [0, 6371000], "cell_size": 8, "cols": 1, "rows": 1,
      "tiles": [{"col": 0, "row": 0, "path": "a.obj"}]})");
  const Ended ended = Tilemend({"run", folder_ / "scene", "--out", folder_ / "out", "--output-format", "3dtiles"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(ReportOf(folder_ / "out")["per_hole"].size(), 1U);
  ExpectNothingIsLeft();
}

TEST_F(FormatRunTest, OsgbBecomesObjOfTheFinestLevelWithItsImages) {
  WriteOsgb();
  const Ended ended = Tilemend({"run", folder_ / "scene", "--out", folder_ / "out", "--output-format", "obj"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const std::string name = OsgbScene::TileName(0), stem = "out/Data/" + name + "/" + name;
  const auto file = ParseMesh(MeshFormat::kObj, *ReadFile(folder_ / (stem + ".obj")), "obj");
  ASSERT_TRUE(file.ok()) << file.status();
  const TileTree same = SameFormat(0);
  const TreeLevel was = LevelOf(same, 2);
  EXPECT_EQ(file->mesh.triangles.size(), was.mesh.triangles.size());
  EXPECT_EQ(TopAt(file->mesh, kMiddle - Point2(3, 1)), TopAt(was.mesh, kMiddle - Point2(3, 1)));
  EXPECT_EQ(*ReadFile(folder_ / (stem + "_0.jpg")), "\xff\xd8\xff no image");
  EXPECT_THAT(*ReadFile(folder_ / (stem + ".mtl")), HasSubstr("map_Kd " + name + "_3.jpg"));
  EXPECT_EQ(Json::parse(*ReadFile(folder_ / "out/scene.json"))["crs"], "EPSG:25832");
  const auto obj = ParseTexturedObj(*ReadFile(folder_ / (stem + ".obj")), "obj");
  ASSERT_EQ(obj->textures.groups.size(), 1U);
  EXPECT_TRUE(obj->textures.groups[0].is_filled);
  for (size_t t = 0; t < file->mesh.triangles.size(); ++t) {
    const bool is_filled = t >= static_cast<size_t>(obj->textures.groups[0].first);
    const double beyond = BeyondPond(file->mesh, t);
    EXPECT_TRUE(is_filled ? beyond < 1 : beyond >= 0) << t << ", " << beyond;
  }
  ExpectNothingIsLeft();
}

TEST_F(FormatRunTest, TilesetsBecomeObj) {
  for (const auto& [path, bytes] : TilesetScene{.files = TilesetScene::Files::kOfTiles}.All())
    folder_.Write("scene/" + path, bytes);
  const Ended ended = Tilemend({"run", folder_ / "scene", "--out", folder_ / "out", "--output-format", "obj"});
  ASSERT_TRUE(ended.code == 0 || ended.code == 100) << ended.err;
  const std::string stem = "out/Data/Tile_p000_p000/Tile_p000_p000";
  EXPECT_TRUE(ParseMesh(MeshFormat::kObj, *ReadFile(folder_ / (stem + ".obj")), "obj").ok());
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out/tileset.json"));
}

TEST_F(FormatRunTest, ObjBecomesATilesetOfOneLevel) {
  WriteOsgb();
  ASSERT_EQ(Tilemend({"run", folder_ / "scene", "--out", folder_ / "objs", "--output-format", "obj"}).code, 0);
  const Ended ended = Tilemend({"run", folder_ / "objs", "--out", folder_ / "out", "--output-format", "3dtiles"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const std::string path = folder_ / "out/Data/Tile_p001_p000/Tile_p001_p000.json";
  const std::string bytes = *ReadTileBytes(path);
  const auto tree = ReadTileTree(bytes, path);
  ASSERT_TRUE(tree.ok()) << tree.status();
  EXPECT_EQ(tree->levels, 1);
  EXPECT_NEAR(TopAt(LevelOf(*tree, 0).mesh, kMiddle + Point2(3, 1)), OsgbScene::kLevel, 0.2);
  EXPECT_EQ(tree->files.back().images.size(), 4U);
}

TEST_F(FormatRunTest, ObjBecomesOsgbOfOneLevel) {
  WriteOsgb();
  ASSERT_EQ(Tilemend({"run", folder_ / "scene", "--out", folder_ / "objs", "--output-format", "obj"}).code, 0);
  std::filesystem::remove(folder_ / "objs/metadata.xml");
  const Ended ended = Tilemend({"run", folder_ / "objs", "--out", folder_ / "out", "--output-format", "osgb"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const TileTree same = SameFormat(0);
  const std::string bytes = *ReadTileBytes(folder_ / kFirstTile);
  const auto tree = ReadTileTree(bytes, kFirstTile);
  ASSERT_TRUE(tree.ok()) << tree.status();
  EXPECT_EQ(tree->levels, 1);
  const TriMesh is = LevelOf(*tree, 0).mesh, was = LevelOf(same, 2).mesh;
  EXPECT_EQ(is.triangles.size(), was.triangles.size());
  EXPECT_EQ(TopAt(is, kMiddle - Point2(3, 1)), TopAt(was, kMiddle - Point2(3, 1)));
  EXPECT_EQ(tree->files[0].images.size(), 4U);
  EXPECT_THAT(*ReadFile(folder_ / "out/metadata.xml"), HasSubstr("<SRSOrigin>500000,5600000,0</SRSOrigin>"));
  EXPECT_THAT(ReportOf(folder_ / "out")["warnings"].dump(), HasSubstr("rounded to float32"));
  ExpectNothingIsLeft();
}

TEST_F(FormatRunTest, TilesetsBecomeOsgbWithTheSameLevels) {
  WriteOsgb();
  ASSERT_EQ(Tilemend({"run", folder_ / "scene", "--out", folder_ / "set", "--output-format", "3dtiles"}).code, 0);
  const Ended ended = Tilemend({"run", folder_ / "set", "--out", folder_ / "out", "--output-format", "osgb"});
  ASSERT_TRUE(ended.code == 0 || ended.code == 100) << ended.err;
  const TileTree same = SameFormat(0);
  const std::string bytes = *ReadTileBytes(folder_ / kFirstTile);
  const auto tree = ReadTileTree(bytes, kFirstTile);
  ASSERT_TRUE(tree.ok()) << tree.status();
  ASSERT_EQ(tree->levels, same.levels);
  for (int32_t l = 0; l < same.levels; ++l) {
    EXPECT_EQ(LevelOf(*tree, l).mesh.triangles.size(), LevelOf(same, l).mesh.triangles.size()) << "level " << l;
  }
}

TEST_F(FormatRunTest, OsgbBecomesPlyWithItsImages) {
  WriteOsgb();
  const Ended ended = Tilemend({"run", folder_ / "scene", "--out", folder_ / "out", "--output-format", "ply"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const std::string name = OsgbScene::TileName(0), stem = "out/Data/" + name + "/" + name;
  const auto file = ParseMesh(MeshFormat::kPly, *ReadFile(folder_ / (stem + ".ply")), "ply");
  ASSERT_TRUE(file.ok()) << file.status();
  const TileTree same = SameFormat(0);
  const TreeLevel was = LevelOf(same, 2);
  EXPECT_EQ(file->mesh.triangles.size(), was.mesh.triangles.size());
  EXPECT_EQ(TopAt(file->mesh, kMiddle - Point2(3, 1)), TopAt(was.mesh, kMiddle - Point2(3, 1)));
  EXPECT_EQ(*ReadFile(folder_ / (stem + "_0.jpg")), "\xff\xd8\xff no image");
  EXPECT_THAT(ReportOf(folder_ / "out")["warnings"].dump(), HasSubstr("the finest level of detail alone"));
  ExpectNothingIsLeft();
  const Ended from_ply = Tilemend({"run", folder_ / "out", "--out", folder_ / "set", "--output-format", "3dtiles"});
  EXPECT_EQ(from_ply.code, 4);
  EXPECT_THAT(from_ply.err, HasSubstr("PLY tiles have their colours at vertices"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "set"));
}

TEST_F(FormatRunTest, ColoursOfVerticesOfAnObjAreThoseOfThePly) {
  std::string obj;
  for (int j = 0; j <= 8; ++j) {
    for (int i = 0; i <= 8; ++i) absl::StrAppend(&obj, "v ", i, " ", j, " ", 0.02 * (i % 2), " 0.2 0.6 0.4\n");
  }
  for (int j = 0; j < 8; ++j) {
    for (int i = 0; i < 8; ++i) {
      const int a = 9 * j + i + 1;
      const bool is_hole = i >= 3 && i < 5 && j >= 3 && j < 5;
      if (!is_hole) absl::StrAppend(&obj, "f ", a, " ", a + 1, " ", a + 10, "\nf ", a, " ", a + 10, " ", a + 9, "\n");
    }
  }
  folder_.Write("scene/a.obj", obj);
  folder_.Write("scene/scene.json",
                R"({"cell_size": 8, "cols": 1, "rows": 1, "tiles": [{"col": 0, "row": 0, "path": "a.obj"}]})");
  ASSERT_EQ(Tilemend({"run", folder_ / "scene", "--out", folder_ / "out", "--output-format", "ply"}).code, 0);
  const std::string ply = *ReadFile(folder_ / "out/a/a.ply");
  const size_t points = ParseMesh(MeshFormat::kPly, ply, "ply")->mesh.points.size();
  std::vector<int32_t> vertices(points);
  std::iota(vertices.begin(), vertices.end(), 0);
  EXPECT_THAT(PlyVertexColours(ply, vertices, "ply").value(), ::testing::Each(Rgb{51, 153, 102}))
      << "those of the fill are the rim's";
  EXPECT_THAT(ply, HasSubstr("property uchar tilemend_filled\n"));
  EXPECT_THAT(ReportOf(folder_ / "out")["warnings"].dump(), ::testing::Not(HasSubstr("colours of vertices")));
  ExpectNothingIsLeft();
  ASSERT_EQ(Tilemend({"run", folder_ / "scene", "--out", folder_ / "set", "--output-format", "3dtiles"}).code, 0);
  EXPECT_THAT(ReportOf(folder_ / "set")["warnings"].dump(), HasSubstr("colours of vertices are not written"));
}

TEST_F(FormatRunTest, AnyNumberOfWorkersGivesTheSameBytes) {
  WriteOsgb();
  ASSERT_EQ(Tilemend({"run", folder_ / "scene", "--out", folder_ / "set", "--output-format", "3dtiles"}).code, 0);
  for (const auto& [scene, format] : {std::pair("scene", "3dtiles"), {"scene", "ply"}, {"set", "osgb"}}) {
    for (const std::string n : {"1", "4"}) {
      const Ended ended = Tilemend(
          {"run", folder_ / scene, "--out", folder_ / (format + n), "--output-format", format, "--workers", n});
      ASSERT_TRUE(ended.code == 0 || ended.code == 100) << ended.err;
    }
    const std::string one = absl::StrCat(format, "1"), four = absl::StrCat(format, "4");
    EXPECT_EQ(FilesBelow(folder_ / (one + "/Data")), FilesBelow(folder_ / (four + "/Data"))) << format;
  }
  EXPECT_EQ(*ReadFile(folder_ / "3dtiles1/tileset.json"), *ReadFile(folder_ / "3dtiles4/tileset.json"));
}

TEST_F(FormatRunTest, CellsAreAddedToAnOutput) {
  WriteOsgb();
  ASSERT_EQ(Tilemend({"run", folder_ / "scene", "--out", folder_ / "objs", "--output-format", "obj"}).code, 0);
  const auto run = [&](const std::string& out, const std::string& cells) {
    std::vector<std::string> words = {"run", folder_ / "objs", "--out", folder_ / out, "--output-format", "osgb"};
    if (!cells.empty()) words.insert(words.end(), {"--cells", cells});
    const Ended ended = Tilemend(words);
    EXPECT_EQ(ended.code, 0) << ended.err;
  };
  run("out", "0,0");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out/Data/Tile_+001_+000"));
  run("out", "1,0");
  run("whole", "");
  EXPECT_EQ(FilesBelow(folder_ / "out/Data"), FilesBelow(folder_ / "whole/Data"));
}

TEST_F(FormatRunTest, WithoutACrsThereIsAWarning) {
  WriteOsgb();
  WriteScene("osgb", "");
  ASSERT_EQ(Tilemend({"run", folder_ / "scene", "--out", folder_ / "out", "--output-format", "3dtiles"}).code, 0);
  EXPECT_THAT(ReportOf(folder_ / "out")["warnings"].dump(), HasSubstr("no place on the Earth"));
  EXPECT_FALSE(Json::parse(*ReadFile(folder_ / "out/tileset.json"))["root"].contains("transform"));
}

TEST_F(FormatRunTest, WhatIsNotPossibleIsRefusedBeforeAnythingIsWritten) {
  WriteOsgb();
  folder_.Write("scene/scene.json", R"({"grid_corner": [0, 5600000], "cell_size": 64, "cols": 1, "rows": 1,
      "tiles": [{"col": 0, "row": 0, "path": "a.obj"}]})");
  folder_.Write("scene/a.obj", "v 0 5600000 0\nv 1 5600000 0\nv 0 5600001 0\nf 1 2 3\n");
  const Ended ended = Tilemend({"run", folder_ / "scene", "--out", folder_ / "out", "--output-format", "osgb"});
  EXPECT_EQ(ended.code, 4);
  EXPECT_THAT(ended.err, HasSubstr("take the scene's origin nearer"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
  const Ended unknown = Tilemend({"run", folder_ / "scene", "--out", folder_ / "out", "--output-format", "fbx"});
  EXPECT_EQ(unknown.code, 2);
}

TEST_F(FormatRunTest, TheAcceptanceCheckComparesWithTheSceneAsItWouldBeInThatFormat) {
  WriteOsgb();
  for (const std::string format : {"3dtiles", "obj", "ply"}) {
    const Ended ended =
        Tilemend({"run", folder_ / "scene", "--out", folder_ / format, "--output-format", format, "--check"});
    EXPECT_EQ(ended.code, 0) << format << ended.out << ended.err;
  }
  for (const auto& [scene, format] :
       {std::pair("obj", "3dtiles"), {"obj", "osgb"}, {"3dtiles", "osgb"}, {"3dtiles", "obj"}}) {
    const std::string out = folder_ / (std::string(format) + "_of_" + scene);
    const Ended ended = Tilemend({"run", folder_ / scene, "--out", out, "--output-format", format, "--check"});
    EXPECT_EQ(ended.code, 0) << format << " of " << scene << ended.out << ended.err;
  }
}

TEST_F(FormatRunTest, TheAcceptanceCheckKnowsWhatWasCleared) {
  for (const auto& [path, bytes] : OsgbScene(OsgbScene::Pond::kNoise).Files()) folder_.Write("scene/" + path, bytes);
  WriteScene("osgb", "");
  folder_.Write("pond.geojson", R"({"type": "FeatureCollection", "features": [{"type": "Feature",
      "properties": {"clear": true}, "geometry": {"type": "Polygon",
      "coordinates": [[[50, 20], [78, 20], [78, 44], [50, 44], [50, 20]]]}}]})");
  for (const std::string format : {"same", "3dtiles", "obj", "ply"}) {
    const Ended ended = Tilemend({"run", folder_ / "scene", "--out", folder_ / format, "--output-format", format,
                                  "--water", folder_ / "pond.geojson", "--check"});
    EXPECT_EQ(ended.code, 0) << format << ended.out << ended.err;
    EXPECT_GT(ReportOf(folder_ / format)["cleared"]["triangles"], 0);
  }
}

// Beyond the two cells lies one that the area alone brings in. It is filled.
TEST_F(FormatRunTest, TheAcceptanceCheckKnowsCellsThatTheAreaAdds) {
  WriteOsgb();
  folder_.Write("area.geojson", R"({"type": "FeatureCollection", "features": [{"type": "Feature", "properties": {},
      "geometry": {"type": "Polygon", "coordinates": [[[-4, 2], [126, 2], [126, 62], [-4, 62], [-4, 2]]]}}]})");
  for (const std::string format : {"3dtiles", "obj"}) {
    const Ended ended = Tilemend({"run", folder_ / "scene", "--out", folder_ / format, "--output-format", format,
                                  "--area", folder_ / "area.geojson", "--check"});
    EXPECT_EQ(ended.code, 0) << format << ended.out << ended.err;
    EXPECT_EQ(ReportOf(folder_ / format)["cells"], 3);
  }
}

TEST_F(FormatRunTest, TheAcceptanceCheckFindsWhatIsChangedInAnotherFormat) {
  WriteOsgb();
  const auto check = [&](const std::string& fault) {
    const Ended ended = Tilemend({"check", folder_ / "scene", folder_ / "out", "-o", "json"});
    EXPECT_EQ(ended.code, 100) << ended.err;
    EXPECT_GT(Json::parse(ended.out)["findings"][fault]["count"], 0) << fault;
  };
  const auto run = [&](const std::string& format) {
    const Ended ended = Tilemend(
        {"run", folder_ / "scene", "--out", folder_ / "out", "--output-format", format, "--overwrite", "--check"});
    ASSERT_EQ(ended.code, 0) << ended.out << ended.err;
  };
  run("obj");
  const std::string tile = "out/Data/Tile_+000_+000/Tile_+000_+000";
  const std::string obj = *ReadFile(folder_ / (tile + ".obj")), image = *ReadFile(folder_ / (tile + "_0.jpg"));
  folder_.Write(tile + "_0.jpg", image + "x");
  check("changed_files");
  std::filesystem::remove(folder_ / (tile + "_0.jpg"));
  check("missing_files");
  folder_.Write(tile + "_0.jpg", image);
  std::string moved = obj;
  moved.replace(moved.find("\nv ") + 3, 1, "7");
  folder_.Write(tile + ".obj", moved);
  check("missing_faces");
  folder_.Write(tile + ".obj", obj.substr(0, obj.rfind("f ") + 4));
  check("damaged_tiles");
  run("3dtiles");
  folder_.Write("out/tileset.json", "{}");
  check("placement");
  std::filesystem::remove(folder_ / "out/tileset.json");
  check("placement");
  const std::string model = "out/Data/Tile_p000_p000/Tile_p000_p000_3.glb";
  folder_.Write(model, ReadFile(folder_ / model)->substr(0, 1000));
  check("damaged_tiles");
}

}  // namespace
}  // namespace tilemend
