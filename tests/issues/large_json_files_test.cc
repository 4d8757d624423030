// scene.json of 99 MB took 2.2 GB and GeoJSON of 48 MB 3.1 GB of the coordinator, which a limit of memory then ended,
// again and again.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <iostream>
#include <string>

#include "absl/strings/str_cat.h"
#include "common/gis/area_file.h"
#include "common/grid/scene.h"
#include "common/util/files.h"
#include "tests/common/gis/geojson_text.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;

constexpr int64_t kMegabyte = 1'000'000;

int64_t PeakMegabytes() {
  rusage usage{};
  EXPECT_EQ(::getrusage(RUSAGE_SELF, &usage), 0);
  return usage.ru_maxrss * 1024 / kMegabyte;
}

// A text of about so many bytes: `piece` again and again.
std::string Repeated(const std::string& piece, int64_t bytes) {
  std::string text;
  while (std::ssize(text) < bytes) text += piece;
  return text;
}

TEST(LargeJsonFilesTest, ASceneOf99MegabytesIsRefusedBeforeItIsRead) {
  const TemporaryFolder folder;
  const std::string tile = R"({"col": 0, "row": 0, "path": "tiles/Tile_+000_+000.ply"},)";
  const std::string scene = R"({"cell_size": 20, "cols": 2, "rows": 2, "tiles": [)" + Repeated(tile, 99 * kMegabyte);
  ASSERT_TRUE(WriteFileAtomically(folder / "scene.json", scene + "{}]}", Sync::kNo).ok());
  const int64_t before = PeakMegabytes();
  const absl::Status status = LoadScene(folder.path(), nullptr, nullptr).status();
  std::cout << status << ", " << PeakMegabytes() - before << " MB\n";
  EXPECT_TRUE(absl::IsInvalidArgument(status));
  EXPECT_THAT(std::string(status.message()), HasSubstr("at most 64 MiB"));
  EXPECT_LT(PeakMegabytes() - before, 10);
}

// Only what GDAL does not tell is kept of it. The limit is three copies of the text.
TEST(LargeJsonFilesTest, GeoJsonOf48MegabytesTakesLittleMoreThanItsText) {
  const std::string numbers = "[" + Repeated("0,", 48 * kMegabyte) + "0]";
  const std::string square = PolygonText(SquareAt(0, 0, 1));
  for (const std::string& text :
       {CollectionText({FeatureText(square, absl::StrCat(R"({"note":)", numbers, "}"))}),
        absl::StrCat(R"({"other":)", numbers, ",", CollectionText({FeatureText(square)}).substr(1)),
        absl::StrCat(R"({"type":"FeatureCollection","features":)", numbers, "}")}) {
    const int64_t before = PeakMegabytes();
    const auto file = ParseWaterFile({text, {}}, "lakes.geojson", {});
    std::cout << file.status() << ", " << PeakMegabytes() - before << " MB\n";
    EXPECT_LT(PeakMegabytes() - before, 3 * 48);
  }
}

TEST(LargeJsonFilesTest, MembersAreCountedAsBefore) {
  const std::string square = FeatureText(PolygonText(SquareAt(0, 0, 1)));
  EXPECT_EQ(ParseWaterFile({CollectionText({square, square}), {}}, "a.geojson", {})->areas.size(), 2U);
  const absl::Status status = ParseWaterFile({CollectionText({square, "7"}), {}}, "a.geojson", {}).status();
  EXPECT_THAT(std::string(status.message()), HasSubstr("not all members of \"features\" are Features"));
}

TEST(LargeJsonFilesTest, NothingMayFollowAScene) {
  const TemporaryFolder folder;
  const std::string scene = R"({"cell_size": 20, "cols": 1, "rows": 1, "tiles": [{"col": 0, "row": 0, "path": null}]})";
  for (const std::string& more : {std::string(" {}"), std::string("\0garbage", 8), std::string("x")}) {
    ASSERT_TRUE(WriteFileAtomically(folder / "scene.json", scene + more, Sync::kNo).ok());
    const absl::Status status = LoadScene(folder.path(), nullptr, nullptr).status();
    std::cout << status << '\n';
    EXPECT_THAT(std::string(status.message()), HasSubstr("not JSON"));
  }
}

}  // namespace
}  // namespace tilemend
