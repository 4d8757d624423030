// From a run to a delivery: the acceptance check finds each kind of damage, a second run finds nothing to do, and the
// page of the report is there.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_replace.h"
#include "tests/support/mesh_builders.h"
#include "tests/support/output_checks.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/textured_scene.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;
using Json = nlohmann::json;

constexpr char kTile[] = "out/Data/Tile_+000_+000/Tile_+000_+000.obj";

class DeliveryRunTest : public ::testing::Test {
 protected:
  void SetUp() override {
    WriteTexturedScene(folder_);
    const Ended ended = Tilemend({"run", folder_ / "scene", "--out", folder_ / "out"});
    ASSERT_EQ(ended.code, 0) << ended.err;
  }
  Ended Tilemend(const std::vector<std::string>& words) {
    return Process(folder_.path(), TILEMEND_CLIENT, words).Wait();
  }
  // Checks, expects `code`, and gives the findings.
  Json Check(int code) {
    const Ended ended =
        Tilemend({"check", folder_ / "scene", folder_ / "out", "-o", "json", "--csv", folder_ / "a.csv"});
    EXPECT_EQ(ended.code, code) << ended.out << ended.err;
    const Json json = Json::parse(ended.out, nullptr, false);
    EXPECT_EQ(json.value("accepted", code != 0), code == 0);
    return json.value("findings", Json());
  }
  int64_t Count(const Json& findings, const char* kind) { return findings.at(kind).at("count").get<int64_t>(); }
  std::string Read(const std::string& name) { return ReadFile(folder_ / name).value(); }
  // Replaces the last line that begins with `begin`.
  void ChangeLastLine(const std::string& name, const std::string& begin, const std::string& line) {
    const std::string text = Read(name);
    const size_t at = text.rfind("\n" + begin) + 1, end = text.find('\n', at);
    folder_.Write(name, absl::StrCat(text.substr(0, at), line, text.substr(line.empty() ? end + 1 : end)));
  }

  TemporaryFolder folder_;
};

TEST_F(DeliveryRunTest, AnOutputIsAccepted) {
  const Json findings = Check(0);
  for (const auto& [name, finding] : findings.items()) EXPECT_EQ(finding["count"], 0) << name;
  const Ended table = Tilemend({"check", folder_ / "scene", folder_ / "out"});
  EXPECT_EQ(table.code, 0);
  EXPECT_THAT(table.out, StartsWith("accepted: all "));
  EXPECT_THAT(Read("a.csv"), StartsWith("what,fault,column,row,x,y,z,hole,note\r\n"));
}

TEST_F(DeliveryRunTest, AFillLargerThanItsHoleIsFound) {
  Json report = Json::parse(Read("out/report.json"));
  ASSERT_GT(report["per_hole"].size(), 0U);
  for (Json& hole : report["per_hole"]) hole["area_m2"] = 0.00025;
  folder_.Write("out/report.json", report.dump());
  const Json findings = Check(100);
  EXPECT_GT(Count(findings, "fill_areas"), 0);
  EXPECT_THAT(findings["fill_areas"]["places"][0]["note"].get<std::string>(), HasSubstr("cell 0,0: fills of "));
}

// The edges around its holes are none that are new.
TEST_F(DeliveryRunTest, AnOriginalInPlaceOfAFilledTileIsFound) {
  folder_.Write(kTile, Read("scene/Data/Tile_+000_+000/Tile_+000_+000.obj"));
  EXPECT_GT(Count(Check(100), "fill_areas"), 0);
}

TEST_F(DeliveryRunTest, AChangedOriginalIsFoundWithItsPlace) {
  folder_.Write(kTile,
                absl::StrReplaceAll(Read(kTile), {{"v 3.000000 2.000000 0.400000", "v 3.000000 2.000000 0.400001"}}));
  const Json findings = Check(100);
  EXPECT_GT(Count(findings, "missing_faces"), 0);
  EXPECT_EQ(findings["missing_faces"]["places"][0]["cell"], Json({0, 0}));
  EXPECT_THAT(Read("a.csv"), HasSubstr("\r\nmissing_faces,yes,0,0,"));
}

TEST_F(DeliveryRunTest, AnotherMaterialOrTextureCoordinateIsAChange) {
  const std::string text = Read(kTile);
  folder_.Write(kTile, absl::StrReplaceAll(text, {{"vt 0.5 0.5", "vt 0.5 0.6"}}));
  EXPECT_GT(Count(Check(100), "missing_faces"), 0);
  folder_.Write(kTile, absl::StrReplaceAll(text, {{"usemtl ground", "usemtl other"}}));
  EXPECT_GT(Count(Check(100), "missing_faces"), 0);
}

