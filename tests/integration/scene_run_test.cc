// `tilemend run` and the cluster's programs on real scenes: the same bytes however they are made, the originals kept,
// every hole filled and counted, outputs refused, interrupted and completed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <tuple>
#include <vector>

#include "absl/strings/str_cat.h"
#include "common/util/files.h"
#include "tests/support/output_checks.h"
#include "tests/support/overlapping_scene.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using Json = nlohmann::json;

class SceneRunTest : public ::testing::Test {
 protected:
  Ended Tilemend(const std::vector<std::string>& words) {
    return Process(folder_.path(), TILEMEND_CLIENT, words).Wait();
  }
  Ended Run(const std::string& scene, const std::string& out, const std::vector<std::string>& more = {}) {
    std::vector<std::string> words = {"run", scene, "--out", out};
    words.insert(words.end(), more.begin(), more.end());
    return Tilemend(words);
  }
  // Whether a run over an older output was killed before it was complete: on a busy machine a run may end before the
  // signal comes, and is begun again.
  bool KilledWhileItWrites(const std::string& scene, const std::string& out) {
    for (int attempt = 0; attempt < 20; ++attempt) {
      folder_.Write("out/report.json", "of an older output");
      folder_.Write("out/tiles/Tile_+000_+000.ply.part-0123abcd-1", "of a worker that was killed");
      Process process(folder_.path(), TILEMEND_CLIENT, {"run", scene, "--out", out, "--overwrite"});
      process.AwaitLine("write the tiles");
      process.Signal(SIGKILL);
      if (process.Wait().code == -SIGKILL && !std::filesystem::exists(out + "/report.json")) return true;
    }
    return false;
  }
  void ExpectComplete(const std::string& out, const std::map<std::string, std::string>& tiles) {
    EXPECT_EQ(TilesBelow(out), tiles);
    EXPECT_FALSE(std::filesystem::exists(out + "/.tilemend-job"));
    EXPECT_TRUE(std::filesystem::exists(out + "/report.json"));
  }

  TemporaryFolder folder_;
};

class CutTest : public SceneRunTest, public ::testing::WithParamInterface<Cut> {};

// Both cuts with both surfaces.
class SurfaceTest : public SceneRunTest, public ::testing::WithParamInterface<std::tuple<Cut, const char*>> {
 protected:
  Cut cut() const { return std::get<0>(GetParam()); }
  std::string surface() const { return std::get<1>(GetParam()); }
};

TEST_P(SurfaceTest, FillsEveryHoleKeepsTheOriginalsAndCloses) {
  const SceneMakerOptions options = SmallScene(cut());
  const std::string scene = WriteMade(options, folder_ / "scene"), out = folder_ / "out";
  const auto before = FilesBelow(scene);
  const Ended ended = Run(scene, out, {"--surface", surface()});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(FilesBelow(scene), before);
  ExpectOriginalsKept(scene, out);
  ExpectClosed(options, out);
}

TEST_P(SurfaceTest, TheBytesDoNotDependOnTheWorkers) {
  const std::string scene = WriteMade(SmallScene(cut()), folder_ / "scene");
  ASSERT_EQ(Run(scene, folder_ / "one", {"--workers", "1", "--surface", surface()}).code, 0);
  const auto tiles = TilesBelow(folder_ / "one");
  EXPECT_EQ(tiles.size(), 12U);
  for (const char* workers : {"2", "4"}) {
    const std::string out = folder_ / absl::StrCat("with-", workers);
    ASSERT_EQ(Run(scene, out, {"--workers", workers, "--surface", surface()}).code, 0);
    ExpectComplete(out, tiles);
  }
}

