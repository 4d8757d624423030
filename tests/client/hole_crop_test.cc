#include "client/hole_crop.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <map>
#include <vector>

#include "client/crop_bytes.h"
#include "client/picture_atlas.h"
#include "tests/support/image_builders.h"
#include "tests/support/mesh_builders.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using ::testing::Ge;
using ::testing::SizeIs;

// A sheet of `side` squares whose middle square was filled.
TilePair Filled(int32_t side) {
  const int32_t middle = side / 2;
  TilePair pair;
  pair.before.faces.mesh =
      SquaresMesh(0, side, 0, side, [&](int32_t i, int32_t j) { return i != middle || j != middle; });
  pair.before.faces.looks.assign(pair.before.faces.mesh.triangles.size(), 0);
  pair.before.material_of.assign(pair.before.faces.mesh.triangles.size(), -1);
  pair.after = pair.before;
  TriMesh& mesh = pair.after.faces.mesh;
  const auto n = static_cast<int32_t>(mesh.points.size());
  const double lo = middle, hi = middle + 1;
  mesh.points.insert(mesh.points.end(), {{lo, lo, 0}, {hi, lo, 0}, {hi, hi, 0}, {lo, hi, 0}});
  mesh.triangles.push_back({n, n + 1, n + 2});
  mesh.triangles.push_back({n, n + 2, n + 3});
  pair.after.faces.looks.resize(mesh.triangles.size());
  pair.after.material_of.resize(mesh.triangles.size(), -1);
  pair.change = CompareTiles(pair.before.faces, pair.after.faces);
  return pair;
}

TEST(HoleCropTest, FindsTheFillAtItsCentre) {
  const TilePair pair = Filled(21);
  const auto pieces = AddedPieces(pair.after.faces.mesh, pair.change.added);
  ASSERT_THAT(pieces, SizeIs(1));
  EXPECT_EQ(PieceAt(pieces, {10.5, 10.5}, 1).min(), Point3(10, 10, 0));
  EXPECT_TRUE(PieceAt(pieces, {3, 3}, 1).isEmpty());
}

// Cutting folds off can leave a scrap of the fill near the centre.
TEST(HoleCropTest, FindsABentFillBesideAScrap) {
  constexpr int32_t kSide = 18, kWidth = 2;  // two arms along the borders: 68 m2 in a box of 324 m2
  TriMesh mesh = SquaresMesh(0, kSide, 0, kSide, [](int32_t i, int32_t j) { return i < kWidth || j < kWidth; });
  const auto n = static_cast<int32_t>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), {{7, 7, 12}, {9, 7, 12}, {8, 9, 12}});
  mesh.triangles.push_back({n, n + 1, n + 2});
  const auto pieces = AddedPieces(mesh, std::vector<bool>(mesh.triangles.size(), true));
  ASSERT_THAT(pieces, SizeIs(2));
  EXPECT_EQ(PieceAt(pieces, {8, 8}, 68).max(), Point3(kSide, kSide, 0));
  EXPECT_EQ(PieceAt(pieces, {8, 8}, 2).max(), Point3(9, 9, 12));
}

// A fill that is exactly a cleared triangle is none of the added ones.
TEST(HoleCropTest, TakesNoOtherFillForOneThatHasNoPiece) {
  const TriMesh mesh = SquaresMesh(0, 20, 0, 20, [](int32_t, int32_t) { return true; });
  const auto pieces = AddedPieces(mesh, std::vector<bool>(mesh.triangles.size(), true));
  ASSERT_THAT(pieces, SizeIs(1));
  EXPECT_FALSE(PieceAt(pieces, {8, 8}, 390).isEmpty());
  EXPECT_TRUE(PieceAt(pieces, {8, 8}, 12).isEmpty());
  EXPECT_TRUE(PieceAt(pieces, {8, 8}, 900).isEmpty());
}

// A fill in a wall has no area from above.
TEST(HoleCropTest, FindsAFillInAWallByItsOwnArea) {
  const TriMesh mesh{{{0, 0, 0}, {4, 0, 0}, {4, 0, 4}, {0, 0, 1}, {1, 0, 5}, {2, 0, 5}, {1, 0, 6}},
                     {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}}};
  const auto pieces = AddedPieces(mesh, {true, true, true});
  ASSERT_THAT(pieces, SizeIs(2));
  EXPECT_EQ(PieceAt(pieces, {1.5, 0}, 10).max(), Point3(4, 0, 4));
}

TEST(HoleCropTest, KeepsTheSurroundingsOfTheFill) {
  const TilePair pair = Filled(41);
  const HoleCrop crop = CropAround(pair, AddedPieces(pair.after.faces.mesh, pair.change.added)[0].box);
  EXPECT_LT(std::ssize(crop.faces), std::ssize(pair.after.faces.mesh.triangles) / 4);
  EXPECT_EQ(std::count_if(crop.faces.begin(), crop.faces.end(),
                          [](const HoleCrop::Face& f) { return f.state == FaceState::kAdded; }),
            2);
  EXPECT_EQ(crop.faces_there, std::ssize(crop.faces));
}

TEST(HoleCropTest, ClearedTrianglesAreThereToBeShownBefore) {
  TilePair pair = Filled(9);
  pair.change.missing = {0};
  const HoleCrop crop = CropAround(pair, {Point3(0, 0, 0), Point3(2, 2, 0)});
  EXPECT_EQ(crop.faces.back().state, FaceState::kCleared);
}