TEST_F(DeliveryRunTest, AFilledTriangleLessOpensTheHole) {
  ChangeLastLine(kTile, "f ", "");
  EXPECT_GT(Count(Check(100), "open_edges"), 0);
}

TEST_F(DeliveryRunTest, ACrackBetweenTilesIsOpen) {
  // Both tiles have the vertices of the seam. One of them is moved in one tile.
  ChangeLastLine(kTile, "v 10 ", "v 10 5.25 0.9");
  EXPECT_GT(Count(Check(100), "open_edges"), 0);
}

// A level tile of squares of 1 m from x on, but for those that are in a hole.
std::string TileFrom(int x, const std::function<bool(int column, int row)>& is_hole) {
  std::string text;
  for (int row = 0; row <= 10; ++row) {
    for (int column = 0; column <= 10; ++column) absl::StrAppend(&text, "v ", x + column, " ", row, " 1\n");
  }
  for (int row = 0; row < 10; ++row) {
    for (int column = 0; column < 10; ++column) {
      if (is_hole(column, row)) continue;
      const int a = 11 * row + column + 1;
      absl::StrAppend(&text, "f ", a, " ", a + 1, " ", a + 12, "\nf ", a, " ", a + 12, " ", a + 11, "\n");
    }
  }
  return text;
}

TEST_F(DeliveryRunTest, APartOfAHoleMayEndAtThePartThatWasLeft) {
  // It goes on into the second cell, and there to the rim of an area that is not known.
  folder_.Write("lake/Tile_+000_+000.obj",
                TileFrom(0, [](int column, int row) { return column >= 7 && row / 2 == 2; }));
  folder_.Write("lake/Tile_+001_+000.obj", TileFrom(10, [](int column, int row) { return column < 3 && row >= 4; }));
  EXPECT_EQ(Tilemend({"run", folder_ / "lake", "--out", folder_ / "lake_out"}).code, 100);
  const Ended check = Tilemend({"check", folder_ / "lake", folder_ / "lake_out"});
  EXPECT_EQ(check.code, 0) << check.err << check.out;
  folder_.Write("lake_out/Tile_+000_+000.obj", Read("lake/Tile_+000_+000.obj"));
  EXPECT_EQ(Tilemend({"check", folder_ / "lake", folder_ / "lake_out"}).code, 100) << "the fill is gone";
}

TEST_F(DeliveryRunTest, AnAreaInsideAHoleHasNoHeight) {
  folder_.Write("lake/Tile_+000_+000.obj", TileFrom(0, [](int column, int row) { return column > 2 && row > 2; }));
  folder_.Write("lake/Tile_+001_+000.obj", TileFrom(10, [](int column, int row) { return column < 7 && row > 2; }));
  const std::string area = folder_.Write(
      "area.geojson", R"({"type": "Polygon", "coordinates": [[[6, 5], [14, 5], [14, 8], [6, 8], [6, 5]]]})");
  EXPECT_EQ(Tilemend({"run", folder_ / "lake", "--out", folder_ / "lake_out", "--area", area}).code, 100);
  EXPECT_THAT(Read("lake_out/report.json"), HasSubstr("nothing tells its height"));
  EXPECT_EQ(Read("lake_out/Tile_+000_+000.obj"), Read("lake/Tile_+000_+000.obj"));
}

TEST_F(DeliveryRunTest, ALostFillIsFoundHoweverSmallItsHoleIs) {
  folder_.Write("two/Tile_+000_+000.obj", TileFrom(0, [](int column, int row) {
                  return (column == 2 && row == 2) || (column >= 4 && column < 8 && row >= 4 && row < 8);
                }));
  folder_.Write("two/Tile_+001_+000.obj", TileFrom(10, [](int, int) { return false; }));
  ASSERT_EQ(Tilemend({"run", folder_ / "two", "--out", folder_ / "two_out"}).code, 0);
  const Ended good = Tilemend({"check", folder_ / "two", folder_ / "two_out"});
  EXPECT_EQ(good.code, 0) << good.err << good.out;
  // The fill of the first hole, 1 m2, is the first of two materials.
  const std::string text = Read("two_out/Tile_+000_+000.obj");
  const size_t first = text.find("usemtl tilemend_fill_"), next = text.find("usemtl ", first + 1);
  ASSERT_NE(next, std::string::npos);
  folder_.Write("two_out/Tile_+000_+000.obj", text.substr(0, first) + text.substr(next));
  const Ended lost = Tilemend({"check", folder_ / "two", folder_ / "two_out"});
  EXPECT_EQ(lost.code, 100);
  EXPECT_THAT(lost.out, HasSubstr("4  new open edges"));
}

TEST_F(DeliveryRunTest, AFilledTriangleTwiceIsNonManifold) {
  const std::string text = Read(kTile);
  const size_t at = text.rfind("\nf ");
  folder_.Write(kTile, absl::StrCat(text, text.substr(at + 1)));
  EXPECT_GT(Count(Check(100), "nonmanifold_edges"), 0);
}

