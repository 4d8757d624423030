#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <string>

#include "absl/strings/str_cat.h"
#include "common/grid/scene.h"
#include "common/util/files.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr char kMetadata[] = R"(<?xml version="1.0" encoding="UTF-8"?>
<ModelMetadata version="1"><!--Spatial Reference System-->
  <SRS> EPSG:4547
  </SRS><SRSOrigin>501027.524000,2488718.808000,0.000000</SRSOrigin></ModelMetadata>)";

// These tests' tiles are files with their bounds as text: "x0 y0 x1 y1".
absl::StatusOr<ConvexHull> TextBounds(const std::string& path, const TileFrame& frame) {
  EXPECT_TRUE(frame.empty());
  const std::string text = ReadFile(path).value();
  Point2 lo, hi;
  if (std::sscanf(text.c_str(), "%lf %lf %lf %lf", &lo.x(), &lo.y(), &hi.x(), &hi.y()) != 4) {
    return absl::InvalidArgumentError(path + ": no bounds");
  }
  return ConvexHull{lo, {hi.x(), lo.y()}, hi, {lo.x(), hi.y()}};
}

class SceneFolderTest : public testing::Test {
 protected:
  // A 100 m tile with an overlap of 0.1 m.
  void WriteTile(const std::string& name, int col, int row) {
    folder_.Write(name,
                  absl::StrCat(100 * col - 0.1, " ", 100 * row - 0.1, " ", 100 * col + 100.1, " ", 100 * row + 100.1));
  }
  absl::StatusOr<Scene> Load() { return LoadScene(folder_.path(), TextBounds); }
  void ExpectError(absl::StatusCode code, const std::string& message) {
    const absl::Status status = Load().status();
    EXPECT_EQ(status.code(), code) << status;
    EXPECT_THAT(std::string(status.message()), HasSubstr(message));
  }
  TemporaryFolder folder_;
};

TEST_F(SceneFolderTest, FindsTilesWithoutReadingThem) {
  folder_.Write("metadata.xml", kMetadata);
  for (const char* name : {"Data/Tile_+000_-001/Tile_+000_-001.osgb", "Data/Tile_+001_+000/Tile_+001_+000.osgb"}) {
    folder_.Write(name, "no mesh");
  }
  const auto scene = FindSceneWithoutGrid(folder_.path());
  ASSERT_TRUE(scene.ok()) << scene.status();
  ASSERT_EQ(scene->tiles.size(), 2u);
  EXPECT_EQ(scene->tiles[0].cell, (CellId{0, 0})) << "numbered from 0, as LoadScene does";
  EXPECT_EQ(scene->tiles[1].cell, (CellId{1, 1}));
  EXPECT_EQ(scene->tiles[1].path, "Data/Tile_+001_+000/Tile_+001_+000.osgb");
  EXPECT_EQ(scene->origin.x(), 501027.524);
  EXPECT_EQ(scene->grid.cell_size.x(), 0);
  EXPECT_TRUE(absl::IsNotFound(FindSceneWithoutGrid(folder_ / "nothing").status()));
}

TEST_F(SceneFolderTest, FindsTilesByName) {
  WriteTile("Tile_+000_+001.ply", 0, 1);
  WriteTile("tiles/city_+001_+001.OBJ", 1, 1);
  WriteTile("tiles/Tile_+002_+000.obj", 2, 0);
  folder_.Write("tiles/Tile_+002_+000.mtl", "");
  folder_.Write("tiles/readme.txt", "");
  const auto scene = Load();
  ASSERT_TRUE(scene.ok()) << scene.status();
  ASSERT_EQ(scene->tiles.size(), 3u);
  EXPECT_EQ(scene->tiles[0].path, "tiles/Tile_+002_+000.obj");
  EXPECT_EQ(scene->tiles[1].path, "Tile_+000_+001.ply");
  EXPECT_EQ(scene->tiles[2].cell, (CellId{1, 1}));
  EXPECT_EQ(scene->cols, 3);
  EXPECT_EQ(scene->rows, 2);
  EXPECT_EQ(scene->grid.cell_size, Point2(100, 100));
  EXPECT_EQ(scene->grid.corner, Point2(0, 0));
  EXPECT_FALSE(scene->area_known);
  ASSERT_EQ(scene->warnings.size(), 1u);
  EXPECT_THAT(scene->warnings[0],
              AllOf(HasSubstr("3 tiles"), HasSubstr("cell size 100 x 100"), HasSubstr("corner 0, 0")));
}

