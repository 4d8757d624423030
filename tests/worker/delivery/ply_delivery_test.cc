#include "worker/delivery/ply_delivery.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/codec/mesh_file.h"
#include "common/codec/ply_colours.h"
#include "common/image/image.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

// Two triangles that share an edge, with an image and in one colour.
DeliveryTile TwoSurfaces(double x) {
  DeliveryTile tile;
  tile.images = {"\xff\xd8\xff a photograph"};
  DeliveryPiece& piece = tile.pieces.emplace_back();
  DeliverySurface photographed{{{{x, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}, {}, 0, {}};
  photographed.uv = {{0.25F, 0}, {1, 0}, {0, 1}};
  const DeliverySurface plain{{{{0, 1, 0}, {1, 0, 0}, {1, 1, 0}}, {{0, 1, 2}}}, {}, -1, {10, 200, 30}};
  piece.surfaces = {photographed, plain};
  return tile;
}

MeshFile ReadPly(const DeliveryFile& file) {
  const auto mesh = ParseMesh(MeshFormat::kPly, file.bytes, file.name);
  EXPECT_TRUE(mesh.ok()) << mesh.status();
  return *mesh;
}

TEST(PlyDeliveryTest, FacesHaveImagesAndShareVertices) {
  const auto files = PlyFilesOf(TwoSurfaces(0.5), "a");
  ASSERT_TRUE(files.ok()) << files.status();
  ASSERT_EQ(files->size(), 3U);
  const MeshFile read = ReadPly(files->at(0));
  EXPECT_EQ(read.mesh.points.size(), 4U);
  EXPECT_EQ(read.mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {2, 1, 3}}));
  EXPECT_THAT(PlyTextureNames(files->at(0).bytes), ElementsAre("a_0.jpg", "a_1.jpg"));
  EXPECT_EQ(files->at(1).bytes, "\xff\xd8\xff a photograph");
  const auto plain = DecodeImage(files->at(2).bytes, "plain");
  ASSERT_TRUE(plain.ok()) << plain.status();
  const Rgb colour = TexelAt(*plain, 0.5, 0.5);
  EXPECT_NEAR(colour.r, 10, 2);
  EXPECT_NEAR(colour.g, 200, 2);
  EXPECT_NEAR(colour.b, 30, 2);
  // The first face: three indices, six places, the image.
  const std::string& bytes = files->at(0).bytes;
  constexpr size_t kFace = 1 + 3 * 4 + 1 + 6 * 4 + 4;
  const std::string face = bytes.substr(bytes.size() - 2 * kFace, kFace);
  EXPECT_EQ(face.substr(13, 5), std::string("\6\0\0\x80\x3e", 5)) << "0.25";
  EXPECT_EQ(face.substr(kFace - 4), std::string(4, '\0'));
}

// So that a tile without its fills has the same numbers.
TEST(PlyDeliveryTest, ImagesOfFilledSurfaceAreTheLast) {
  DeliveryTile tile = TwoSurfaces(0.5);
  tile.images.insert(tile.images.begin(), "\x89PNG of the fill");
  std::vector<DeliverySurface>& surfaces = tile.pieces[0].surfaces;
  surfaces[0].image = 1;
  surfaces.insert(surfaces.begin(), surfaces[0]);
  surfaces[0].image = 0;
  surfaces[0].is_filled = true;
  const auto files = PlyFilesOf(tile, "a");
  ASSERT_TRUE(files.ok()) << files.status();
  EXPECT_THAT(PlyTextureNames(files->at(0).bytes), ElementsAre("a_0.jpg", "a_1.jpg", "a_2.png"));
}

TEST(PlyDeliveryTest, ColumnsThatFillsNeedAreThereWithoutThem) {
  DeliveryTile tile = TwoSurfaces(0.5);
  tile.images.clear();
  tile.pieces[0].surfaces.erase(tile.pieces[0].surfaces.begin());
  EXPECT_FALSE(HasImages(tile, {}));
  const auto files = PlyFilesOf(tile, "a", {.images = true, .float64 = true});
  ASSERT_TRUE(files.ok()) << files.status();
  EXPECT_THAT(PlyTextureNames(files->at(0).bytes), ElementsAre("a_0.jpg"));
  EXPECT_THAT(files->at(0).bytes, HasSubstr("property double x\n"));
  EXPECT_EQ(ReadPly(files->at(0)).mesh.points.size(), 3U);
}

// As the originals have them: two vertices at one position, and one vertex twice.
TEST(PlyDeliveryTest, FlatTrianglesAreWritten) {
  DeliveryTile tile;
  DeliveryPiece& piece = tile.pieces.emplace_back();
  piece.surfaces = {{{{{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {0, 1, 0}}, {{0, 1, 3}, {0, 1, 2}, {0, 2, 2}, {1, 1, 3}}},
                     {},
                     -1,
                     {9, 9, 9}}};
  const auto files = PlyFilesOf(tile, "a");
  ASSERT_TRUE(files.ok()) << files.status();
  EXPECT_THAT(files->at(0).bytes, HasSubstr("element face 4\n"));
  const MeshFile read = ReadPly(files->at(0));
  EXPECT_EQ(read.mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 1, 3}, {0, 4, 5}, {1, 6, 2}}));
  for (const size_t same : {3, 4, 5}) EXPECT_EQ(read.mesh.points[same], Point3(0, 0, 0));
}

