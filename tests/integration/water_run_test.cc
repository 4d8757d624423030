// Water from the command line: `run`, `fill`, `inspect` and `report` on a lake over nine cells.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "absl/strings/str_format.h"
#include "tests/support/output_checks.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/water_scenes.h"

namespace tilemend {
namespace {

using ::testing::AllOf;
using ::testing::DoubleNear;
using ::testing::Each;
using ::testing::Gt;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::SizeIs;
using Json = nlohmann::json;

constexpr char kEverywhere[] = R"({"type": "Feature", "properties": {"water": WATER}, "geometry": {"type": "Polygon",
  "coordinates": [[[0, 0], [120, 0], [120, 120], [0, 120], [0, 0]]]}})";

class WaterRunTest : public ::testing::Test {
 protected:
  Ended Tilemend(const std::vector<std::string>& words) {
    return Process(folder_.path(), TILEMEND_CLIENT, words).Wait();
  }
  // The report of a run on `scene`, with further flags.
  Json Run(const std::string& scene, const std::string& out, const std::vector<std::string>& more = {}) {
    std::vector<std::string> words = {"run", scene, "--out", out};
    words.insert(words.end(), more.begin(), more.end());
    const Ended ended = Tilemend(words);
    EXPECT_EQ(ended.code, 0) << ended.err;
    return ReportOf(out);
  }
  std::string Everywhere(const std::string& water) {
    std::string text = kEverywhere;
    text.replace(text.find("WATER"), 5, water);
    return folder_.Write("areas.geojson", text);
  }

  TemporaryFolder folder_;
};

// The vertices of `filled` after those of `original`.
std::vector<Point3> NewVertices(const std::string& original, const std::string& filled) {
  const auto before = ReadMeshFile(original), after = ReadMeshFile(filled);
  EXPECT_TRUE(before.ok() && after.ok()) << before.status() << after.status();
  return {after->mesh.points.begin() + std::ssize(before->mesh.points), after->mesh.points.end()};
}

// Of all tiles of an output: the heights of vertices that no tile of the scene has.
std::vector<double> HeightsOfNewVertices(const std::string& scene, const std::string& out) {
  std::set<std::array<double, 3>> old;
  const auto vertices = [](const std::string& folder, const auto& visit) {
    for (const auto& [name, bytes] : TilesBelow(folder)) {
      const auto file = ParseMesh(MeshFormat::kPly, bytes, name);
      ASSERT_TRUE(file.ok()) << file.status();
      for (const Point3& p : file->mesh.points) visit(p);
    }
  };
  vertices(scene, [&](const Point3& p) { old.insert({p.x(), p.y(), p.z()}); });
  std::vector<double> heights;
  vertices(out, [&](const Point3& p) {
    if (!old.contains({p.x(), p.y(), p.z()})) heights.push_back(p.z());
  });
  return heights;
}

class WaterSurfaceTest : public WaterRunTest, public ::testing::WithParamInterface<std::tuple<Cut, const char*>> {};

TEST_P(WaterSurfaceTest, ALakeOverNineCellsIsFlat) {
  const auto [cut, surface] = GetParam();
  const SceneMakerOptions options = LakeOverNineCells(cut);
  const std::string scene = WriteMade(options, folder_ / "scene"), out = folder_ / "out";
  const Json report = Run(scene, out, {"--surface", surface});
  ASSERT_THAT(report["water"], SizeIs(1));
  const Json& lake = report["water"][0];
  const double level = lake["level_m"];
  EXPECT_NEAR(level, kWaterLevel, 0.03);
  EXPECT_EQ(lake["cells"], 9);
  EXPECT_EQ(lake["cluster"], 0);
  EXPECT_EQ(lake["decided_by"], "rim");
  EXPECT_LT(lake["sigma_m"], 0.06);
  EXPECT_NEAR(lake["area_m2"], 3.14159 * 52 * 47, 200);
  for (const Json& hole : report["per_hole"]) EXPECT_EQ(hole["method"], "water");
  EXPECT_THAT(HeightsOfNewVertices(scene, out), AllOf(SizeIs(Gt(50)), Each(level)));
  ExpectOriginalsKept(scene, out);
  ExpectClosed(options, out);
  Run(scene, folder_ / "three", {"--surface", surface, "--workers", "3"});
  EXPECT_EQ(TilesBelow(folder_ / "three"), TilesBelow(out));
}

