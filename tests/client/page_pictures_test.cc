#include "client/page_pictures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "absl/strings/str_cat.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

// A row of cells, each with a square of `width` metres that was filled: the holes 0, 1, 2 ... of cluster `cluster`.
struct FilledRow {
  TemporaryFolder scene_folder, out_folder;
  Scene scene;
  Json report;

  void AddCell(double width, Json cluster) {
    const auto column = static_cast<int32_t>(scene.tiles.size());
    const std::string name = absl::StrCat("tile", column, ".obj");
    const double west = 100.0 * column, east = west + width;
    const std::string rim = absl::StrCat("v ", west, " 0 0\nv ", east, " 0 0\nv ", east, " ", width, " 0\nv ", west,
                                         " ", width, " 0\nv ", west, " -1 0\nf 1 5 2\n");
    SceneTile tile;
    tile.cell = {column, 0};
    tile.path = name;
    scene.root = scene_folder.path();
    scene_folder.Write(name, rim);
    out_folder.Write(OutputPath(tile), absl::StrCat(rim, "f 1 2 3\nf 1 3 4\n"));
    scene.tiles.push_back(tile);
    report["per_hole"].push_back({{"id", column},
                                  {"cell", {column, 0}},
                                  {"cluster", std::move(cluster)},
                                  {"centre", {west + width / 2, width / 2}},
                                  {"area_m2", width * width},
                                  {"outcome", "filled"}});
  }

  std::vector<int64_t> Pictured() const {
    const PagePictures made = MakePagePictures(report, scene, out_folder.path());
    EXPECT_THAT(made.problems, IsEmpty());
    std::vector<int64_t> holes;
    for (const PagePicture& picture : made.pictures) holes.push_back(picture.hole);
    return holes;
  }
};

// A picture shows one tile, so that one picture of a cluster left its fills in other cells unseen.
TEST(PagePicturesTest, ShowsTheFillsOfAClusterInSeveralCells) {
  FilledRow row;
  row.AddCell(4, 0);
  row.AddCell(5, 0);
  row.AddCell(3, Json());
  EXPECT_THAT(row.Pictured(), ElementsAre(1, 0, 2));
}

TEST(PagePicturesTest, AClusterOfManyCellsLeavesPicturesToOthers) {
  FilledRow row;
  for (int i = 0; i < 6; ++i) row.AddCell(10 - i, 0);
  row.AddCell(2, Json());
  EXPECT_THAT(row.Pictured(), ElementsAre(0, 1, 2, 6));
}

TEST(PagePicturesTest, SmallFillsHaveNone) {
  FilledRow row;
  row.AddCell(0.7, Json());
  EXPECT_THAT(row.Pictured(), IsEmpty());
}

}  // namespace
}  // namespace tilemend