TEST_P(CutTest, TheReportCountsWhatInspectFound) {
  const std::string scene = WriteMade(SmallScene(GetParam()), folder_ / "scene");
  const Ended inspected = Tilemend({"inspect", scene, "-o", "json"});
  ASSERT_EQ(inspected.code, 0) << inspected.err;
  const Json plan = Json::parse(inspected.out, nullptr, false);
  ASSERT_TRUE(plan.is_object()) << inspected.out;
  ASSERT_EQ(Run(scene, folder_ / "out").code, 0);
  const Json report = ReportOf(folder_ / "out");
  for (const char* field : {"cells", "clusters", "layers", "holes", "single", "continuous", "borders"})
    EXPECT_EQ(report[field], plan[field]) << field;
  EXPECT_GT(report["holes"]["closed"], 0);
  EXPECT_GT(report["clusters"], 0);
  EXPECT_EQ(report["filled"], report["holes"]);
  EXPECT_EQ(report["left"].size(), 0U);
  int64_t triangles = 0;
  for (const Json& hole : report["per_hole"]) {
    EXPECT_EQ(hole["outcome"], "filled") << hole;
    triangles += hole["triangles"].get<int64_t>();
  }
  EXPECT_EQ(report["quality"]["triangles"], triangles);
  EXPECT_GE(report["quality"]["mean"], 0.9);
  EXPECT_GE(report["quality"]["fifth_percentile"], 0.7);
  EXPECT_EQ(report["quality"]["poor"], report["quality"]["poor_forced_by_rim"]);
}

INSTANTIATE_TEST_SUITE_P(Surfaces, SurfaceTest,
                         ::testing::Combine(::testing::Values(Cut::kClipped, Cut::kRagged),
                                            ::testing::Values("wang", "thin-plate")),
                         [](const auto& made) {
                           const std::string surface = std::get<1>(made.param);
                           return NameOf(std::get<0>(made.param)) + (surface == "wang" ? "Wang" : "ThinPlate");
                         });
INSTANTIATE_TEST_SUITE_P(Cuts, CutTest, ::testing::Values(Cut::kClipped, Cut::kRagged),
                         [](const auto& cut) { return NameOf(cut.param); });

TEST_F(SceneRunTest, ACellWithoutSurfaceGetsATile) {
  SceneMakerOptions options = SmallScene(Cut::kClipped);
  options.empty = {{2, 1}};
  const std::string scene = WriteMade(options, folder_ / "scene");
  ASSERT_EQ(Run(scene, folder_ / "out").code, 0);
  EXPECT_TRUE(TilesBelow(folder_ / "out").contains("tiles/Tile_+002_+001.ply"));
  ExpectClosed(options, folder_ / "out");
  EXPECT_EQ(ReportOf(folder_ / "out")["holes"]["I"]["A"], 1);
}

TEST_F(SceneRunTest, ASceneFoundByNamesLeavesItsSceneJsonWithTheOutput) {
  const std::string scene = WriteMade(SmallScene(Cut::kClipped), folder_ / "scene");
  std::filesystem::remove(scene + "/scene.json");
  const Ended ended = Run(scene, folder_ / "out");
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_FALSE(std::filesystem::exists(scene + "/scene.json"));
  const Json json = Json::parse(ReadFile(folder_ / "out/scene.json").value_or(""), nullptr, false);
  EXPECT_EQ(json["cell_size"], 20);
  EXPECT_EQ(json["area_known"], false);
  EXPECT_EQ(Tilemend({"inspect", folder_ / "out"}).code, 0);
}

TEST_F(SceneRunTest, InspectReplacesNoFileThatItReads) {
  const std::string scene = WriteMade(SmallScene(Cut::kClipped), folder_ / "scene");
  const std::string water = folder_.Write(
      "water.geojson", R"({"type": "Polygon", "coordinates": [[[1, 1], [9, 1], [9, 9], [1, 9], [1, 1]]]})");
  std::filesystem::create_symlink(water, folder_ / "link.geojson");
  const auto before = FilesBelow(scene);
  const std::string drawn = *ReadFile(water);
  for (const std::vector<std::string>& words : {std::vector<std::string>{"--holes", scene + "/scene.json"},
                                                {"--holes", scene + "/tiles/../scene.json"},
                                                {"--water", water, "--holes", water},
                                                {"--clear", water, "--holes", folder_ / "link.geojson"},
                                                {"--area", water, "--propose-water", water}}) {
    std::vector<std::string> all = {"inspect", scene, "--overwrite"};
    all.insert(all.end(), words.begin(), words.end());
    const Ended ended = Tilemend(all);
    EXPECT_EQ(ended.code, 2) << words.back() << ended.err;
    EXPECT_THAT(ended.err, HasSubstr(words.back() + ": is read as input"));
  }
  EXPECT_EQ(FilesBelow(scene), before);
  EXPECT_EQ(*ReadFile(water), drawn);
}