INSTANTIATE_TEST_SUITE_P(Surfaces, WaterSurfaceTest,
                         ::testing::Combine(::testing::Values(Cut::kClipped, Cut::kRagged),
                                            ::testing::Values("wang", "thin-plate")),
                         [](const auto& test) {
                           return NameOf(std::get<0>(test.param)) +
                                  (std::string(std::get<1>(test.param)) == "wang" ? "Wang" : "ThinPlate");
                         });

class AreaOnGridLineTest : public WaterRunTest {
 protected:
  // The lake in the area, whose polygon has these coordinates, has its level all over.
  void ExpectFlat(const std::string& scene, const std::string& area) {
    const std::string text = absl::StrCat(R"({"type": "Polygon", "coordinates": )", area, "}"), out = folder_ / "out";
    const Json report = Run(scene, out, {"--overwrite", "--area", folder_.Write("area.geojson", text)});
    ASSERT_THAT(report["water"], SizeIs(Gt(0))) << area;
    for (const Json& hole : report["per_hole"]) EXPECT_EQ(hole["method"], "water") << area;
    EXPECT_THAT(HeightsOfNewVertices(scene, out), AllOf(SizeIs(Gt(20)), Each(DoubleNear(kWaterLevel, 0.05)))) << area;
  }
};
class AreaOnGridLineOfCutTest : public AreaOnGridLineTest, public ::testing::WithParamInterface<Cut> {};

// The cells have 40 m.
TEST_P(AreaOnGridLineOfCutTest, ALakeThatItCutsKeepsItsLevel) {
  const std::string scene = WriteMade(LakeOverNineCells(GetParam()), folder_ / "scene");
  for (const char* area : {"[[0,40],[120,40],[120,120],[0,120],[0,40]]", "[[0,0],[80,0],[80,120],[0,120],[0,0]]",
                           "[[0,40],[40,40],[40,0],[120,0],[120,120],[0,120],[0,40]]",
                           // Across a line at a small angle.
                           "[[0,39.999],[120,40.001],[120,120],[0,120],[0,39.999]]",
                           "[[0,40.0004],[40.0004,40],[40,0],[120,0],[120,120],[0,120],[0,40.0004]]"}) {
    ExpectFlat(scene, absl::StrCat("[", area, "]"));
  }
}

// On other cuts a hole is filled over such a part.
TEST_F(AreaOnGridLineTest, WhatItLeavesOutMayMeetAtACornerOfTheGrid) {
  const std::string scene = WriteMade(LakeOverNineCells(Cut::kOverlap), folder_ / "scene");
  for (const char* rings : {"[[30,30],[40,30],[40,40],[30,40],[30,30]],[[40,40],[50,40],[50,50],[40,50],[40,40]]",
                            "[[40,40],[80,40],[80,80],[40,80],[40,40]],[[80,80],[90,80],[90,90],[80,90],[80,80]]"}) {
    ExpectFlat(scene, absl::StrCat("[[[0,0],[120,0],[120,120],[0,120],[0,0]],", rings, "]"));
  }
}

INSTANTIATE_TEST_SUITE_P(Cuts, AreaOnGridLineOfCutTest, ::testing::Values(Cut::kClipped, Cut::kRagged, Cut::kOverlap),
                         [](const auto& test) { return NameOf(test.param); });

class AreaBeyondSceneTest : public WaterRunTest, public ::testing::WithParamInterface<std::tuple<Cut, const char*>> {};

