#include "client/fill_textures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/image_builders.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// A tile with one triangle, whose material is not defined, and a fill of one triangle with an image.
class FillTexturesTest : public ::testing::Test {
 protected:
  FillTexturesTest() {
    folder_.Write("in/t.obj", kOriginal);
    folder_.Write("out/fill.png", PngImage(4, 4, [](int32_t, int32_t) { return Rgb{40, 120, 60}; }));
    folder_.Write("out/t.mtl", "newmtl fill\nmap_Kd fill.png\n");
    WriteFill("vt 1 0.5");
  }
  void WriteFill(const std::string& coordinate) {
    folder_.Write("out/t.obj", std::string(kOriginal) + "vt 0 0\n" + coordinate + "\nusemtl fill\nf 2/2 4/3 3/2\n");
  }
  std::vector<std::string> Faults() {
    ComparedTile pair;
    pair.before = ReadCheckedTile(folder_ / "in", "t.obj").value();
    pair.after = ReadCheckedTile(folder_ / "out", "t.obj").value();
    return FillTextureFaults(folder_ / "out", "t.obj", pair, {false, true});
  }

  static constexpr char kOriginal[] =
      "mtllib t.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 7 nan\nusemtl unknown\nf 1/1 2/1 3/1\n";
  TemporaryFolder folder_;
};

TEST_F(FillTexturesTest, FaultsOfTheOriginalDoNotCount) { EXPECT_THAT(Faults(), IsEmpty()); }

TEST_F(FillTexturesTest, AnImageCanBeRead) {
  folder_.Write("out/fill.png", "");
  EXPECT_THAT(Faults(), ElementsAre(HasSubstr("t.obj: fill.png: ")));
}

TEST_F(FillTexturesTest, AMaterialIsDefined) {
  folder_.Write("out/t.mtl", "newmtl other\n");
  EXPECT_THAT(Faults(), ElementsAre("t.obj: material fill is not defined"));
}

TEST_F(FillTexturesTest, TextureCoordinatesAreInTheImage) {
  for (const char* coordinate : {"vt 0.5 nan", "vt 0.5 1.25", "vt -0.5 0"}) {
    WriteFill(coordinate);
    EXPECT_THAT(Faults(), ElementsAre("t.obj: texture coordinates of 1 new triangles are off the image")) << coordinate;
  }
}

}  // namespace
}  // namespace tilemend