TEST_F(SceneRunTest, InspectReplacesNothingButPolygons) {
  const std::string scene = WriteMade(SmallScene(Cut::kClipped), folder_ / "scene");
  const std::string other = WriteMade(SmallScene(Cut::kClipped), folder_ / "other"), json = other + "/scene.json";
  const std::string before = *ReadFile(json);
  const Ended refused = Tilemend({"inspect", scene, "--overwrite", "--holes", json});
  EXPECT_EQ(refused.code, 2) << refused.err;
  EXPECT_THAT(refused.err, HasSubstr(json + ": holds no polygons"));
  EXPECT_EQ(*ReadFile(json), before);
}

TEST_F(SceneRunTest, InspectSaysThatItWroteAnAreaAndReplacesItIfAsked) {
  const std::string scene = WriteMade(SmallScene(Cut::kClipped), folder_ / "scene"), area = folder_ / "area.geojson";
  const Ended first = Tilemend({"inspect", scene, "--propose-area", area});
  EXPECT_EQ(first.code, 0) << first.err;
  EXPECT_THAT(first.err, HasSubstr("--area " + area));
  const Ended again = Tilemend({"inspect", scene, "--propose-area", area});
  EXPECT_EQ(again.code, 4);
  EXPECT_THAT(again.err, HasSubstr("or give --overwrite"));
  EXPECT_EQ(Tilemend({"inspect", scene, "--propose-area", area, "--overwrite"}).code, 0);
}

TEST_F(SceneRunTest, InspectMakesNoFolder) {
  const std::string scene = WriteMade(SmallScene(Cut::kClipped), folder_ / "scene");
  for (const char* flag : {"--holes", "--propose-area", "--propose-water"}) {
    const Ended ended = Tilemend({"inspect", scene, flag, folder_ / "nope/file.geojson"});
    EXPECT_EQ(ended.code, 3) << flag << ended.err;
    EXPECT_THAT(ended.err, HasSubstr(folder_ / "nope: no such folder"));
    EXPECT_FALSE(std::filesystem::exists(folder_ / "nope"));
  }
}

TEST_F(SceneRunTest, InspectTellsOutputsByTheirPlaces) {
  const std::string scene = WriteMade(SmallScene(Cut::kClipped), folder_ / "scene"), holes = folder_ / "q.geojson";
  const Ended ended = Tilemend({"inspect", scene, "--holes", holes, "--propose-area", folder_ / "scene/../q.geojson"});
  EXPECT_NE(ended.code, 0);
  EXPECT_THAT(ended.err, HasSubstr("give each a file of its own"));
  EXPECT_FALSE(std::filesystem::exists(holes));
}

TEST_F(SceneRunTest, AnExistingOutputIsLeftAlone) {
  const std::string scene = WriteMade(SmallScene(Cut::kClipped), folder_ / "scene"), out = folder_ / "out";
  ASSERT_EQ(Run(scene, out).code, 0);
  folder_.Write("out/mine.txt", "mine");
  const auto before = FilesBelow(out);
  const Ended again = Run(scene, out);
  EXPECT_EQ(again.code, 4);
  EXPECT_THAT(again.err, HasSubstr("--overwrite"));
  EXPECT_EQ(FilesBelow(out), before);
}

