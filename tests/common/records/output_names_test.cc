#include "common/records/output_names.h"

#include <gtest/gtest.h>

namespace tilemend {
namespace {

TEST(IsOutputNameTest, KnowsTilesAndTheProgramsOwnFiles) {
  for (const char* path :
       {"Data/Tile_+000_+000/Tile_+000_+000.obj", "tiles/a.ply", "report.json", "holes.geojson", "breaklines.geojson",
        "scene.json", "metadata.xml", ".tilemend-job", ".tilemend-results", ".tilemend-attempts/key"}) {
    EXPECT_TRUE(IsOutputName(path)) << path;
  }
}

TEST(IsOutputNameTest, KnowsThemHoweverTheyAreSpelt) {
  for (const char* path :
       {"Data/T.OBJ", "Report.JSON", "./report.json", "a/../report.json", "a/..//.Tilemend-Results"}) {
    EXPECT_TRUE(IsOutputName(path)) << path;
  }
}

TEST(IsOutputNameTest, LeavesMaterialsImagesAndFilesInFolders) {
  for (const char* path : {"Data/T/T.mtl", "Data/T/T_0.jpg", "Data/report.json", "obj/a.png", "a.obj.png",
                           "Data/.tilemend-results", "", "."}) {
    EXPECT_FALSE(IsOutputName(path)) << path;
  }
}

}  // namespace
}  // namespace tilemend
