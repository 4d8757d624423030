#include "worker/delivery/delivery_tile.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/osgb_scene.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/tileset_scene.h"

namespace tilemend {
namespace {

using testing::HasSubstr;

TileTree OsgbTree() {
  static const std::string packed = OsgbScene().Pack(0);  // the tree has views of it
  return *ReadTileTree(packed, "a.osgb");
}

TEST(DeliveryOfTreeTest, PiecesTakeThePlaceOfTheirParents) {
  const DeliveryTile tile = DeliveryOfTree(OsgbTree(), DeliveryLevels::kAll);
  ASSERT_EQ(tile.pieces.size(), 9u);
  EXPECT_EQ(tile.pieces[0].parent, -1);
  for (size_t p = 1; p < 5; ++p) {
    EXPECT_EQ(tile.pieces[p].parent, 0);
    EXPECT_EQ(tile.pieces[p + 4].parent, static_cast<int32_t>(p));
    EXPECT_EQ(tile.pieces[p + 4].geometric_error, 0);
    EXPECT_GT(tile.pieces[p].geometric_error, 0);
  }
  EXPECT_EQ(tile.images.size(), 9u);
  EXPECT_EQ(tile.images[0], "\xff\xd8\xff no image");
  EXPECT_TRUE(tile.warnings.empty());
}

TEST(DeliveryOfTreeTest, ImagesOfFillsAreTheLastAndThoseWithoutATriangleAreThere) {
  TileTree tree = OsgbTree();
  std::vector<int32_t> new_geometries(tree.pieces.size(), 0);
  const auto& first = tree.pieces[0];
  new_geometries[0] = 1;  // its only one
  for (TreeGeometry& geometry : tree.files[static_cast<size_t>(tree.pieces[1].file)].geometries) {
    if (geometry.part == tree.pieces[1].part) geometry.triangle_count = 0;
  }
  const DeliveryTile tile = DeliveryOfTree(tree, DeliveryLevels::kAll, new_geometries);
  EXPECT_EQ(first.parent, -1);
  EXPECT_EQ(tile.images.size(), 9U);
  EXPECT_EQ(tile.own_images, 8U);
  EXPECT_TRUE(tile.pieces[0].surfaces.at(0).is_filled);
  EXPECT_EQ(tile.pieces[0].surfaces[0].image, 8);
}

TEST(DeliveryOfTreeTest, TheFinestAloneIsTheFinestLevel) {
  const TileTree tree = OsgbTree();
  const DeliveryTile tile = DeliveryOfTree(tree, DeliveryLevels::kFinest);
  ASSERT_EQ(tile.pieces.size(), 4u);
  size_t triangles = 0;
  for (const DeliveryPiece& piece : tile.pieces) triangles += piece.surfaces.at(0).mesh.triangles.size();
  EXPECT_EQ(triangles, LevelOf(tree, 2).mesh.triangles.size());
}

TEST(DeliveryOfTreeTest, FillsHaveTheirColourAndVerticesTheirBits) {
  for (const bool osgb : {true, false}) {
    const std::string pack = osgb ? OsgbScene().Pack(0) : TilesetScene().Pack(), name = osgb ? "a.osgb" : "a.json";
    const TileTree before = *ReadTileTree(pack, name);
    std::vector<TreeEdit> edits(before.packed.size());
    const auto f = static_cast<size_t>(before.pieces.back().file);
    const std::vector<Point3> points = {{1, 2, 3}, {2, 2, 3}, {1, 3, 3}};
    edits[f].patches.push_back({points, {{0, 1, 2}}, {98, 93, 72}, before.pieces.back().part});
    const std::string changed = *ChangeTileTree(before, edits, name);
    const DeliveryTile tile = DeliveryOfTree(*ReadTileTree(changed, name), DeliveryLevels::kFinest);
    const DeliverySurface& fill = tile.pieces.back().surfaces.back();
    EXPECT_EQ(fill.image, -1);
    EXPECT_EQ(fill.colour, (Rgb{98, 93, 72})) << name;
    EXPECT_FALSE(fill.is_filled) << "nobody says so";
    std::vector<int32_t> new_geometries(before.pieces.size());
    new_geometries.back() = 1;
    const DeliveryTile marked = DeliveryOfTree(*ReadTileTree(changed, name), DeliveryLevels::kFinest, new_geometries);
    for (const DeliveryPiece& piece : marked.pieces) {
      for (const DeliverySurface& surface : piece.surfaces) {
        EXPECT_EQ(surface.is_filled, surface.colour == fill.colour && surface.image < 0) << name;
      }
    }
    if (osgb) {
      EXPECT_EQ(fill.mesh.points, points);
    }
  }
}

TEST(DeliveryOfTreeTest, AnImageOfAnUnknownFormatIsAWarning) {
  const std::string pack = OsgbScene(OsgbScene::Pond::kHole, 80, "no image").Pack(0);
  const DeliveryTile tile = DeliveryOfTree(*ReadTileTree(pack, "a.osgb"), DeliveryLevels::kFinest);
  EXPECT_TRUE(tile.images.empty());
  ASSERT_EQ(tile.warnings.size(), 4u);
  EXPECT_THAT(tile.warnings[0], HasSubstr("no image of a known format"));
}

TEST(DeliveryOfObjTest, ImagesAndColoursOfTheMaterialsAreTaken) {
  const TemporaryFolder folder;
  folder.Write("t/a.mtl", "newmtl roof\nmap_Kd roof.jpg\nnewmtl red\nKd 1 0 0\n");
  folder.Write("t/roof.jpg", "\xff\xd8\xff roof");
  const std::string obj =
      "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n"
      "usemtl roof\nf 1/1 2/2 3/3\nusemtl red\nf 2 4 3\nusemtl fill\nf 2/1 4/2 3/3\n";
  const std::vector<FillMaterial> filled = {{"fill", {255, 255, 255}, "a_tilemend.jpg"}};
  const auto tile = DeliveryOfObj(obj, {folder.path(), "t/a.obj", filled, "\xff\xd8\xff fill"});
  ASSERT_TRUE(tile.ok()) << tile.status();
  ASSERT_EQ(tile->pieces.size(), 1u);
  ASSERT_EQ(tile->pieces[0].surfaces.size(), 3u);
  EXPECT_THAT(tile->images, testing::ElementsAre("\xff\xd8\xff roof", "\xff\xd8\xff fill"));
  EXPECT_EQ(tile->own_images, 1U);
  EXPECT_EQ(tile->pieces[0].surfaces[0].image, -1);
  EXPECT_EQ(tile->pieces[0].surfaces[0].colour, (Rgb{255, 0, 0}));
  EXPECT_EQ(tile->pieces[0].surfaces[1].uv.size(), 3u);
}

TEST(DeliveryOfObjTest, FacesOfTheGroupAreFilled) {
  const TemporaryFolder folder;
  const std::string obj =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nusemtl red\nf 1 2 3\ng tilemend_filled\nf 2 4 3\nusemtl blue\nf 1 2 4\n"
      "g other\nf 1 4 3\n";
  const std::vector<FillMaterial> materials = {{"red", {255, 0, 0}}, {"blue", {0, 0, 255}}};
  const auto tile = DeliveryOfObj(obj, {folder.path(), "a.obj", materials, ""});
  ASSERT_TRUE(tile.ok()) << tile.status();
  std::map<std::pair<int, bool>, size_t> triangles;  // by blue, and whether they are filled
  for (const DeliverySurface& surface : tile->pieces.at(0).surfaces) {
    triangles[{surface.colour.b, surface.is_filled}] += surface.mesh.triangles.size();
  }
  EXPECT_EQ(triangles, (std::map<std::pair<int, bool>, size_t>{
                           {{0, false}, 1}, {{0, true}, 1}, {{255, false}, 1}, {{255, true}, 1}}));
}

TEST(DeliveryOfObjTest, FlatFacesAreKeptAndWhatIsNoTriangleIsCounted) {
  const TemporaryFolder folder;
  folder.Write("a.mtl", "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n");
  const std::string obj =
      "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 0\nusemtl red\nf 1 1 2\nf 1 4 2\nf 1 2\nusemtl blue\nf 1 2 3\n"
      "f 1 2 3 3\nf 2\nl 1 2 3\n";
  const auto tile = DeliveryOfObj(obj, {folder.path(), "a.obj", {}, ""});
  ASSERT_TRUE(tile.ok()) << tile.status();
  std::map<int, std::vector<Triangle>> triangles;  // by blue
  for (const DeliverySurface& surface : tile->pieces.at(0).surfaces) {
    triangles[surface.colour.b] = surface.mesh.triangles;
  }
  EXPECT_EQ(triangles[0], (std::vector<Triangle>{{0, 0, 1}, {0, 2, 1}}));
  EXPECT_EQ(triangles[255], (std::vector<Triangle>{{0, 1, 2}, {0, 1, 2}}));
  EXPECT_THAT(tile->warnings, testing::ElementsAre("a.obj: faces with fewer than three corners are not written in "
                                                   "another format: 2",
                                                   "a.obj: lines and points are not written in another format: 1"));
}

TEST(DeliveryOfObjTest, VerticesKeepTheirColoursWhereNoMaterialIsInForce) {
  const TemporaryFolder folder;
  const std::string vertices = "v 0 0 0 0 0.2 0\nv 1 0 0 0 0.4 0\nv 0 1 0 0 0.6 0\nv 1 1 0 1 1 1\nf 1 2 3\n";
  const std::vector<FillMaterial> materials = {{"fill", {9, 9, 9}}};
  auto tile =
      DeliveryOfObj(vertices + "g tilemend_filled\nusemtl fill\nf 2 4 3\n", {folder.path(), "a.obj", materials, ""});
  ASSERT_TRUE(tile.ok()) << tile.status();
  ASSERT_EQ(tile->pieces.at(0).surfaces.size(), 2u);
  const DeliverySurface& own = tile->pieces[0].surfaces[0];
  EXPECT_THAT(own.colours, testing::ElementsAre(Rgb{0, 51, 0}, Rgb{0, 102, 0}, Rgb{0, 153, 0}));
  EXPECT_EQ(own.colour, (Rgb{0, 102, 0}));
  EXPECT_TRUE(tile->pieces[0].surfaces[1].colours.empty());
  EXPECT_EQ(tile->pieces[0].surfaces[1].colour, (Rgb{9, 9, 9}));
  EXPECT_THAT(tile->warnings, testing::IsEmpty());
  DropVertexColours(*tile);
  EXPECT_TRUE(own.colours.empty());
  EXPECT_THAT(tile->warnings, testing::ElementsAre(HasSubstr("colours of vertices are not written in this format")));
  DropVertexColours(*tile);
  EXPECT_EQ(tile->warnings.size(), 1u);
  folder.Write("a.mtl", "newmtl red\nKd 1 0 0\n");
  const auto under =
      DeliveryOfObj("mtllib a.mtl\n" + vertices + "usemtl red\nf 2 4 3\n", {folder.path(), "a.obj", {}, ""});
  ASSERT_TRUE(under.ok()) << under.status();
  EXPECT_THAT(under->warnings, testing::ElementsAre(HasSubstr("where faces have a material")));
}

// So that images have the same numbers where clearing leaves no face of a material.
TEST(DeliveryOfObjTest, AnImageWithoutAFaceIsTaken) {
  const TemporaryFolder folder;
  folder.Write("a.mtl", "newmtl one\nmap_Kd 1.jpg\nnewmtl two\nmap_Kd 2.jpg\nnewmtl unnamed\nmap_Kd 3.jpg\n");
  for (const std::string n : {"1", "2", "3"}) folder.Write(n + ".jpg", "\xff\xd8\xff " + n);
  const auto tile =
      DeliveryOfObj("mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl one\nusemtl two\nf 1/1 2/1 3/1\n",
                    {folder.path(), "a.obj", {}, ""});
  ASSERT_TRUE(tile.ok()) << tile.status();
  EXPECT_THAT(tile->images, testing::ElementsAre("\xff\xd8\xff 1", "\xff\xd8\xff 2"));
  EXPECT_EQ(tile->pieces[0].surfaces.at(0).image, 1);
}

TEST(DeliveryOfObjTest, AMissingOrUnknownImageIsAColour) {
  const TemporaryFolder folder;
  folder.Write("a.mtl", "newmtl roof\nmap_Kd roof.tif\n");
  folder.Write("roof.tif", "II*");
  const auto tile = DeliveryOfObj("mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl roof\nf 1/1 2/1 3/1\n",
                                  {folder.path(), "a.obj", {}, ""});
  ASSERT_TRUE(tile.ok()) << tile.status();
  EXPECT_EQ(tile->pieces[0].surfaces.at(0).image, -1);
  ASSERT_EQ(tile->warnings.size(), 1u);
  EXPECT_THAT(tile->warnings[0], HasSubstr("roof.tif"));
}

TEST(DeliveryOfColoursTest, EachRunIsASurface) {
  const TriMesh mesh{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  const std::vector<ColourRun> runs = {{0, {1, 2, 3}}, {1, {4, 5, 6}}};
  const DeliveryTile tile = DeliveryOfColours(mesh, runs);
  ASSERT_EQ(tile.pieces.at(0).surfaces.size(), 2u);
  EXPECT_EQ(tile.pieces[0].surfaces[1].colour, (Rgb{4, 5, 6}));
  EXPECT_EQ(tile.pieces[0].surfaces[1].mesh.points.size(), 3u);
  EXPECT_TRUE(tile.pieces[0].surfaces[1].is_filled);
}

TEST(ImageEndingTest, IsToldByTheFirstBytes) {
  EXPECT_EQ(ImageEnding("\xff\xd8\xff\xe0"), "jpg");
  EXPECT_EQ(ImageEnding("\x89PNG\r\n"), "png");
  EXPECT_EQ(ImageEnding(std::string_view("RIFF\1\2\3\4WEBPVP8", 15)), "webp");
  EXPECT_EQ(ImageEnding("RIFF"), "");
  EXPECT_EQ(ImageEnding(""), "");
}

TEST(KeepJpegAndPngTest, LeavesOutWebPWithAWarning) {
  DeliveryTile tile;
  tile.images = {"\xff\xd8\xff a photograph", std::string("RIFF\1\2\3\4WEBPVP8", 15)};
  DeliveryPiece& piece = tile.pieces.emplace_back();
  for (const int32_t image : {0, 1, -1}) {
    DeliverySurface& surface = piece.surfaces.emplace_back();
    surface.image = image;
    if (image >= 0) surface.uv.resize(3);
  }
  KeepJpegAndPng(tile);
  EXPECT_EQ(piece.surfaces[0].image, 0);
  EXPECT_EQ(piece.surfaces[0].uv.size(), 3U);
  EXPECT_EQ(piece.surfaces[1].image, -1);
  EXPECT_TRUE(piece.surfaces[1].uv.empty());
  ASSERT_EQ(tile.warnings.size(), 1U);
  EXPECT_NE(tile.warnings[0].find("webp"), std::string::npos);
}

}  // namespace
}  // namespace tilemend