TEST_F(SceneRunTest, OverwriteReplacesFilesOfTheSameNameOnly) {
  const std::string scene = WriteMade(SmallScene(Cut::kClipped), folder_ / "scene"), out = folder_ / "out";
  ASSERT_EQ(Run(scene, out).code, 0);
  const auto tiles = TilesBelow(out);
  folder_.Write("out/mine.txt", "mine");
  folder_.Write("out/tiles/Tile_+000_+000.ply", "older");
  folder_.Write("out/tiles/Tile_+009_+009.ply.txt", "older");
  const Ended again = Run(scene, out, {"--overwrite"});
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_THAT(again.out, HasSubstr("other files and folders there, left as they were: 2"));
  ExpectComplete(out, tiles);
  EXPECT_EQ(FilesBelow(out)["mine.txt"], "mine");
  std::filesystem::remove(out + "/mine.txt");
  EXPECT_THAT(Run(scene, out, {"--overwrite"}).out, HasSubstr("other files and folders there, left as they were: 1"));
}

TEST_F(SceneRunTest, AFolderInATilesPlaceIsRefusedBeforeAnythingIsWritten) {
  const std::string scene = WriteMade(SmallScene(Cut::kClipped), folder_ / "scene"), out = folder_ / "out";
  folder_.Write("out/report.json", "of an older output");
  folder_.Write("out/tiles/Tile_+003_+002.ply/in-the-way", "");
  const auto before = FilesBelow(out);
  const Ended refused = Run(scene, out, {"--overwrite"});
  EXPECT_EQ(refused.code, 4) << refused.err;
  EXPECT_THAT(refused.err, HasSubstr("Tile_+003_+002.ply"));
  EXPECT_EQ(FilesBelow(out), before);
}

TEST_F(SceneRunTest, OfChosenCellsTheOthersAreNoHoles) {
  const std::string scene = WriteMade(SmallScene(Cut::kClipped), folder_ / "scene"), out = folder_ / "out";
  ASSERT_EQ(Run(scene, out, {"--cells", "1,1"}).code, 0);
  const Ended checked = Tilemend({"check", out});
  EXPECT_THAT(checked.out, HasSubstr("        0  holes")) << checked.out;
  EXPECT_THAT(Tilemend({"check", scene, out}).out, HasSubstr("; 1 of 12 tiles were chosen by --cells\n"));
}

TEST_F(SceneRunTest, CheckOfAnOutputNeedsItsReport) {
  const std::string scene = WriteMade(SmallScene(Cut::kClipped), folder_ / "scene"), out = folder_ / "out";
  ASSERT_EQ(Run(scene, out).code, 0);
  for (const char* damaged : {"", "{", "{}", "[]", "null"}) {
    folder_.Write("out/report.json", damaged);
    const Ended checked = Tilemend({"check", out});
    EXPECT_EQ(checked.code, 4) << damaged << checked.out;
    EXPECT_THAT(checked.err, HasSubstr("report.json: not a report"));
  }
  std::filesystem::remove(out + "/report.json");
  EXPECT_EQ(Tilemend({"check", out}).code, 3);
  std::filesystem::create_directory(out + "/report.json");
  EXPECT_EQ(Tilemend({"check", out}).code, 4);
}

TEST_F(SceneRunTest, CheckNamesMissingOtherAndLongerTiles) {
  const std::string scene = WriteMade(SmallScene(Cut::kClipped), folder_ / "scene"), out = folder_ / "out";
  ASSERT_EQ(Run(scene, out).code, 0);
  const Ended whole = Tilemend({"check", out});
  EXPECT_EQ(whole.code, 0) << whole.out;
  folder_.Write("out/tiles/Tile_+009_+000.ply", "");
  const Ended other = Tilemend({"check", out});
  EXPECT_EQ(other.code, 0) << other.out;
  EXPECT_THAT(other.out, HasSubstr("1  other mesh among the tiles (no fault), the first tiles/Tile_+009_+000.ply"));
  const std::string last = out + "/tiles/Tile_+003_+002.ply";
  folder_.Write("out/tiles/Tile_+003_+002.ply", ReadFile(last).value_or("") + "more");
  const Ended longer = Tilemend({"check", out, "-o", "json"});
  EXPECT_EQ(longer.code, 100);
  EXPECT_THAT(Json::parse(longer.out, nullptr, false)["longer_files"]["files"], Json({last}));
  std::filesystem::remove(last);
  const Ended missing = Tilemend({"check", out});
  EXPECT_EQ(missing.code, 100);
  EXPECT_THAT(missing.out, HasSubstr("1  missing tile, the first tiles/Tile_+003_+002.ply"));
}