// Two tiles of 10 m that are cut from one mesh, each with a buffer of 1 m, around a hole over the line between them.
TEST_F(DeliveryRunTest, EdgesThatTwoLayersOfABufferShareAreNoFault) {
  const auto is_there = [](int32_t i, int32_t j) { return i < 7 || i > 12 || j < 3 || j > 6; };
  const auto height = [](double x, double y) { return 20 + 0.1 * x + 0.05 * y; };
  for (const int32_t col : {0, 1}) {
    const TriMesh tile = SquaresMesh(9 * col, 11 + 9 * col, 0, 10, is_there, height);
    std::string text;
    for (const Point3& p : tile.points) absl::StrAppend(&text, "v ", p.x(), " ", p.y(), " ", p.z(), "\n");
    for (const Triangle& t : tile.triangles) {
      absl::StrAppend(&text, "f ", t[0] + 1, " ", t[1] + 1, " ", t[2] + 1, "\n");
    }
    folder_.Write(absl::StrCat("buffered/Tile_+00", col, "_+000.obj"), text);
  }
  folder_.Write("buffered/scene.json", R"({"origin": [0, 0, 0], "cell_size": 10, "cols": 2, "rows": 1, "overlap": 1,
    "tiles": [{"col": 0, "row": 0, "path": "Tile_+000_+000.obj"},
              {"col": 1, "row": 0, "path": "Tile_+001_+000.obj"}]})");
  const Ended ended = Tilemend({"run", folder_ / "buffered", "--out", folder_ / "filled", "--check"});
  EXPECT_EQ(ended.code, 0) << ended.out << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("2 of 2 holes filled"));
}

TEST_F(DeliveryRunTest, AnImageMustBeTheSameAndAMaterialFileMayGrow) {
  const std::string image = "out/shared/my ground.jpg";
  folder_.Write(image, Read(image) + " ");
  EXPECT_EQ(Count(Check(100), "changed_files"), 1);
  std::filesystem::remove(folder_ / image);
  EXPECT_EQ(Count(Check(100), "missing_files"), 1);
  folder_.Write(image, Read("scene/shared/my ground.jpg"));
  const std::string library = "out/Data/Tile_+000_+000/Tile_+000_+000.mtl";
  folder_.Write(library, Read(library) + "newmtl more\n");
  Check(0);
  folder_.Write(library, "newmtl more\n");
  EXPECT_EQ(Count(Check(100), "changed_files"), 1);
}

TEST_F(DeliveryRunTest, NoMaterialIsDefinedAgain) {
  const std::string library = "out/Data/Tile_+000_+000/Tile_+000_+000.mtl", text = Read(library);
  const size_t name = text.find("newmtl ");
  ASSERT_NE(name, std::string::npos);
  folder_.Write(library, absl::StrCat(text, text.substr(name, text.find('\n', name) + 1 - name), "Kd 1 0 0\n"));
  EXPECT_EQ(Count(Check(100), "changed_files"), 1);
}

TEST_F(DeliveryRunTest, MaterialFilesKeepTheirNames) {
  const std::string text = Read(kTile);
  const size_t at = text.find("mtllib ");
  ASSERT_NE(at, std::string::npos);
  folder_.Write(kTile, text.substr(0, at) + text.substr(text.find('\n', at) + 1));
  EXPECT_EQ(Count(Check(100), "changed_files"), 1);
}

TEST_F(DeliveryRunTest, ImagesOfFillsMustBeThere) {
  std::filesystem::remove_all(folder_ / "scene");
  std::filesystem::remove_all(folder_ / "out");
  WriteImageScene(folder_);
  ASSERT_EQ(Tilemend({"run", folder_ / "scene", "--out", folder_ / "out"}).code, 0);
  Check(0);
  const std::string image = Read("out/T0_tilemend.jpg");
  folder_.Write("out/T0_tilemend.jpg", "");
  EXPECT_EQ(Count(Check(100), "fill_textures"), 1) << "it cannot be read";
  folder_.Write("out/T0_tilemend.jpg", image);
  ASSERT_TRUE(std::filesystem::remove(folder_ / "out/T0_tilemend.jpg"));
  EXPECT_EQ(Count(Check(100), "missing_files"), 1);
}

TEST_F(DeliveryRunTest, AMissingTileIsNamed) {
  std::filesystem::remove(folder_ / kTile);
  EXPECT_EQ(Count(Check(100), "missing_tiles"), 1);
}