TEST_F(SceneFolderTest, ReadsThePhotogrammetryLayout) {
  folder_.Write("metadata.xml", kMetadata);
  WriteTile("Data/Tile_+000_+014/Tile_+000_+014.obj", 0, 14);
  WriteTile("Data/Tile_+000_+014/Tile_+000_+014_L17.obj", 0, 14);
  folder_.Write("Data/Tile_+000_+014/Tile_+000_+014.mtl", "");
  WriteTile("Data/Tile_+000_+015/mesh.ply", 0, 15);
  folder_.Write("Data/Tile_+000_+016/Tile_+000_+016.b3dm", "");
  const auto scene = Load();
  ASSERT_TRUE(scene.ok()) << scene.status();
  EXPECT_EQ(scene->crs, "EPSG:4547");
  EXPECT_EQ(scene->origin, Point3(501027.524, 2488718.808, 0));
  ASSERT_EQ(scene->tiles.size(), 2u);
  EXPECT_EQ(scene->tiles[0].path, "Data/Tile_+000_+014/Tile_+000_+014.obj");
  EXPECT_EQ(scene->tiles[1].path, "Data/Tile_+000_+015/mesh.ply");
  EXPECT_EQ(scene->grid.cell_size, Point2(100, 100));
  EXPECT_EQ(scene->rows, 16);
  EXPECT_THAT(scene->warnings[0], HasSubstr("Tile_+000_+016: no .ply, .obj or .osgb in it"));
}

TEST_F(SceneFolderTest, ShiftsNegativeIndices) {
  WriteTile("Tile_-002_+000.ply", -2, 0);
  WriteTile("Tile_-001_+001.ply", -1, 1);
  const auto scene = Load();
  ASSERT_TRUE(scene.ok()) << scene.status();
  EXPECT_EQ(scene->tiles[0].cell, (CellId{0, 0}));
  EXPECT_EQ(scene->tiles[1].cell, (CellId{1, 1}));
  EXPECT_EQ(scene->grid.corner, Point2(-200, 0));
  EXPECT_THAT(scene->warnings.back(), HasSubstr("cell -002_+000 is numbered +000_+000"));
}

TEST_F(SceneFolderTest, IsReadBackFromItsJson) {
  WriteTile("tiles/Tile_+000_+000.ply", 0, 0);
  WriteTile("tiles/Tile_+001_+000.ply", 1, 0);
  const Scene scene = Load().value();
  folder_.Write("scene.json", SceneJson(scene));
  const auto again = LoadScene(folder_.path(), nullptr);
  ASSERT_TRUE(again.ok()) << again.status();
  EXPECT_FALSE(again->area_known);
  EXPECT_EQ(again->grid.cell_size, scene.grid.cell_size);
}

TEST_F(SceneFolderTest, NamesBothTilesOfOneCell) {
  WriteTile("Tile_+000_+000.ply", 0, 0);
  WriteTile("tiles/Tile_+000_+000.obj", 0, 0);
  ExpectError(absl::StatusCode::kInvalidArgument, "tiles/Tile_+000_+000.obj are both cell +000_+000");
}

TEST_F(SceneFolderTest, RefusesToGuessBetweenTwoMeshes) {
  WriteTile("Data/Tile_+000_+000/a.ply", 0, 0);
  WriteTile("Data/Tile_+000_+000/b.ply", 0, 0);
  ExpectError(absl::StatusCode::kInvalidArgument, "b.ply could both be the tile Tile_+000_+000");
}

