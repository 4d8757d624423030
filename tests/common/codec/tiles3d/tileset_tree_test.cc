#include "common/codec/tiles3d/tileset_tree.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/tileset_scene.h"

namespace tilemend {
namespace {

using testing::HasSubstr;

// The pack of a scene without the file whose name ends in `without`.
std::string PackWithout(const TilesetScene& scene, const std::string& without) {
  const std::string pack = scene.Pack();
  std::vector<PackedFile> files = *UnpackFiles(pack, "x");
  std::erase_if(files, [&](const PackedFile& file) { return file.name.ends_with(without); });
  return PackFiles(files);
}

TEST(TilesetTreeTest, HasTheLevelsOfItsModels) {
  for (const auto files : {TilesetScene::Files::kOne, TilesetScene::Files::kOfTiles}) {
    const std::string pack = TilesetScene{.files = files}.Pack();
    const auto tree = ReadTilesetTree(pack, "a/tileset.json");
    ASSERT_TRUE(tree.ok()) << tree.status();
    EXPECT_EQ(tree->levels, 3);
    ASSERT_EQ(tree->models.size(), 12u);
    int finest = 0;
    for (const TilesetModel& model : tree->models) {
      EXPECT_EQ(model.is_finest, model.level == 2);
      finest += model.is_finest ? 1 : 0;
    }
    EXPECT_EQ(finest, 8);
  }
}

TEST(TilesetTreeTest, PointsAreInTheFrameOfTheScene) {
  const std::string local = TilesetScene().Pack();
  const auto plain = ReadTilesetTree(local, "a/tileset.json");
  const std::string on_earth = TilesetScene{.place = TilesetScene::Place::kOnEarth}.Pack();
  const auto same = ReadTilesetTree(on_earth, "a/tileset.json");
  ASSERT_TRUE(plain.ok() && same.ok()) << plain.status() << same.status();
  EXPECT_EQ(plain->models[3].gltf.points, same->models[3].gltf.points);
  const std::string centred = TilesetScene{.place = TilesetScene::Place::kEarthCentred}.Pack();
  const auto turned = ReadTilesetTree(centred, "a/tileset.json");
  ASSERT_TRUE(turned.ok()) << turned.status();
  for (size_t i = 0; i < plain->models[3].gltf.points.size(); ++i) {
    const Point3 moved = plain->models[3].gltf.points[i] - Point3(64, 32, 2);
    EXPECT_NEAR((turned->models[3].gltf.points[i] - moved).norm(), 0, 2e-3);
  }
}

TEST(TilesetTreeTest, AModelWithoutItsFinerOnesIsTheFinest) {
  const std::string pack = PackWithout({}, ".glb");
  EXPECT_THAT(ReadTilesetTree(pack, "a/t.json").status().message(), HasSubstr("a/t.json: no vertices"));
  const std::string whole = TilesetScene().Pack();
  std::vector<PackedFile> files = *UnpackFiles(whole, "x");
  std::erase_if(files, [](const PackedFile& f) { return f.name.find("Tile_p000_p000_L2_") != std::string::npos; });
  const std::string cut = PackFiles(files);
  const auto tree = ReadTilesetTree(cut, "a/t.json");
  ASSERT_TRUE(tree.ok()) << tree.status();
  EXPECT_TRUE(tree->models[1].is_finest);
  EXPECT_EQ(tree->models[1].level, 1);
}

TEST(TilesetTreeTest, ErrorsNameTheFile) {
  const std::string pack = TilesetScene().Pack();
  auto files = *UnpackFiles(pack, "x");
  files[2].bytes = files[2].bytes.substr(0, files[2].bytes.size() / 2);
  const std::string cut = PackFiles(files);
  EXPECT_THAT(ReadTilesetTree(cut, "folder/tileset.json").status().message(), HasSubstr("folder/" + files[2].name));
  files[0].bytes = "{";
  const std::string damaged = PackFiles(files);
  EXPECT_THAT(ReadTilesetTree(damaged, "folder/tileset.json").status().message(),
              HasSubstr("folder/tileset.json: byte"));
  EXPECT_FALSE(ReadTilesetTree(PackFiles({}), "folder/tileset.json").ok());
}

TEST(TilesetTreeTest, VerticesFarAwayAreRefused) {
  const std::string pack = TilesetScene().Pack();
  auto files = *UnpackFiles(pack, "x");
  auto entry = nlohmann::json::parse(files[0].bytes);
  entry["root"]["children"][1]["transform"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 2e9, 0, 1};
  const std::string text = entry.dump();
  files[0].bytes = text;
  EXPECT_THAT(ReadTilesetTree(PackFiles(files), "a/t.json").status().message(),
              HasSubstr("a/Data/Tile_p001_p000/Tile_p001_p000.glb: a vertex lies more than 1e9 m"));
}

TEST(TilesetTreeTest, ChangesGrowVolumesAndLeaveOtherFiles) {
  for (const auto place : {TilesetScene::Place::kLocal, TilesetScene::Place::kOnEarth}) {
    const std::string pack = TilesetScene{.files = TilesetScene::Files::kOfTiles, .place = place}.Pack();
    const auto before = ReadTilesetTree(pack, "a/t.json");
    ASSERT_TRUE(before.ok()) << before.status();
    std::vector<TilesetEdit> edits(before->packed.size());
    const TilesetModel& changed = before->models[2];
    GltfPatch patch;
    patch.points = {{1, 1, 9}, {2, 1, 9}, {1, 2, 9}};
    patch.triangles = {{0, 1, 2}};
    edits[static_cast<size_t>(changed.file)].patches = {patch};
    const auto bytes = ChangeTilesetTree(before->packed, edits, "a/t.json");
    ASSERT_TRUE(bytes.ok()) << bytes.status();
    const auto after = ReadTilesetTree(*bytes, "a/t.json");
    ASSERT_TRUE(after.ok()) << after.status();
    EXPECT_EQ(after->models[2].gltf.triangles.size(), changed.gltf.triangles.size() + 1);
    EXPECT_EQ(after->models[2].gltf.points.back(), Point3(1, 2, 9));
    for (size_t f = 0; f < before->packed.size(); ++f) {
      const std::string& name = before->packed[f].name;
      const bool is_new =
          static_cast<int32_t>(f) == changed.file || name == "tileset.json" || name.ends_with("Tile_p000_p000.json");
      EXPECT_EQ(after->packed[f].bytes == before->packed[f].bytes, !is_new) << name;
    }
    const auto entry = nlohmann::json::parse(after->packed[0].bytes);
    const std::vector<double> box = entry["root"]["boundingVolume"]["box"];
    EXPECT_GE(box[2] + box[11], 9);
    EXPECT_NEAR(box[2] - box[11], 1.5, 1e-9) << "the other side stays";
  }
}

TEST(TilesetTreeTest, DropsTriangles) {
  const std::string pack = TilesetScene().Pack();
  const auto before = ReadTilesetTree(pack, "a/t.json");
  ASSERT_TRUE(before.ok()) << before.status();
  std::vector<TilesetEdit> edits(before->packed.size());
  const TilesetModel& model = before->models[1];
  std::vector<bool>& drop = edits[static_cast<size_t>(model.file)].drop;
  drop.assign(model.gltf.triangles.size(), false);
  drop[0] = true;
  const auto bytes = ChangeTilesetTree(before->packed, edits, "a/t.json");
  ASSERT_TRUE(bytes.ok()) << bytes.status();
  const auto after = ReadTilesetTree(*bytes, "a/t.json");
  ASSERT_TRUE(after.ok()) << after.status();
  EXPECT_EQ(after->models[1].gltf.triangles.size(), model.gltf.triangles.size() - 1);
  EXPECT_EQ(after->packed[0].bytes, before->packed[0].bytes);
}

}  // namespace
}  // namespace tilemend
