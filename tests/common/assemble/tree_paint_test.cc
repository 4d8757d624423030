#include "common/assemble/tree_paint.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "common/assemble/tree_levels.h"
#include "tests/support/osgb_scene.h"
#include "tests/support/pond_fan.h"

namespace tilemend {
namespace {

using testing::HasSubstr;

// Of two materials, which one image covers.
FilePatch FanOf(const TileTree& tile) {
  FilePatch patch = FanInPond(static_cast<int32_t>(LevelOf(tile, 2).mesh.points.size()));
  patch.materials.push_back({20, "ground"});
  return patch;
}

// An image that tells the level, and places that tell the triangle.
absl::StatusOr<FacePaint> PaintByNumber(const TreeFaces& faces) {
  FacePaint paint{absl::StrCat("\xff\xd8\xff", faces.above_finest, " levels above"), {}};
  for (size_t t = 0; t < faces.triangles.size(); ++t) {
    const auto u = static_cast<float>(t);
    paint.corners.push_back({{{u, 0}, {u, 0.5F}, {u, 1}}});
  }
  return paint;
}

std::string Painted(const std::string& pack, const PaintFaces& paint) {
  const auto tile = ReadTileTree(pack, "a/Tile.osgb");
  const auto patched = PatchTreeLevels(pack, FanOf(*tile), {}, "a/Tile.osgb", paint, "fill.jpg");
  EXPECT_TRUE(patched.ok()) << patched.status();
  return patched.ok() ? patched->pack : "";
}

TEST(TreePaintTest, AllLevelsGetTheirImages) {
  const std::string pack = OsgbScene().Pack(0), painted = Painted(pack, PaintByNumber);
  const auto before = ReadTileTree(pack, "a/Tile.osgb"), after = ReadTileTree(painted, "a/Tile.osgb");
  ASSERT_TRUE(after.ok()) << after.status();
  std::vector<int> seen(3);
  for (const TreePiece& piece : after->pieces) {
    const auto f = static_cast<size_t>(piece.file);
    const TreeFile& file = after->files[f];
    for (const TreeGeometry& geometry : file.geometries) {
      if (geometry.part != piece.part || geometry.texture < 0) continue;
      const TreeImage& image = file.images[static_cast<size_t>(geometry.texture)];
      if (image.name != "fill.jpg") continue;
      EXPECT_EQ(after->packed[f].bytes.substr(image.offset, image.size),
                absl::StrCat("\xff\xd8\xff", 2 - piece.level, " levels above"));
      EXPECT_EQ(geometry.vertex_count, 3 * geometry.triangle_count) << "a point for each of its places";
      ++seen[static_cast<size_t>(piece.level)];
    }
  }
  EXPECT_THAT(seen, testing::Each(testing::Ge(1)));
}

TEST(TreePaintTest, WhatWasWrittenIsMadeOnceMore) {
  const std::string pack = OsgbScene().Pack(0), painted = Painted(pack, PaintByNumber);
  const auto paint = PaintOfWritten(pack, painted, "a/Tile.osgb");
  ASSERT_TRUE(paint.ok()) << paint.status();
  EXPECT_TRUE(Painted(pack, *paint) == painted);
}

TEST(TreePaintTest, ATileWithoutImagesHasNoPaint) {
  const std::string pack = OsgbScene().Pack(0);
  for (const std::string& written : {pack, Painted(pack, {})}) {
    const auto paint = PaintOfWritten(pack, written, "a/Tile.osgb");
    ASSERT_TRUE(paint.ok()) << paint.status();
    EXPECT_FALSE(*paint);
  }
}

TEST(TreePaintTest, FacesThatWereNotWrittenAreAnError) {
  const std::string pack = OsgbScene().Pack(0);
  const auto paint = PaintOfWritten(pack, Painted(pack, PaintByNumber), "a/Tile.osgb");
  ASSERT_TRUE(paint.ok() && *paint);
  TreeFaces other;
  other.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  other.triangles = {{0, 1, 2}};
  EXPECT_THAT((*paint)(other).status().message(), HasSubstr("no painted faces"));
  EXPECT_FALSE(PaintedPatch(other, {"image", {}}, "name").ok());
  EXPECT_FALSE(PaintOfWritten(pack, "no pack", "a/Tile.osgb").ok());
}

}  // namespace
}  // namespace tilemend