// The lake goes on to the rim of the scene, and the hole around the scene into it.
TEST_P(AreaBeyondSceneTest, TheWaterIsThatOfTheScene) {
  const auto [cut, surface] = GetParam();
  SceneMakerOptions options = LakeOverNineCells(cut);
  options.ellipses[0].centre.x() = 0;
  options.terrain = [](double x, double y) {
    return kWaterLevel + 0.1 * std::max(0.0, std::hypot(x / 52, (y - 59) / 47) - 1) * 49;
  };
  const std::string scene = WriteMade(options, folder_ / "scene"), out = folder_ / "out";
  const Json known = Run(scene, folder_ / "whole", {"--surface", surface});
  ASSERT_THAT(known["water"], SizeIs(1));
  const std::string area = folder_.Write(
      "area.geojson", R"({"type": "Polygon", "coordinates": [[[-8,-8],[128,-8],[128,128],[-8,128],[-8,-8]]]})");
  const Json report = Run(scene, out, {"--surface", surface, "--area", area});
  ASSERT_THAT(report["water"], SizeIs(1));
  const double level = known["water"][0]["level_m"];
  EXPECT_EQ(report["water"][0]["level_m"], level);
  EXPECT_NEAR(report["water"][0]["area_m2"].get<double>(), known["water"][0]["area_m2"].get<double>(), 1);
  EXPECT_THAT(report["left"], SizeIs(0));
  ExpectOriginalsKept(scene, out);
  Run(scene, folder_ / "three", {"--surface", surface, "--area", area, "--workers", "3"});
  EXPECT_EQ(TilesBelow(folder_ / "three"), TilesBelow(out));
}

INSTANTIATE_TEST_SUITE_P(Surfaces, AreaBeyondSceneTest,
                         ::testing::Combine(::testing::Values(Cut::kClipped, Cut::kRagged, Cut::kOverlap),
                                            ::testing::Values("wang", "thin-plate")),
                         [](const auto& test) {
                           return NameOf(std::get<0>(test.param)) +
                                  (std::string(std::get<1>(test.param)) == "wang" ? "Wang" : "ThinPlate");
                         });

TEST_F(WaterRunTest, OffAndAreasDecide) {
  const std::string scene = WriteMade(LakeOverNineCells(Cut::kClipped), folder_ / "scene");
  const Json off = Run(scene, folder_ / "off", {"--water", "off"});
  EXPECT_THAT(off["water"], SizeIs(0));
  EXPECT_EQ(off["per_hole"][0]["method"], "over the ground");
  const Json forbidden = Run(scene, folder_ / "forbidden", {"--water", Everywhere("false")});
  EXPECT_THAT(forbidden["water"], SizeIs(0));
  EXPECT_EQ(TilesBelow(folder_ / "forbidden"), TilesBelow(folder_ / "off"));
  const SceneMakerOptions hills =
      HoleOverNineCells(Cut::kClipped, [](double, double x, double y) { return 0.1 * x - 0.05 * y; });
  const std::string slope = WriteMade(hills, folder_ / "slope");
  EXPECT_THAT(Run(slope, folder_ / "slope_found")["water"], SizeIs(0));
  const Json forced = Run(slope, folder_ / "slope_forced", {"--water", Everywhere("true")});
  ASSERT_THAT(forced["water"], SizeIs(1));
  EXPECT_EQ(forced["water"][0]["decided_by"], "area");
  ExpectClosed(hills, folder_ / "slope_forced");
}

TEST_F(WaterRunTest, AnAreaThatDecidesNothingIsAWarning) {
  const std::string scene = WriteMade(LakeOverNineCells(Cut::kClipped), folder_ / "scene");
  const std::string areas = folder_.Write(
      "elsewhere.geojson",
      R"({"type": "Polygon", "coordinates": [[[116.3, 39.9], [116.4, 39.9], [116.4, 40], [116.3, 39.9]]]})");
  const Json report = Run(scene, folder_ / "out", {"--water", areas});
  ASSERT_THAT(report["warnings"], SizeIs(1));
  EXPECT_THAT(report["warnings"][0].get<std::string>(), HasSubstr("feature 0 is not taken"));
  EXPECT_THAT(report["water_areas"], SizeIs(1));
  EXPECT_THAT(Tilemend({"inspect", scene, "--water", areas}).err, HasSubstr("feature 0 is not taken"));
}

