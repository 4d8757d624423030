#include "worker/materials/tile_look.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class TileLookTest : public testing::Test {
 protected:
  TileLook Read(std::vector<std::string> libraries) {
    ObjTextures textures;
    textures.libraries = std::move(libraries);
    return ReadObjLook(folder_.path(), "Data/T.obj", textures).value();
  }

  TemporaryFolder folder_;
};

TEST_F(TileLookTest, ReadsMaterialsAndTheImagesThatTheyName) {
  folder_.Write("Data/T.mtl", "newmtl a\nKd 1 1 1\nmap_Kd a b.jpg\nbump a b.jpg\nnewmtl b\nKd 0 0 1\nnewmtl a\n");
  folder_.Write("Data/a b.jpg", "x");
  const TileLook look = Read({"T.mtl", "T.mtl"});
  EXPECT_THAT(look.files.libraries, ElementsAre("Data/T.mtl"));
  EXPECT_THAT(look.files.images, ElementsAre("Data/a b.jpg"));
  EXPECT_THAT(look.files.warnings, IsEmpty());
  EXPECT_EQ(look.materials.at("a").image, "Data/a b.jpg") << "the first definition counts";
  EXPECT_EQ(look.materials.at("a").diffuse, std::nullopt) << "its image says what it looks like";
  EXPECT_EQ(look.materials.at("b").diffuse, (Rgb{0, 0, 255}));
}

TEST_F(TileLookTest, TellsSeveralLibrariesFromOneWithBlanks) {
  folder_.Write("Data/one two.mtl", "newmtl a\n");
  folder_.Write("Data/x.mtl", "newmtl b\n");
  folder_.Write("Data/y.mtl", "newmtl c\n");
  EXPECT_THAT(Read({"one two.mtl"}).files.libraries, ElementsAre("Data/one two.mtl"));
  const TileLook look = Read({"x.mtl y.mtl lost.mtl"});
  EXPECT_THAT(look.files.libraries, ElementsAre("Data/x.mtl", "Data/y.mtl"));
  EXPECT_THAT(look.files.warnings, ElementsAre(HasSubstr("Data/T.obj: lost.mtl is not there")));
}

TEST_F(TileLookTest, LooksForImagesBesideTheLibraryThenBesideTheTile) {
  folder_.Write("materials/m.mtl", "newmtl a\nmap_Kd a.jpg\nnewmtl b\nmap_Kd b.jpg\n");
  folder_.Write("materials/a.jpg", "x");
  folder_.Write("Data/a.jpg", "x");
  folder_.Write("Data/b.jpg", "x");
  EXPECT_THAT(Read({"../materials/m.mtl"}).files.images, ElementsAre("materials/a.jpg", "Data/b.jpg"));
}

TEST_F(TileLookTest, WarnsOfFilesThatCannotBeHad) {
  folder_.Write("Data/T.mtl", "newmtl a\nmap_Kd ../../away.jpg\nnewmtl b\nmap_Kd lost\x01.jpg\n");
  const TileLook look = Read({"T.mtl", "no such.mtl"});
  EXPECT_THAT(look.files.warnings,
              ElementsAre(HasSubstr("Data/T.mtl: line 2: ../../away.jpg lies outside the scene's folder"),
                          HasSubstr("lost\\x01.jpg is not there"), HasSubstr("Data/T.obj: no such.mtl is not there")));
  EXPECT_EQ(look.materials.at("a").image, "");
}

TEST_F(TileLookTest, WithoutItsImageAMaterialHasItsDiffuseColour) {
  folder_.Write("Data/T.mtl", "newmtl a\nKd 0 0 1\nmap_Kd lost.jpg\n");
  const TileLook look = Read({"T.mtl"});
  EXPECT_EQ(look.materials.at("a").image, "");
  EXPECT_EQ(look.materials.at("a").diffuse, (Rgb{0, 0, 255}));
}

// It would be written over the other tile.
TEST_F(TileLookTest, CommentsBehindNamesAreNoPartOfThem) {
  folder_.Write("Data/x.mtl", "newmtl a\nmap_Kd x.png  # from above\nnewmtl b\nmap_Kd y #2.png\n");
  folder_.Write("Data/z.mtl", "newmtl c\n");
  folder_.Write("Data/x.png", "x");
  folder_.Write("Data/y #2.png", "x");
  const TileLook look = Read({"x.mtl\tz.mtl # its materials"});
  EXPECT_THAT(look.files.libraries, ElementsAre("Data/x.mtl", "Data/z.mtl"));
  EXPECT_THAT(look.files.images, ElementsAre("Data/x.png", "Data/y #2.png"));
  EXPECT_EQ(look.materials.at("a").image, "Data/x.png");
  EXPECT_THAT(look.files.warnings, IsEmpty());
}

TEST_F(TileLookTest, WarnsOfALibraryWithoutMaterials) {
  folder_.Write("Data/wide.mtl", std::string("\xff\xfen\0e\0w\0m\0t\0l\0 \0a\0", 18));
  const TileLook look = Read({"wide.mtl"});
  EXPECT_THAT(look.files.libraries, ElementsAre("Data/wide.mtl"));
  EXPECT_THAT(look.files.warnings, ElementsAre(HasSubstr("Data/wide.mtl: no material in it")));
}

TEST_F(TileLookTest, ATileIsNoImageAndNoLibrary) {
  folder_.Write("Data/U.obj", "v 0 0 0\n");
  folder_.Write("report.json", "{}");
  folder_.Write("Data/T.mtl", "newmtl a\nmap_Ks ..\\Data\\.\\u.OBJ\nmap_Kd ../report.json\n");
  const TileLook look = Read({"T.mtl", "U.obj"});
  EXPECT_THAT(look.files.libraries, ElementsAre("Data/T.mtl"));
  EXPECT_THAT(look.files.images, IsEmpty());
  EXPECT_THAT(look.files.warnings,
              ElementsAre(HasSubstr("Data/T.mtl: line 2: ..\\Data\\.\\u.OBJ has the name of a tile"),
                          HasSubstr("Data/T.mtl: line 3: ../report.json has the name"),
                          HasSubstr("Data/T.obj: U.obj has the name")));
}

TEST_F(TileLookTest, ReadsTheTexturesOfAPly) {
  folder_.Write("Data/a.png", "x");
  const TileLook look = ReadPlyLook(folder_.path(), "Data/T.ply",
                                    "ply\ncomment TextureFile a.png\ncomment TextureFile b.png\nend_header\n")
                            .value();
  EXPECT_THAT(look.files.images, ElementsAre("Data/a.png"));
  EXPECT_THAT(look.files.warnings, ElementsAre(HasSubstr("b.png is not there")));
}

}  // namespace
}  // namespace tilemend
