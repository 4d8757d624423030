#include "client/output_tiles.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using Json = nlohmann::ordered_json;

// Three cells, of which the last has no surface.
Scene Row() {
  Scene scene;
  scene.cols = 3;
  scene.rows = 1;
  scene.tiles = {{{0, 0}, "Data/A/A.obj"}, {{1, 0}, "Data/./B/B.obj"}, {{2, 0}, ""}};
  return scene;
}

Json ReportOf(const char* outcome) {
  return {{"per_hole", {{{"cell", {2, 0}}, {"outcome", outcome}}, {{"cell", "none"}}, 7}}};
}

class OutputTilesTest : public ::testing::Test {
 protected:
  OutputTilesTest() {
    for (const char* tile : {"Data/A/A.obj", "Data/B/B.obj", "tiles/Tile_+002_+000.ply"}) folder_.Write(tile, "");
  }
  OutputTiles Look(const Json& report, const std::set<CellId>& chosen = {}) {
    return LookForTiles(folder_.path(), report, Row(), chosen);
  }

  TemporaryFolder folder_;
};

TEST_F(OutputTilesTest, FindsNothingWhereAllIsAsItWasWritten) {
  folder_.Write("Data/A/A.mtl", "");
  folder_.Write("report.json", "");
  folder_.Write("mine/other.obj", "");
  folder_.Write("Data/.tilemend-attempts/x.obj", "");
  const OutputTiles tiles = Look(ReportOf("filled"));
  EXPECT_THAT(tiles.missing, IsEmpty());
  EXPECT_THAT(tiles.others, IsEmpty());
}

TEST_F(OutputTilesTest, NamesTheTilesOfCellsThatHadASurfaceOrAFilledHole) {
  for (const char* tile : {"Data/A/A.obj", "Data/B/B.obj", "tiles/Tile_+002_+000.ply"}) {
    std::filesystem::remove(folder_ / tile);
  }
  std::filesystem::create_directory(folder_ / "Data/A/A.obj");
  EXPECT_THAT(Look(ReportOf("filled")).missing,
              ElementsAre("Data/A/A.obj", "Data/B/B.obj", "tiles/Tile_+002_+000.ply"));
  EXPECT_THAT(Look(ReportOf("left")).missing, ElementsAre("Data/A/A.obj", "Data/B/B.obj"));
  EXPECT_THAT(Look({}).missing, ElementsAre("Data/A/A.obj", "Data/B/B.obj"));
  EXPECT_THAT(Look(ReportOf("filled"), {{1, 0}}).missing, ElementsAre("Data/B/B.obj"));
}

TEST_F(OutputTilesTest, NamesMeshesAmongTheTilesThatAreOfNoCell) {
  folder_.Write("Data/C/C.OBJ", "");
  folder_.Write("Data/A/B.obj", "");
  folder_.Write("tiles/Tile_+009_+009.ply", "");
  EXPECT_THAT(Look(ReportOf("filled"), {{1, 0}}).others,
              ElementsAre("Data/A/B.obj", "Data/C/C.OBJ", "tiles/Tile_+009_+009.ply"));
}

}  // namespace
}  // namespace tilemend