TEST_F(WaterRunTest, ABadFileIsNamedWithItsPlaceAndNothingIsWritten) {
  const std::string scene = WriteMade(LakeOverNineCells(Cut::kClipped), folder_ / "scene");
  const std::string mesh = scene + "/tiles/Tile_+000_+000.ply", out = folder_ / "out";
  const std::string areas = folder_.Write("bad.geojson", R"({"type": "Polygon", "coordinates": [[[0, 0], [1, 1]]]})");
  const std::vector<std::vector<std::string>> commands = {
      {"run", scene, "--out", out}, {"inspect", scene}, {"inspect", mesh}, {"fill", mesh, "--out", out + ".ply"}};
  for (std::vector<std::string> words : commands) {
    words.insert(words.end(), {"--water", areas});
    const Ended bad = Tilemend(words);
    EXPECT_EQ(bad.code, 4) << words[0];
    EXPECT_THAT(bad.err, HasSubstr(areas + ": feature 0, ring 0: expected a ring of at least 4 positions"));
    words.back() = folder_ / "none.geojson";
    const Ended none = Tilemend(words);
    EXPECT_EQ(none.code, 3) << words[0];
    EXPECT_THAT(none.err, HasSubstr("none.geojson"));
    words.insert(words.end(), {"--water-tolerance", "0.2"});
    EXPECT_EQ(Tilemend(words).code, 2) << words[0] << ": there is no such option any more";
  }
  EXPECT_FALSE(std::filesystem::exists(out));
  EXPECT_FALSE(std::filesystem::exists(out + ".ply"));
}

TEST_F(WaterRunTest, InspectAndReportTellOfIt) {
  const std::string scene = WriteMade(LakeOverNineCells(Cut::kRagged), folder_ / "scene"), out = folder_ / "out";
  const Json report = Run(scene, out);
  const std::string level = absl::StrFormat("%.3f", report["water"][0]["level_m"].get<double>());
  const Ended inspected = Tilemend({"inspect", scene});
  EXPECT_THAT(inspected.out, HasSubstr("1 to fill flat as water"));
  EXPECT_THAT(inspected.out, HasSubstr(level));
  EXPECT_THAT(Tilemend({"inspect", scene, "--water", "off"}).out, Not(HasSubstr("flat as water")));
  EXPECT_EQ(Json::parse(Tilemend({"inspect", scene, "-o", "json"}).out)["water"], report["water"]);
  const Ended shown = Tilemend({"report", out});
  EXPECT_THAT(shown.out, HasSubstr("1 filled flat as water"));
  EXPECT_THAT(shown.out, HasSubstr(level));
}

// A mesh on its own need not be terrain, so that it takes the flag.
TEST_F(WaterRunTest, FillMakesAPondFlatWhenAskedTo) {
  SceneMakerOptions options = LakeOverNineCells(Cut::kClipped);
  const std::string mesh = folder_.Write("in.ply", PlyBytes(MergeTiles(MakeScene(options))));
  const Ended ended = Tilemend({"fill", mesh, "--out", folder_ / "water.ply", "--water", "auto", "-o", "json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const Json report = Json::parse(ended.out);
  ASSERT_THAT(report["water"], SizeIs(1));
  EXPECT_FALSE(report["water"][0].contains("cluster"));
  const std::vector<Point3> flat = NewVertices(mesh, folder_ / "water.ply");
  EXPECT_FALSE(flat.empty());
  for (const Point3& p : flat) EXPECT_EQ(p.z(), report["water"][0]["level_m"].get<double>());
  ASSERT_EQ(Tilemend({"fill", mesh, "--out", folder_ / "surface.ply"}).code, 0);
  const std::vector<Point3> surface = NewVertices(mesh, folder_ / "surface.ply");
  EXPECT_TRUE(std::any_of(surface.begin(), surface.end(), [&](const Point3& p) { return p.z() != surface[0].z(); }));
}

}  // namespace
}  // namespace tilemend