TEST(HoleCropTest, APictureHasABoundedNumberOfTriangles) {
  const TilePair pair = Filled(121);
  const HoleCrop crop = CropAround(pair, {Point3(0, 0, 0), Point3(121, 121, 0)});
  EXPECT_GT(crop.faces_there, kMostCropFaces);
  EXPECT_LE(std::ssize(crop.faces), kMostCropFaces);
  EXPECT_THAT(std::ssize(crop.faces), Ge(kMostCropFaces / 4));
}

// Faces that share a vertex share it in the picture, and a cleared face keeps its own mesh's corners.
TEST(HoleCropTest, OnAGridNeighboursStillShareVertices) {
  TilePair pair = Filled(121);
  TriMesh& before = pair.before.faces.mesh;
  const auto n = static_cast<int32_t>(before.points.size());  // where `after` has the fill
  const SpaceTriangle roof = {Point3(10, 10, 20), Point3(30, 10, 20), Point3(10, 30, 20)};
  before.points.insert(before.points.end(), roof.begin(), roof.end());
  before.triangles.push_back({n, n + 1, n + 2});
  const auto cleared = static_cast<int32_t>(before.triangles.size()) - 1;
  pair.change.missing = {cleared};
  const HoleCrop crop = CropAround(pair, {Point3(0, 0, 0), Point3(121, 121, 0)});
  std::map<std::array<double, 3>, int> faces_at;
  std::vector<HoleCrop::Face> cleared_faces;
  double area = 0;
  for (const HoleCrop::Face& face : crop.faces) {
    if (face.state == FaceState::kCleared) {
      cleared_faces.push_back(face);
      continue;
    }
    for (const Point3& p : face.corners) ++faces_at[{p.x(), p.y(), p.z()}];
    area += (face.corners[1] - face.corners[0]).cross(face.corners[2] - face.corners[0]).z() / 2;
  }
  ASSERT_THAT(cleared_faces, SizeIs(1));
  EXPECT_EQ(cleared_faces[0].triangle, cleared);
  EXPECT_EQ(cleared_faces[0].corners, roof) << "each is alone in its square";
  EXPECT_LT(std::ssize(faces_at), kMostCropFaces);
  EXPECT_NEAR(area, 121 * 121, 0.05 * 121 * 121) << "no gaps; vertices at the border move inwards";
}

TEST(HoleCropTest, ATriangleAcrossTheBoxIsInThePicture) {
  TilePair pair;
  pair.after.faces.mesh = {{{-90, -90, 0}, {90, -90, 0}, {0, 90, 0}, {-90, 50, 0}, {-80, 50, 0}, {-80, 60, 0}},
                           {{0, 1, 2}, {3, 4, 5}}};
  pair.change.added = {false, false};
  const HoleCrop crop = CropAround(pair, {Point3(-1, -1, 0), Point3(1, 1, 0)});
  ASSERT_THAT(crop.faces, SizeIs(1));
  EXPECT_EQ(crop.faces[0].triangle, 0);
}

uint32_t Number(const std::string& bytes, size_t at) {
  uint32_t value = 0;
  std::memcpy(&value, bytes.data() + at, sizeof(value));
  return value;
}

TEST(CropBytesTest, HasTheSizesThatItsHeaderSays) {
  const TilePair pair = Filled(9);
  const HoleCrop crop = CropAround(pair, {Point3(4, 4, 0), Point3(5, 5, 0)});
  const std::string bytes = CropBytes(crop, pair, "", "");
  EXPECT_EQ(bytes.substr(0, 4), "TMC1");
  const size_t vertices = Number(bytes, 4), triangles = Number(bytes, 8), jpeg = Number(bytes, 12);
  EXPECT_EQ(triangles, crop.faces.size());
  EXPECT_EQ(jpeg, 0U);
  const size_t corners = (64 + 14 * vertices + triangles + 3) / 4 * 4;
  ASSERT_EQ(bytes.size(), corners + 12 * triangles);
  for (size_t at = corners; at < bytes.size(); at += 4) ASSERT_LT(Number(bytes, at), vertices);
}

TEST(PictureAtlasTest, PartsKeepTheirColours) {
  const TemporaryFolder folder;
  // Left half red, right half blue.
  folder.Write("two.png", PngImage(64, 64, [](int32_t x, int32_t) {
                 return x < 32 ? Rgb{200, 0, 0} : Rgb{0, 0, 200};
               }));
  const std::vector<ImagePart> parts = {
      {"two.png", {0.0F, 0.0F}, {0.4F, 1.0F}}, {"two.png", {0.6F, 0.0F}, {1.0F, 1.0F}}, {"none.png", {0, 0}, {1, 1}}};
  const PictureAtlas atlas = MakePictureAtlas(folder.path(), parts);
  const auto image = DecodeImage(atlas.jpeg, "atlas");
  ASSERT_TRUE(image.ok()) << image.status();
  const auto texel = [&](std::array<double, 2> place) { return TexelAt(*image, place[0], 1 - place[1]); };
  EXPECT_NEAR(texel(atlas.PlaceOf(parts[0], 0, {0.2F, 0.5F})).r, 200, 12);
  EXPECT_NEAR(texel(atlas.PlaceOf(parts[1], 1, {0.8F, 0.5F})).b, 200, 12);
  EXPECT_NEAR(texel(atlas.white).g, 255, 6);
  EXPECT_EQ(atlas.squares[2].width, 0);
}

TEST(PictureAtlasTest, WithoutAnImageThereIsNoJpeg) {
  EXPECT_EQ(MakePictureAtlas("/", {}).jpeg, "");
  EXPECT_EQ(MakePictureAtlas("/", {{"none.png", {0, 0}, {1, 1}}}).jpeg, "");
}

}  // namespace
}  // namespace tilemend
