#include "common/rpc/tile_patch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/rpc/look_payloads.h"
#include "common/rpc/smoothed_payloads.h"
#include "common/rpc/stage_payloads.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

constexpr char kTriangle[] = "v 0 0 0\nv 4 0 0\nv 0 4 0\nf 1 2 3\n";

RimVertex Own(int32_t index, const Point3& p) {
  RimVertex v;
  v.tile = {2, 1};
  v.index = index;
  v.position = p;
  return v;
}

// A hole below the x axis of a tile that is one triangle; its patch has one new vertex.
v1::AssembleInput Input() {
  const std::vector<RimVertex> vertices = {Own(0, {0, 0, 0}), Own(1, {4, 0, 0})};
  HolePatch patch;
  patch.hole = 5;
  patch.way = FillWay::kGround;
  patch.new_points = {{2, -1, 0.5}};
  patch.triangles = {{1, 0, -1}};
  v1::AssembleInput input;
  input.mutable_tile()->set_col(2);
  input.mutable_tile()->set_row(1);
  input.mutable_tile()->set_root("/scene");
  input.mutable_tile()->set_path("a.obj");
  input.set_tile_vertices(3);
  input.set_lattice_step(0.25);
  *input.mutable_vertices() = ToProto(vertices);
  *input.mutable_patches() = ToProto(std::vector{patch}, vertices, 0.25);
  SetColours({{{5, {5, {1, 2, 3}, true}}}, false}, input);
  return input;
}

TEST(TilePatchTest, AppendsThePatchesToTheTile) {
  const auto added = TilePatchOf(Input());
  ASSERT_TRUE(added.ok()) << added.status();
  EXPECT_THAT(added->materials, ElementsAre(FillMaterial{"tilemend_fill_5_010203", {1, 2, 3}}));
  const auto bytes = PatchedTile(Input(), *added, kTriangle);
  ASSERT_TRUE(bytes.ok()) << bytes.status();
  EXPECT_EQ(bytes->bytes,
            std::string(kTriangle) + "v 2 -1 0.5\ng tilemend_filled\nusemtl tilemend_fill_5_010203\nf 2 1 4\n");
}

TEST(TilePatchTest, NamesALibraryThatIsMadeForIt) {
  v1::AssembleInput input = Input();
  input.set_new_library(true);
  input.set_library("tiles/fill.mtl");
  EXPECT_EQ(TilePatchOf(input)->patch.library, "fill.mtl");
}

TEST(TilePatchTest, MovesPointsOfSmoothedSeams) {
  v1::AssembleInput input = Input();
  *input.add_smoothed() = ToProto(std::vector<SmoothedPoint>{{0, 0.75}});
  EXPECT_THAT(TilePatchOf(input)->patch.new_points, ElementsAre(Point3(2, -1, 0.75)));
}

TEST(TilePatchTest, IsAFileOfItsOwnWithoutATile) {
  v1::AssembleInput input = Input();
  input.mutable_tile()->clear_path();
  const auto added = TilePatchOf(input);
  ASSERT_TRUE(added.ok()) << added.status();
  EXPECT_THAT(added->materials, IsEmpty());
  EXPECT_THAT(PatchedTile(input, *added, "")->bytes, StartsWith("ply\n"));
  EXPECT_THAT(PatchedTile(input, *added, "")->bytes, HasSubstr("element vertex 3\n"));
}

TEST(TilePatchTest, AddsNothingWithoutPatches) {
  v1::AssembleInput input = Input();
  input.clear_patches();
  EXPECT_THAT(TilePatchOf(input)->patch.triangles, IsEmpty());
  EXPECT_THAT(TilePatchOf(input)->materials, IsEmpty());
}

TEST(TilePatchTest, RefusesWhatDoesNotFitTogether) {
  v1::AssembleInput no_colour = Input(), small = Input(), far = Input();
  no_colour.clear_colours();
  small.set_tile_vertices(1);
  *far.add_smoothed() = ToProto(std::vector<SmoothedPoint>{{7, 0.75}});
  for (const v1::AssembleInput& input : {no_colour, small, far}) {
    EXPECT_TRUE(absl::IsInvalidArgument(TilePatchOf(input).status()));
  }
}

TEST(TilePatchTest, TextureIsTakenFromAWrittenTile) {
  v1::AssembleInput input = Input();
  input.set_texture("x/a_tilemend.jpg");
  auto added = TilePatchOf(input), again = TilePatchOf(input);
  ASSERT_TRUE(added.ok()) << added.status();
  SetTexture(input, {{0.25F, 0.123456F}, {1.0F, 0.0F}}, {{0, 1, 0}}, *added);
  EXPECT_THAT(added->materials,
              ElementsAre(FillMaterial{"tilemend_fill_a_tilemend", {255, 255, 255}, "a_tilemend.jpg"}));
  const auto bytes = PatchedTile(input, *added, kTriangle);
  ASSERT_TRUE(bytes.ok()) << bytes.status();
  ASSERT_TRUE(TakeTexture(input, kTriangle, bytes->bytes, *again).ok());
  EXPECT_EQ(PatchedTile(input, *again, kTriangle)->bytes, bytes->bytes);
  EXPECT_FALSE(TakeTexture(input, bytes->bytes, kTriangle, *again).ok());
}

TEST(TilePatchTest, WithoutColoursThereIsNoMaterial) {
  v1::AssembleInput input = Input();
  input.set_without_colours(true);
  const auto added = TilePatchOf(input);
  ASSERT_TRUE(added.ok()) << added.status();
  EXPECT_THAT(added->materials, IsEmpty());
  EXPECT_EQ(added->runs[0].colour, (Rgb{1, 2, 3}));
}

}  // namespace
}  // namespace tilemend
