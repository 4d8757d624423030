#include "worker/service/texture_stage.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "common/codec/obj.h"
#include "common/image/image.h"
#include "common/store/digest.h"
#include "common/util/files.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/textured_scene.h"

namespace tilemend {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class TextureStageTest : public testing::Test {
 protected:
  void SetUp() override {
    WriteImageScene(folder_);
    input_.set_texture("T0_tilemend.jpg");
    for (const int column : {0, 1}) {
      v1::TextureCell& cell = *input_.add_around();
      const std::string path = absl::StrCat("T", column, ".obj");
      cell.mutable_tile()->set_root(folder_ / "scene");
      cell.mutable_tile()->set_path(path);
      cell.mutable_tile()->set_digest(FileDigest(ReadFile(folder_ / ("scene/" + path)).value()));
      cell.set_x_min(10 * column);
      cell.set_x_max(10 * column + 10);
      cell.set_y_max(10);
    }
    *input_.mutable_tile() = input_.around(0).tile();
    // The lake's part in the first cell, as new points, and a wall on its south.
    added_.patch.new_points = {{7, 3, 0.85}, {10, 3, 1.15}, {10, 7, 1.35}, {7, 7, 1.05}, {10, 3, 4}};
    const int32_t first = ParseTexturedObj(ReadFile(folder_ / "scene/T0.obj").value(), "T0")->file.mesh.points.size();
    added_.patch.triangles = {
        {first, first + 1, first + 2}, {first, first + 2, first + 3}, {first, first + 1, first + 4}};
    added_.runs = {{0, false, {1, 2, 3}}};
  }

  FillTexture Make() {
    TaskMemory memory(int64_t{1} << 40);
    auto texture = TextureOf(input_, added_, memory, CancelToken());
    EXPECT_TRUE(texture.ok()) << texture.status();
    return texture.value_or(FillTexture());
  }

  const TemporaryFolder folder_;
  v1::AssembleInput input_;
  TilePatch added_;
};

TEST_F(TextureStageTest, TheFillLooksAsTheGround) {
  const FillTexture made = Make();
  EXPECT_EQ(made.corners.size(), 3U);
  EXPECT_THAT(made.warnings, IsEmpty());
  const auto image = DecodeImage(made.image, "image");
  ASSERT_TRUE(image.ok()) << image.status();
  for (const Triangle& corners : made.corners) {
    double u = 0, v = 0;
    for (const int32_t c : corners) {
      u += double{made.places[static_cast<size_t>(c)][0]} / 3;
      v += double{made.places[static_cast<size_t>(c)][1]} / 3;
    }
    const Rgb seen = TexelAt(*image, u, v);
    EXPECT_NEAR(seen.g, 110, 75);
    EXPECT_NEAR(seen.r, seen.b, 6);
  }
  EXPECT_EQ(Make().image, made.image);
}

TEST_F(TextureStageTest, NoImageIsMadeIfNoneIsAskedFor) {
  input_.clear_texture();
  EXPECT_EQ(Make().image, "");
}

TEST_F(TextureStageTest, AnImageThatCannotBeReadLeavesTheColours) {
  folder_.Write("scene/ground.png", "GIF89a");
  const FillTexture made = Make();
  EXPECT_EQ(made.image, "");
  EXPECT_THAT(made.warnings, ElementsAre(HasSubstr("ground.png")));
}

TEST_F(TextureStageTest, AnImageThatCannotBeReadLeavesTheOthers) {
  std::string text = ReadFile(folder_ / "scene/T0.obj").value();
  const std::string ground = "usemtl ground\n";
  text.replace(text.find(ground), ground.size(), "usemtl other\n");
  size_t face = text.find("\nf ");
  for (int i = 0; i < 100; ++i) face = text.find("\nf ", face + 1);  // most of 176
  text.insert(face + 1, ground);
  folder_.Write("scene/T0.obj", text);
  folder_.Write("scene/T0.mtl", "newmtl other\nmap_Kd other.bmp\nnewmtl ground\nmap_Kd ground.png\n");
  folder_.Write("scene/other.bmp", "BM");
  input_.mutable_around(0)->mutable_tile()->set_digest(FileDigest(text));
  *input_.mutable_tile() = input_.around(0).tile();
  const FillTexture made = Make();
  EXPECT_NE(made.image, "");
  EXPECT_THAT(made.warnings, ElementsAre(HasSubstr("other.bmp")));
}

// The neighbour's image is four times finer: its part of the hole has that texel, so this one has it, too.
TEST_F(TextureStageTest, CellsThatShareAHoleHaveOneTexel) {
  folder_.Write("scene/T1.mtl", "newmtl ground\nmap_Kd fine.png\n");
  folder_.Write("scene/fine.png", PngImage(320, 320, [](int32_t, int32_t row) {
                  const auto grey = static_cast<uint8_t>(row % 32 < 8 ? 180 : 90);
                  return Rgb{grey, grey, grey};
                }));
  const auto image = DecodeImage(Make().image, "image");
  ASSERT_TRUE(image.ok()) << image.status();
  EXPECT_EQ(image->width, 64);  // 3 m at 6.25 cm, and two gutters
  EXPECT_EQ(image->height, 128);
}

TEST_F(TextureStageTest, ATileThatChangedIsAnError) {
  folder_.Write("scene/T1.obj", "v 0 0 0\n");
  TaskMemory memory(int64_t{1} << 40);
  EXPECT_FALSE(TextureOf(input_, added_, memory, CancelToken()).ok());
}

TEST_F(TextureStageTest, GivenWaterHasItsColour) {
  added_.runs[0].is_water = true;
  input_.set_water_colour("10,20,200");
  const FillTexture made = Make();
  const auto image = DecodeImage(made.image, "image");
  ASSERT_TRUE(image.ok()) << image.status();
  const auto& place = made.places[static_cast<size_t>(made.corners[0][1])];
  EXPECT_NEAR(TexelAt(*image, double{place[0]} - 0.1, double{place[1]} + 0.1).b, 200, 25);
}

}  // namespace
}  // namespace tilemend