TEST_F(DeliveryRunTest, ARunCanCheckItsOutput) {
  const Ended accepted = Tilemend({"run", folder_ / "scene", "--out", folder_ / "checked", "--check"});
  EXPECT_EQ(accepted.code, 0) << accepted.err;
  EXPECT_THAT(accepted.out, HasSubstr("\naccepted: all "));
  EXPECT_EQ(Json::parse(Read("checked/acceptance.json"))["accepted"], true);
  EXPECT_THAT(Read("checked/report.html"), HasSubstr("\"verdict\":\"accepted: all "));
  const Ended again = Tilemend({"run", folder_ / "scene", "--out", folder_ / "checked", "--overwrite"});
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_FALSE(ReadFile(folder_ / "checked/acceptance.json").ok()) << "it was of the output before";
  const Ended refused = Tilemend({"run", folder_ / "scene", "--out", folder_ / "other", "--check", "--dry-run"});
  EXPECT_EQ(refused.code, 2) << refused.err;
  EXPECT_THAT(refused.err, HasSubstr("run: --check "));
}

TEST_F(DeliveryRunTest, ACheckCanShowItsVerdictOnThePage) {
  ChangeLastLine(kTile, "f ", "");
  const Ended ended = Tilemend({"check", folder_ / "scene", folder_ / "out", "--page"});
  EXPECT_EQ(ended.code, 100) << ended.err;
  EXPECT_THAT(Read("out/report.html"), HasSubstr("\"verdict\":\"not accepted: "));
  const Ended no_output = Tilemend({"check", folder_ / "scene", "--page"});
  EXPECT_EQ(no_output.code, 2);
  EXPECT_THAT(no_output.err, HasSubstr("check: --page needs a scene and an output"));
}

TEST_F(DeliveryRunTest, ASecondRunFindsNothingToDo) {
  ASSERT_EQ(Tilemend({"run", folder_ / "out", "--out", folder_ / "again"}).code, 0);
  const Json report = ReportOf(folder_ / "again");
  EXPECT_EQ(report["per_hole"].size(), 0U) << report["per_hole"].dump();
  for (const char* tile : {"Tile_+000_+000", "Tile_+001_+000"}) {
    const std::string path = absl::StrCat("/Data/", tile, "/", tile, ".obj");
    EXPECT_EQ(Read("out" + path), Read("again" + path));
  }
  EXPECT_EQ(Tilemend({"check", folder_ / "out", folder_ / "again"}).code, 0);
}

TEST_F(DeliveryRunTest, ACheckSaysThatTheOutputIsOfAnotherScene) {
  std::filesystem::create_directory_symlink(folder_ / "scene", folder_ / "link");
  EXPECT_THAT(Tilemend({"check", folder_ / "link", folder_ / "out"}).err, testing::Not(HasSubstr("was made from")));
  std::filesystem::copy(folder_ / "scene", folder_ / "moved", std::filesystem::copy_options::recursive);
  const Ended moved = Tilemend({"check", folder_ / "moved", folder_ / "out"});
  EXPECT_EQ(moved.code, 0) << moved.err;
  EXPECT_THAT(moved.err, HasSubstr("out/report.json: the output was made from the scene " + (folder_ / "scene") +
                                   ", and is compared with " + (folder_ / "moved") + ";"));
}

TEST_F(DeliveryRunTest, WhatIsNoOutputIsRefused) {
  EXPECT_EQ(Tilemend({"check", folder_ / "scene", folder_ / "nowhere"}).code, 3);
  EXPECT_EQ(Tilemend({"check", folder_ / "nowhere", folder_ / "out"}).code, 3);
  folder_.Write("out/report.json", "[]");
  EXPECT_EQ(Tilemend({"check", folder_ / "scene", folder_ / "out"}).code, 4);
  EXPECT_EQ(Tilemend({"check", folder_ / "scene", "--csv", folder_ / "a.csv"}).code, 2);
  EXPECT_EQ(Tilemend({"check", "a", "b", "c"}).code, 2);
}

TEST_F(DeliveryRunTest, ThePageIsWrittenByRunAndAgainByReport) {
  const std::string page = Read("out/report.html");
  EXPECT_THAT(page, StartsWith("<!doctype html>"));
  EXPECT_THAT(page, HasSubstr("\"pictures\":[{\"hole\":"));
  EXPECT_THAT(Read("out/holes.csv"), StartsWith("id,"));
  std::filesystem::remove(folder_ / "out/report.html");
  EXPECT_EQ(Tilemend({"report", folder_ / "out", "--html"}).code, 0);
  EXPECT_EQ(Read("out/report.html"), page);
  std::filesystem::remove_all(folder_ / "scene");
  EXPECT_EQ(Tilemend({"report", folder_ / "out", "--html"}).code, 0);
  EXPECT_THAT(Read("out/report.html"), HasSubstr("No pictures: "));
}

}  // namespace
}  // namespace tilemend