TEST_F(SceneRunTest, CheckKnowsTheAreaThatWasFilled) {
  const std::string scene = WriteMade(SmallScene(Cut::kClipped), folder_ / "scene"), out = folder_ / "out";
  const std::string area = folder_.Write(
      "area.geojson", R"({"type": "Polygon", "coordinates": [[[7, 5], [71, 6], [73, 55], [6, 52], [7, 5]]]})");
  ASSERT_EQ(Run(scene, out, {"--area", area}).code, 0);
  const Ended checked = Tilemend({"check", out});
  EXPECT_THAT(checked.out, HasSubstr("        0  holes")) << checked.out;
  std::filesystem::remove(area);
  EXPECT_THAT(Tilemend({"check", out}).err, HasSubstr("checked without the area"));
}

TEST_F(SceneRunTest, AnInterruptedOutputIsCompletedByTheSameCommandOnly) {
  SceneMakerOptions options = SmallScene(Cut::kClipped);
  options.cols = options.rows = 16;
  const std::string scene = WriteMade(options, folder_ / "scene"), out = folder_ / "out";
  ASSERT_EQ(Run(scene, folder_ / "whole").code, 0);
  ASSERT_TRUE(KilledWhileItWrites(scene, out));
  EXPECT_THAT(Tilemend({"report", out}).err, HasSubstr("not complete"));
  const std::string kept = folder_.Write("out/kept.json", R"({"cells": 1})");
  EXPECT_EQ(Tilemend({"report", kept}).code, 0);
  std::filesystem::remove(kept);
  EXPECT_EQ(Run(scene, out, {"--uniform"}).code, 4);
  const Ended again = Run(scene, out);
  EXPECT_EQ(again.code, 0) << again.err;
  ExpectComplete(out, TilesBelow(folder_ / "whole"));
  EXPECT_EQ(FilesBelow(out).size(), 263U)
      << "256 tiles, the scene, the report and its page, holes (twice) and breaklines, results";
}

// Whenever it comes: the output is complete, or it can be completed, or there is none.
TEST_F(SceneRunTest, ASignalEndsARunCleanly) {
  SceneMakerOptions options = SmallScene(Cut::kClipped);
  options.cols = options.rows = 8;
  const std::string scene = WriteMade(options, folder_ / "scene"), out = folder_ / "out";
  ASSERT_EQ(Run(scene, folder_ / "whole").code, 0);
  for (const auto& [number, phase] : {std::pair(SIGINT, "look at the tiles"), {SIGTERM, "write the tiles"}}) {
    Process process(folder_.path(), TILEMEND_CLIENT, {"run", scene, "--out", out, "--work", folder_ / "work"});
    process.AwaitLine(phase);
    process.Signal(number);
    const Ended ended = process.Wait();
    EXPECT_TRUE(ended.code == 7 || ended.code == 0) << ended.code << ended.err;
    EXPECT_THAT(FilesBelow(folder_ / "work"), IsEmpty());
    if (ended.code == 7) {
      EXPECT_EQ(Run(scene, out).code, 0);
    }
    ExpectComplete(out, TilesBelow(folder_ / "whole"));
    std::filesystem::remove_all(out);
  }
}

