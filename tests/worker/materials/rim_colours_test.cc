#include "worker/materials/rim_colours.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/image_builders.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// Left half red, right half blue.
std::string TwoColours() {
  return PngImage(8, 8, [](int32_t column, int32_t) { return column < 4 ? Rgb{200, 0, 0} : Rgb{0, 0, 200}; });
}

// Triangles 0 and 1 lie on the image's left and right, 2 has a plain material, 3 one that nobody defines, 4 no texture
// coordinates.
ObjTextures Textures() {
  ObjTextures t;
  t.materials = {"image", "plain", "unknown"};
  t.runs = {{0, 0}, {2, 1}, {3, 2}, {4, 0}};
  t.coordinates = {{0.1F, 0.5F}, {0.2F, 0.6F}, {0.8F, 0.5F}, {0.9F, 0.6F}};
  t.corners = {{0, 1, 0}, {2, 3, 2}, {0, 0, 0}, {0, 0, 0}, {0, -1, 0}};
  return t;
}

TileLook Look() {
  TileLook look;
  look.materials = {{"image", {{}, "a.png"}}, {"plain", {Rgb{1, 2, 3}, ""}}};
  return look;
}

// Boundary vertex i is vertex 2 i of the file.
std::vector<BoundaryVertex> Vertices(int32_t count) {
  std::vector<BoundaryVertex> vertices(static_cast<size_t>(count));
  for (int32_t v = 0; v < count; ++v) vertices[static_cast<size_t>(v)].index = 2 * v;
  return vertices;
}

std::vector<RimSpot> Spots() {
  std::vector<RimSpot> spots;
  for (int32_t t = 0; t < 5; ++t) spots.push_back({4 - t, t, {0.45, 0.45, 0.1}});
  return spots;
}

TEST(SampleRimTest, TakesTexelsAndPlainColours) {
  const TemporaryFolder folder;
  folder.Write("a.png", TwoColours());
  const RimColours rim = SampleRim(folder.path(), Look(), Textures(), Spots(), Vertices(6)).value();
  EXPECT_THAT(rim.colours,
              ElementsAre(std::nullopt, std::nullopt, Rgb{1, 2, 3}, Rgb{0, 0, 200}, Rgb{200, 0, 0}, std::nullopt));
  EXPECT_THAT(rim.warnings, IsEmpty());
}

TEST(SampleRimTest, AnImageThatCannotBeReadGivesAWarningAndNoColour) {
  const TemporaryFolder folder;
  for (const std::string& bytes : {std::string(), TwoColours().substr(0, 60), std::string("GIF89a")}) {
    folder.Write("a.png", bytes);
    const RimColours rim = SampleRim(folder.path(), Look(), Textures(), Spots(), Vertices(5)).value();
    EXPECT_EQ(rim.colours[4], std::nullopt);
    EXPECT_EQ(rim.colours[2], (Rgb{1, 2, 3}));
    EXPECT_THAT(rim.warnings, ElementsAre(HasSubstr("a.png")));
  }
}

TEST(SampleRimTest, LeavesImagesAloneThatTouchNoRim) {
  const TemporaryFolder folder;  // without a.png
  EXPECT_THAT(SampleRim(folder.path(), Look(), Textures(), {Spots()[2]}, Vertices(5)).value().warnings, IsEmpty());
}

TEST(SampleRimTest, ATileWithoutMaterialsHasNoColours) {
  EXPECT_THAT(SampleRim("", TileLook(), Textures(), Spots(), Vertices(5)).value().colours, IsEmpty());
}

TEST(SampleRimTest, VerticesHaveTheirColoursWhereNoMaterialIsInForce) {
  ObjTextures textures = Textures();
  textures.runs.erase(textures.runs.begin());  // the first triangles have no material
  textures.vertex_colours.resize(9);
  for (uint8_t v = 0; v < 8; ++v) textures.vertex_colours[v] = Rgb{v, v, v};
  const RimColours rim = SampleRim("", Look(), textures, Spots(), Vertices(5)).value();
  EXPECT_THAT(rim.colours, ElementsAre(std::nullopt, Rgb{2, 2, 2}, Rgb{1, 2, 3}, Rgb{6, 6, 6}, std::nullopt))
      << "none of texture coordinates, the unknown material, the plain one, no material, and a vertex without colour";
  const RimColours alone = SampleRim("", TileLook(), textures, {Spots()[1]}, Vertices(5)).value();
  EXPECT_THAT(alone.colours, ElementsAre(std::nullopt, std::nullopt, std::nullopt, Rgb{6, 6, 6}, std::nullopt));
}

}  // namespace
}  // namespace tilemend
