#include "client/water_proposal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "absl/strings/str_cat.h"
#include "client/inspection.h"
#include "common/gis/area_file.h"
#include "common/util/files.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

constexpr int kSide = 80;  // metres: of a cell, with a vertex every 2 m

double HeightAt(int x, int y) { return std::abs(y - kSide / 2) < 10 ? 1 + 0.02 * ((x + y) % 3) : 3 + 0.01 * x; }

// A tile with a canal along its middle.
std::string TileText(int col) {
  const int n = kSide / 2;
  std::string vertices, faces;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      const int x = col * kSide + 2 * i, y = 2 * j;
      absl::StrAppend(&vertices, x, " ", y, " ", HeightAt(x, y), "\n");
      if (i == n || j == n) continue;
      const int a = j * (n + 1) + i;
      absl::StrAppend(&faces, "3 ", a, " ", a + 1, " ", a + n + 2, "\n3 ", a, " ", a + n + 2, " ", a + n + 1, "\n");
    }
  }
  return absl::StrCat("ply\nformat ascii 1.0\nelement vertex ", (n + 1) * (n + 1),
                      "\nproperty float x\nproperty float y\nproperty float z\nelement face ", 2 * n * n,
                      "\nproperty list uchar int vertex_indices\nend_header\n", vertices, faces);
}

class WaterProposalTest : public ::testing::Test {
 protected:
  WaterProposalTest() {
    for (const int col : {0, 1}) folder_.Write(absl::StrCat("tile", col, ".ply"), TileText(col));
    folder_.Write("scene.json",
                  R"({"crs": "EPSG:25832", "origin": [691000, 5334000, 500], "cell_size": 80, "cols": 2, "rows": 1,
                      "tiles": [{"col": 0, "row": 0, "path": "tile0.ply"}, {"col": 1, "row": 0, "path": "tile1.ply"}]})");
    auto scene = LoadScene(folder_.path(), {});
    EXPECT_TRUE(scene.ok()) << scene.status();
    inspection_ = InspectScene(*std::move(scene), {});
    EXPECT_THAT(inspection_.errors, SizeIs(0));
  }

  const TemporaryFolder folder_;
  Inspection inspection_;
};

TEST_F(WaterProposalTest, ACanalIsProposedAndReadBack) {
  for (const char* name : {"water.gpkg", "water.geojson"}) {
    const std::string path = folder_ / name;
    const auto proposed = WriteWaterProposal(path, false, *inspection_.waves);
    ASSERT_TRUE(proposed.ok()) << proposed.status();
    ASSERT_THAT(*proposed, SizeIs(1));
    EXPECT_EQ((*proposed)[0]["name"], "surface 1");
    const auto bytes = ReadAreaFile(path);
    ASSERT_TRUE(bytes.ok()) << bytes.status();
    const auto file = ParseWaterFile(*bytes, path, FrameOf(inspection_.waves->scene()));
    ASSERT_TRUE(file.ok()) << file.status();
    ASSERT_THAT(file->areas, SizeIs(1));
    EXPECT_THAT(file->warnings, SizeIs(0));
    EXPECT_TRUE(file->areas[0].water && file->areas[0].clear);
    EXPECT_EQ(file->areas[0].level, std::nullopt);
    EXPECT_THAT(file->areas[0].label, HasSubstr("(surface 1)"));
    for (const double x : {2, 79, 81, 158}) EXPECT_TRUE(Contains(file->areas[0].polygon, {x, 40})) << x;
    EXPECT_FALSE(Contains(file->areas[0].polygon, {40, 60}));
  }
}

TEST_F(WaterProposalTest, AFileThatIsThereStays) {
  const std::string path = folder_.Write("water.geojson", "mine");
  EXPECT_TRUE(absl::IsAlreadyExists(WriteWaterProposal(path, false, *inspection_.waves).status()));
  EXPECT_EQ(*ReadFile(path), "mine");
  EXPECT_TRUE(WriteWaterProposal(path, true, *inspection_.waves).ok());
  EXPECT_NE(*ReadFile(path), "mine");
}

TEST(CheckWaterProposalTest, TheNameSaysTheFormat) {
  EXPECT_TRUE(CheckWaterProposal("/none/water.GPKG", false).ok());
  const absl::Status other = CheckWaterProposal("/none/water.shp", false);
  EXPECT_TRUE(absl::IsInvalidArgument(other)) << other;
  EXPECT_THAT(std::string(other.message()), HasSubstr(".gpkg or .geojson"));
}

}  // namespace
}  // namespace tilemend