TEST_F(SceneRunTest, ASecondRunToOneOutputIsToldToWait) {
  const std::string scene = WriteMade(SmallScene(Cut::kClipped), folder_ / "scene"), out = folder_ / "out";
  Process first(folder_.path(), TILEMEND_CLIENT, {"run", scene, "--out", out});
  Process second(folder_.path(), TILEMEND_CLIENT, {"run", scene, "--out", out});
  const Ended a = first.Wait(), b = second.Wait();
  const std::string both = absl::StrCat(a.code, " ", b.code, "\n", a.err, b.err);
  EXPECT_TRUE(a.code == 0 || b.code == 0) << both;
  for (const int code : {a.code, b.code}) EXPECT_TRUE(code == 0 || code == 5 || code == 4) << both;
  EXPECT_FALSE(a.code == 0 && b.code == 0) << both;
  EXPECT_EQ(TilesBelow(out).size(), 12U);
}

// A tile that is stored in pieces, as leaves of a tree in a map's frame are in that of a tileset.
TEST_F(SceneRunTest, PondsOverPiecesOfOneTileAreClosed) {
  const SurveyedScene made = TurnedPiecesScene(0.1, 0.0178);
  folder_.Write("scene/tiles/Tile_+000_+000.ply", PlyBytes(made.tiles.begin()->second));
  const Json tile = {{"col", 0}, {"row", 0}, {"path", "tiles/Tile_+000_+000.ply"}};
  const Json scene = {{"crs", "EPSG:25832"}, {"origin", {0, 0, 0}}, {"cell_size", 50}, {"cols", 1},
                      {"rows", 1},           {"overlap", 0},        {"tiles", {tile}}, {"area_known", false}};
  folder_.Write("scene/scene.json", scene.dump());
  const Ended ended = Run(folder_ / "scene", folder_ / "out", {"-o", "json"});
  EXPECT_EQ(ended.code, 0) << ended.out << ended.err;
  const Json report = Json::parse(*ReadFile(folder_ / "out/report.json"));
  EXPECT_EQ(report["filled"]["closed"], 2) << report["filled"];
  // The pieces are flat: where they overlap the fill touches them, which counts as crossing.
  const Json check = Json::parse(Tilemend({"check", folder_ / "scene", folder_ / "out", "-o", "json"}).out);
  for (const char* finding : {"open_edges", "nonmanifold_edges", "missing_faces"}) {
    EXPECT_EQ(check["findings"][finding]["count"], 0) << finding;
  }
  // An area beyond the cell: then there are cells without a tile, and a hole around the pieces.
  const Json ring = {{-1, -1}, {51, -1}, {51, 51}, {-1, 51}, {-1, -1}};
  folder_.Write("area.geojson", Json{{"type", "Polygon"}, {"coordinates", {ring}}}.dump());
  EXPECT_EQ(Run(folder_ / "scene", folder_ / "all", {"--area", folder_ / "area.geojson"}).code, 0);
  const Json all = Json::parse(*ReadFile(folder_ / "all/report.json"));
  EXPECT_EQ(all["filled"]["closed"], 2);
  EXPECT_EQ(all["left"].size(), 0U) << all["left"];
}

TEST_F(SceneRunTest, InspectWritesNothing) {
  const std::string scene = WriteMade(SmallScene(Cut::kRagged), folder_ / "scene/s");
  const auto before = FilesBelow(folder_ / "scene");
  for (const char* format : {"json", "table"}) {
    EXPECT_EQ(Tilemend({"inspect", scene, "-o", format}).code, 0);
    EXPECT_EQ(Tilemend({"inspect", scene + "/tiles/Tile_+000_+000.ply", "-o", format}).code, 0);
  }
  EXPECT_EQ(FilesBelow(folder_ / "scene"), before);
}

TEST_F(SceneRunTest, ADryRunWritesNothing) {
  const std::string scene = WriteMade(SmallScene(Cut::kClipped), folder_ / "scene");
  const Ended ended = Run(scene, folder_ / "out", {"--dry-run", "-o", "json"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(Json::parse(ended.out, nullptr, false).value("message", ""), HasSubstr("holes found"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
}

}  // namespace
}  // namespace tilemend
