#include "common/codec/tiles3d/tileset.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "common/codec/gltf/json_view.h"
#include "common/util/files.h"
#include "tests/support/tileset_samples.h"

namespace tilemend {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

// The refusal of a tileset whose root is `root`.
std::string Refusal(const std::string& root, const std::string& version = "1.1") {
  const MemorySource source({{"tileset.json", TilesetJson(root, version)},
                             {"loop.json", TilesetJson(TileJson("loop.json"))},
                             {"back.json", TilesetJson(TileJson("tileset.json"))}});
  return std::string(ReadTileset(source, "tileset.json").status().message());
}

TEST(ReadTilesetTest, FollowsExternalTilesets) {
  const absl::StatusOr<Tileset> tileset = ReadTileset(TwoFileTileset(), "tileset.json");
  ASSERT_TRUE(tileset.ok()) << tileset.status();
  ASSERT_EQ(tileset->tiles.size(), 4u);
  ASSERT_EQ(tileset->documents.size(), 2u);
  EXPECT_EQ(tileset->documents[1].file, "Data/B/b.json");
  const auto& tiles = tileset->tiles;
  EXPECT_EQ(tiles[0].content, "Data/a.glb");
  EXPECT_EQ(tiles[1].content, "Data/a_fine.b3dm");
  EXPECT_EQ(tiles[2].content, "");
  EXPECT_EQ(tiles[3].content, "Data/B/b fine.glb");
  EXPECT_THAT(tiles[0].children, ElementsAre(1, 2));
  EXPECT_THAT(tiles[2].children, ElementsAre(3));
  EXPECT_EQ(tiles[3].document, 1);
  EXPECT_EQ(tiles[3].path, "/root");
  EXPECT_EQ(tiles[1].path, "/root/children/0");
  EXPECT_THAT((std::vector<int32_t>{tiles[0].level, tiles[1].level, tiles[2].level, tiles[3].level}),
              ElementsAre(0, 1, 1, 1));
  EXPECT_EQ(tiles[3].to_root(0, 3), 200);  // moved in both files
  EXPECT_EQ(tiles[0].geometric_error, 2.5);
}

TEST(ReadTilesetTest, ReadsTheAxisOfEachFile) {
  const std::string text = R"({"asset":{"version":"1.0","gltfUpAxis":"Z"},"root":)" + TileJson("a.glb") + "}";
  EXPECT_EQ(ReadTileset(MemorySource({{"t.json", text}}), "t.json")->documents[0].up, GltfUpAxis::kZ);
  EXPECT_EQ(ReadTileset(TwoFileTileset(), "tileset.json")->documents[0].up, GltfUpAxis::kY);
}

TEST(ReadTilesetTest, RefusesByName) {
  const std::string child = ",\"children\":[" + TileJson("b.glb") + "]";
  EXPECT_THAT(Refusal(TileJson("a.glb", ",\"refine\":\"ADD\"" + child)), HasSubstr("JSON /root: refinement ADD"));
  EXPECT_EQ(Refusal(TileJson("a.glb", ",\"refine\":\"ADD\"")), "");  // nothing is added to anything
  EXPECT_THAT(Refusal(TileJson("a.glb", ",\"refine\":\"MORE\"")), HasSubstr("refine is not REPLACE"));
  EXPECT_THAT(Refusal(TileJson("a.glb", ",\"implicitTiling\":{}")), HasSubstr("implicit tiling is not read"));
  EXPECT_THAT(Refusal(TileJson("a.glb", ",\"contents\":[{},{}]")), HasSubstr("several contents"));
  EXPECT_THAT(Refusal(TileJson("a.pnts")), HasSubstr("models are .glb or .b3dm files"));
  EXPECT_THAT(Refusal(TileJson("../a.glb")), HasSubstr("JSON /root/content/uri: the URI \"../a.glb\" is not opened"));
  EXPECT_THAT(Refusal(TileJson("a.glb", ",\"transform\":[0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,1]")),
              HasSubstr("the transform cannot be inverted"));
  EXPECT_THAT(Refusal(TileJson("a.glb"), "0.0"), HasSubstr("3D Tiles 0.0 is not read; expected 1.0 or 1.1"));
  EXPECT_THAT(Refusal("{}"), HasSubstr("JSON /root: expected a member \"boundingVolume\""));
  EXPECT_THAT(Refusal(R"({"boundingVolume":{},"geometricError":1})"),
              HasSubstr("expected a box, a region or a sphere"));
  EXPECT_THAT(Refusal("["), HasSubstr("tileset.json: byte "));
}

TEST(ReadTilesetTest, RefusesCirclesAndSharedModels) {
  for (const char* uri : {"loop.json", "tileset.json", "back.json"}) {
    EXPECT_THAT(Refusal(TileJson(uri)), HasSubstr("a tileset and itself, refer to")) << uri;
  }
  EXPECT_THAT(Refusal(TileJson("a.glb", ",\"children\":[" + TileJson("a.glb") + "]")), HasSubstr("two tiles"));
}

TEST(ReadTilesetTest, LimitsSizes) {
  const auto code = [](const TilesetLimits& limits) {
    return ReadTileset(TwoFileTileset(), "tileset.json", limits).status().code();
  };
  EXPECT_EQ(code({.max_tiles = 3}), absl::StatusCode::kResourceExhausted);
  EXPECT_EQ(code({.max_tiles = 4}), absl::StatusCode::kOk);
  EXPECT_EQ(code({.max_documents = 1}), absl::StatusCode::kResourceExhausted);
  EXPECT_EQ(code({.max_document_bytes = 100}), absl::StatusCode::kResourceExhausted);
  EXPECT_EQ(code({.max_depth = 2}), absl::StatusCode::kResourceExhausted);
}

TEST(ReadTilesetTest, TellsOfMissingFiles) {
  const MemorySource source({{"tileset.json", TilesetJson(TileJson("gone.json"))}});
  EXPECT_EQ(ReadTileset(source, "tileset.json").status().code(), absl::StatusCode::kNotFound);
}

TEST(WriteTilesetDocumentTest, GrowsVolumesUpTheTreeAndKeepsTheRest) {
  Tileset tileset = ReadTileset(TwoFileTileset(), "tileset.json").value();
  const std::string outer = tileset.documents[0].text, inner = tileset.documents[1].text;
  EXPECT_EQ(WriteTilesetDocument(tileset, 0), outer);
  GrowVolumes(tileset, 3, {{0, 0, 2}});
  EXPECT_EQ(WriteTilesetDocument(tileset, 1), inner);  // it held the point
  // Twice moved by (100, 200): the root's box did not.
  EXPECT_EQ(tileset.tiles[0].volume.numbers[0] + tileset.tiles[0].volume.numbers[3], 200);
  GrowVolumes(tileset, 3, {{0, 0, -25}});
  OrderedJson expected = OrderedJson::parse(inner);
  expected["root"]["boundingVolume"]["box"] = tileset.tiles[3].volume.numbers;
  EXPECT_EQ(OrderedJson::parse(WriteTilesetDocument(tileset, 1)), expected);
  EXPECT_EQ(tileset.tiles[3].volume.numbers[2], -10);
  EXPECT_EQ(tileset.tiles[1].volume.numbers[2], 0);  // beside it
}

TEST(WriteTilesetDocumentTest, GrowsTheVolumeOfTheModel) {
  const std::string root = R"({"boundingVolume":{"sphere":[0,0,0,100]},"geometricError":1,
    "content":{"uri":"a.glb","boundingVolume":{"sphere":[0,0,0,2]}}})";
  Tileset tileset = ReadTileset(MemorySource({{"t.json", TilesetJson(root)}}), "t.json").value();
  GrowVolumes(tileset, 0, {{0, 0, 9}});
  const OrderedJson json = OrderedJson::parse(WriteTilesetDocument(tileset, 0));
  EXPECT_EQ(json["root"]["content"]["boundingVolume"]["sphere"][3], 9.0);
  EXPECT_EQ(json["root"]["boundingVolume"]["sphere"][3], 100);
}

TEST(FolderSourceTest, RefusesLinksThatLeadOut) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(testing::TempDir()) / "folder_source_test";
  fs::remove_all(folder);
  ASSERT_TRUE(WriteFileAtomically((folder / "scene/in.json").string(), "in").ok());
  ASSERT_TRUE(WriteFileAtomically((folder / "secret.json").string(), "out").ok());
  fs::create_symlink("../secret.json", folder / "scene/link.json");
  fs::create_symlink("in.json", folder / "scene/inner.json");
  const FolderSource source((folder / "scene").string());
  EXPECT_EQ(source.Read("in.json").value(), "in");
  EXPECT_EQ(source.Read("inner.json").value(), "in");
  EXPECT_EQ(source.Read("link.json").status().code(), absl::StatusCode::kOutOfRange);
  EXPECT_EQ(source.Read("gone.json").status().code(), absl::StatusCode::kNotFound);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace tilemend