// A fan around a vertex, with its rim at `x` on the one side.
DeliveryPiece FanTo(double x) {
  DeliverySurface fan{{{{0, 0, 0}, {x, -1, 0}, {x, 1, 0}, {-x, 0, 0}}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}}}, {}, -1, {}};
  if (x < 0) {
    for (Triangle& t : fan.mesh.triangles) std::swap(t[1], t[2]);
  }
  return {-1, 0, {fan}};
}

TEST(PlyDeliveryTest, PiecesThatOverlapAreNotJoinedWithinTheirSurface) {
  DeliveryTile tile;
  tile.pieces = {FanTo(1), FanTo(2)};
  EXPECT_EQ(ReadPly(PlyFilesOf(tile, "a")->at(0)).mesh.points.size(), 8U) << "(0, 0, 0) is within both";
  tile.pieces = {FanTo(1), FanTo(-1)};
  EXPECT_EQ(ReadPly(PlyFilesOf(tile, "a")->at(0)).mesh.points.size(), 8U);
  tile.pieces[1].surfaces[0].mesh = {{{1, 1, 0}, {1, -1, 0}, {3, 0, 0}}, {{0, 1, 2}}};
  EXPECT_EQ(ReadPly(PlyFilesOf(tile, "a")->at(0)).mesh.points.size(), 5U) << "they share what is on both rims";
}

TEST(PlyDeliveryTest, CoordinatesAreFloat32OnlyIfThatKeepsTheirBits) {
  EXPECT_THAT(PlyFilesOf(TwoSurfaces(0.5), "a")->at(0).bytes, HasSubstr("property float x"));
  const auto wide = PlyFilesOf(TwoSurfaces(0.1), "a");
  EXPECT_THAT(wide->at(0).bytes, HasSubstr("property double x"));
  EXPECT_EQ(ReadPly(wide->at(0)).mesh.points[0].x(), 0.1);
}

TEST(PlyDeliveryTest, WithoutImagesVerticesHaveTheColours) {
  const TriMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {2, 1, 3}}};
  const ColourRun runs[] = {{0, {1, 2, 3}}, {1, {4, 5, 6}}};
  const auto files = PlyFilesOf(DeliveryOfColours(mesh, runs), "a");
  ASSERT_TRUE(files.ok()) << files.status();
  ASSERT_EQ(files->size(), 1U);
  EXPECT_EQ(ReadPly(files->at(0)).mesh.points.size(), 6U);
  const auto colours = PlyVertexColours(files->at(0).bytes, {0, 1, 2, 3}, "a");
  ASSERT_TRUE(colours.ok()) << colours.status();
  EXPECT_EQ((*colours)[0], (Rgb{1, 2, 3}));
  EXPECT_EQ((*colours)[3], (Rgb{4, 5, 6}));
}

TEST(PlyDeliveryTest, VerticesHaveColoursOfTheirOwn) {
  DeliveryTile tile;
  DeliverySurface own{{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}, {}, -1, {9, 9, 9}};
  own.colours = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}};
  DeliverySurface other{{{{0, 1, 0}, {1, 0, 0}, {1, 1, 0}}, {{0, 1, 2}}}, {}, -1, {4, 5, 6}};
  tile.pieces.emplace_back().surfaces = {own, other};
  const auto files = PlyFilesOf(tile, "a");
  ASSERT_TRUE(files.ok()) << files.status();
  const auto colours = PlyVertexColours(files->at(0).bytes, {0, 1, 2, 3, 4}, "a");
  ASSERT_TRUE(colours.ok()) << colours.status();
  EXPECT_THAT(*colours, ElementsAre(Rgb{1, 2, 3}, Rgb{4, 5, 6}, Rgb{7, 8, 9}, Rgb{4, 5, 6}, Rgb{4, 5, 6}));
  EXPECT_EQ(ReadPly(files->at(0)).mesh.points.size(), 5U) << "what has the same colour is shared";
}

TEST(PlyDeliveryTest, FilledFacesAreMarked) {
  for (const bool has_images : {true, false}) {
    DeliveryTile tile = TwoSurfaces(0.5);
    if (!has_images) {
      tile.images.clear();
      tile.pieces[0].surfaces[0].image = -1;
      tile.pieces[0].surfaces[0].uv.clear();
    }
    EXPECT_THAT(PlyFilesOf(tile, "a")->at(0).bytes, Not(HasSubstr("tilemend_filled")));
    tile.pieces[0].surfaces[1].is_filled = true;
    const auto files = PlyFilesOf(tile, "a");
    ASSERT_TRUE(files.ok()) << files.status();
    const std::string& bytes = files->at(0).bytes;
    EXPECT_THAT(bytes, HasSubstr("property uchar tilemend_filled\nend_header\n"));
    EXPECT_EQ(ReadPly(files->at(0)).mesh.triangles.size(), 2U);
    const size_t face = has_images ? 1 + 3 * 4 + 1 + 6 * 4 + 4 + 1 : 1 + 3 * 4 + 1;
    EXPECT_EQ(bytes[bytes.size() - face - 1], '\0');
    EXPECT_EQ(bytes.back(), '\1');
  }
}

}  // namespace
}  // namespace tilemend