TEST_F(SceneFolderTest, NamesTheMissingTopOfATree) {
  folder_.Write("Data/Tile_+000_+000/Tile_+000_+000_L15_0u.osgb", "");
  folder_.Write("Data/Tile_+000_+000/Tile_+000_+000_L16_0uu.osgb", "");
  ExpectError(absl::StatusCode::kNotFound,
              "Tile_+000_+000/Tile_+000_+000.osgb: is not there, the top of the tile's tree");
}

TEST_F(SceneFolderTest, NamesTheFormatThatItCannotRead) {
  folder_.Write("Tile_+000_+014/Tile_+000_+014.b3dm", "");
  ExpectError(absl::StatusCode::kInvalidArgument, "Tile_+000_+014.b3dm: format \".b3dm\" is not read");
}

TEST_F(SceneFolderTest, FindsTheFirstFilesOfOsgbTrees) {
  folder_.Write("metadata.xml", kMetadata);
  WriteTile("Data/Tile_+000_+014/Tile_+000_+014.osgb", 0, 14);
  WriteTile("Data/Tile_+000_+014/Tile_+000_+014_L18_0.osgb", 0, 14);
  WriteTile("Data/Tile_+000_+015/Tile_+000_+015.osgb", 0, 15);
  const auto scene = Load();
  ASSERT_TRUE(scene.ok()) << scene.status();
  ASSERT_EQ(scene->tiles.size(), 2u);
  EXPECT_EQ(scene->tiles[0].path, "Data/Tile_+000_+014/Tile_+000_+014.osgb");
}

TEST_F(SceneFolderTest, AnOsgbTileNeedsAFolder) {
  WriteTile("Tile_+000_+014.osgb", 0, 14);
  ExpectError(absl::StatusCode::kInvalidArgument, "an .osgb tile has to lie in a folder of its own");
}

TEST_F(SceneFolderTest, RefusesTilesThatAreCutInHeight) {
  WriteTile("Data/Tile_+000_+013_+000/Tile_+000_+013_+000.obj", 13, 0);
  ExpectError(absl::StatusCode::kInvalidArgument, "Tile_+000_+013_+000: a name with three numbers");
}

TEST_F(SceneFolderTest, RefusesTilesWithoutColumnAndRow) {
  WriteTile("BlockA/BlockA.obj", 0, 0);
  ExpectError(absl::StatusCode::kInvalidArgument, "BlockA/BlockA.obj: a name without column and row");
}

TEST_F(SceneFolderTest, RefusesAdaptiveTiles) {
  WriteTile("Data/Tile_1/Tile_1.osgb", 0, 0);
  ExpectError(absl::StatusCode::kInvalidArgument, "Tile_1.osgb: a name without column and row");
}

TEST_F(SceneFolderTest, SaysWhatItLooksForInAnEmptyFolder) {
  ExpectError(absl::StatusCode::kNotFound, "no scene.json, and no tile named like");
}

TEST_F(SceneFolderTest, SaysWhatItFoundInPlaceOfTiles) {
  folder_.Write("Data/Tile_+000_+014/Tile_+000_+014_L17.obj.gz", "?");
  ExpectError(absl::StatusCode::kNotFound, "; found 1 file named Tile_+000_+014_L17.obj.gz: unpack or rename it");
  folder_.Write("Tile_+000_+014_L19.obj", "?");
  folder_.Write("Tile_+000_+014_L19.jpg", "?");
  folder_.Write("notes.gz", "?");
  ExpectError(absl::StatusCode::kNotFound, "; found 2 files such as Tile_+000_+014_L19.obj: unpack or rename them");
}

TEST_F(SceneFolderTest, LooksAtFewOfManyTiles) {
  for (int i = 0; i < 90; ++i) {
    WriteTile(absl::StrCat("Tile_+00", i % 10, "_+00", i / 10, ".ply"), i % 10, i / 10);
  }
  const auto scene = Load();
  ASSERT_TRUE(scene.ok()) << scene.status();
  EXPECT_EQ(scene->tiles.size(), 90U);
  EXPECT_EQ(scene->grid.cell_size, Point2(100, 100));
  EXPECT_EQ(scene->grid.corner, Point2(0, 0));
  EXPECT_THAT(scene->warnings.back(), HasSubstr("bounds of 37 of 90 tiles: cell size 100 x 100"));
}

TEST_F(SceneFolderTest, PassesTheReadersErrorOn) {
  folder_.Write("Tile_+000_+000.ply", "?");
  ExpectError(absl::StatusCode::kInvalidArgument, "Tile_+000_+000.ply: no bounds");
}

TEST_F(SceneFolderTest, NamesTheTileThatContradictsTheGrid) {
  for (int i = 0; i < 4; ++i) WriteTile(absl::StrCat("Tile_+00", i, "_+000.ply"), i, 0);
  WriteTile("Tile_+004_+000.ply", 2, 0);
  ExpectError(absl::StatusCode::kInvalidArgument,
              "Tile_+004_+000.ply: reaches more than a quarter of a cell beyond cell +004_+000");
}

TEST_F(SceneFolderTest, WarnsOfMetadataWithoutACrs) {
  WriteTile("Tile_+000_+000.ply", 0, 0);
  for (const char* srs : {"", "<SRS/>", "<SRS> \n</SRS>"}) {
    folder_.Write("metadata.xml", absl::StrCat("<ModelMetadata>", srs, "<SRSOrigin>1,2,3</SRSOrigin></ModelMetadata>"));
    const auto scene = Load();
    ASSERT_TRUE(scene.ok()) << scene.status();
    EXPECT_THAT(scene->warnings, testing::Contains(HasSubstr("metadata.xml: no SRS; the output has no CRS"))) << srs;
  }
}

TEST_F(SceneFolderTest, WarnsOfPhotogrammetryWithoutMetadata) {
  WriteTile("Data/Tile_+000_+000/Tile_+000_+000.obj", 0, 0);
  const auto none = Load();
  ASSERT_TRUE(none.ok()) << none.status();
  EXPECT_THAT(none->warnings, testing::Contains(AllOf(HasSubstr("no metadata.xml; the output has no CRS"),
                                                      testing::Not(HasSubstr("there is one")))));
  folder_.Write("metadata.xml", kMetadata);
  EXPECT_THAT(Load()->warnings, testing::Each(testing::Not(HasSubstr("no CRS"))));
  for (const char* name : {"Data", "Data/"}) {
    const auto data = LoadScene(folder_ / name, TextBounds);
    ASSERT_TRUE(data.ok()) << data.status();
    EXPECT_THAT(data->warnings, testing::Contains(AllOf(HasSubstr("no metadata.xml; the output has no CRS"),
                                                        HasSubstr("there is one in " + folder_.path()))));
  }
}

TEST_F(SceneFolderTest, MetadataThatIsALinkToNothingIsAnError) {
  WriteTile("Tile_+000_+000.ply", 0, 0);
  std::filesystem::create_symlink("gone.xml", folder_ / "metadata.xml");
  ExpectError(absl::StatusCode::kInvalidArgument, "metadata.xml: a link that leads to no file");
  folder_.Write("gone.xml", kMetadata);
  EXPECT_EQ(Load()->crs, "EPSG:4547");
}

TEST_F(SceneFolderTest, RefusesBadMetadata) {
  WriteTile("Tile_+000_+000.ply", 0, 0);
  folder_.Write("metadata.xml", "<ModelMetadata><SRS>");
  ExpectError(absl::StatusCode::kInvalidArgument, "metadata.xml: not XML: byte");
  folder_.Write("metadata.xml", "<ModelMetadata><SRSOrigin>1,2</SRSOrigin></ModelMetadata>");
  ExpectError(absl::StatusCode::kInvalidArgument, "metadata.xml: SRSOrigin: expected three numbers");
}

TEST_F(SceneFolderTest, ALinkToNothingThatHasATilesNameIsAnError) {
  WriteTile("Tile_+000_+000.ply", 0, 0);
  std::filesystem::create_symlink("offline/Tile.ply", folder_ / "Tile_+001_+001.ply");
  ExpectError(absl::StatusCode::kInvalidArgument, "Tile_+001_+001.ply: a link that leads to no file");
}

}  // namespace
}  // namespace tilemend
