#include "client/area_rim.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "client/acceptance_kinds.h"
#include "client/acceptance_text.h"
#include "client/carried_files.h"
#include "client/original_rims.h"
#include "client/water_seams.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

Scene TwoCells() {
  Scene scene;
  scene.grid.cell_size = {10, 10};
  scene.tiles = {{{0, 0}, "a.obj"}, {{1, 0}, "b.obj"}};
  return scene;
}

TEST(AreaRimTest, SidesWithoutANeighbourAreTheRim) {
  const AreaRim rim(TwoCells(), 0);
  EXPECT_TRUE(rim.HasEdge({0, 0}, {3, 0, 5}, {4, 0, 5}));
  EXPECT_FALSE(rim.HasEdge({0, 0}, {10, 3, 5}, {10, 4, 5}));
  EXPECT_FALSE(rim.HasEdge({0, 0}, {5, 5, 5}, {6, 5, 5}));
}

TEST(AreaRimTest, NewVerticesLieOnTheRim) {
  const AreaRim rim(TwoCells(), 0), overlapping(TwoCells(), 0.1);
  const Point3 off(3, 0.5, 5), on(4, 0, 5);
  EXPECT_TRUE(rim.HasEdge({0, 0}, off, on));
  EXPECT_TRUE(rim.HasEdge({0, 0}, off, on, {true, false}));
  EXPECT_FALSE(rim.HasEdge({0, 0}, off, on, {false, true}));
  EXPECT_TRUE(overlapping.HasEdge({0, 0}, off, on, {false, true}));
}

TEST(OriginalRimsTest, KnowsVerticesUntilTheirRowsArePast) {
  OriginalRims rims;
  const Point3 a(0, 0, 1), b(1, 0, 1), c(2, 0, 1);
  rims.Add(0, {{a, b, 1, 2, true}, {b, c, 0, 1, true}});
  EXPECT_TRUE(rims.EndsOf({b, c, 0, 1, true}).from);
  EXPECT_FALSE(rims.EndsOf({b, c, 0, 1, true}).to);
  EXPECT_TRUE(rims.EndsOf({b, c, 0, 1, false}).to) << "of an original triangle";
  rims.Add(1, {{a, c, 1, 1, false}});
  rims.ForgetBelow(1);
  EXPECT_TRUE(rims.EndsOf({a, c, 0, 1, true}).to);
  EXPECT_FALSE(rims.EndsOf({a, b, 0, 1, true}).to);
}

TEST(WaterSeamsTest, VerticesOfTwoTilesThatTheSceneDoesNotHave) {
  const Point3 shore(0, 0, 1), seam(1, 0, 1), single(2, 0, 1);
  OriginalRims rims;
  rims.Add(1, {{shore, single, 1, 1, false}});
  WaterSeams seams;
  seams.Add({0, 0}, {shore, seam, {3, 0, 1}});
  seams.Add({0, 0}, {{3, 0, 1}});
  seams.Add({0, 1}, {shore, seam});
  EXPECT_TRUE(seams.ReleaseBelow(1, rims).empty()) << "tiles in row 2 are not read";
  const auto places = seams.ReleaseBelow(2, rims);
  ASSERT_EQ(places.size(), 1U);
  EXPECT_EQ(places[0].at, seam);
  EXPECT_TRUE(seams.ReleaseBelow(2, rims).empty());
}

TEST(AreaRimTest, TheOutlineOfThePolygonIsTheRim) {
  Scene scene = TwoCells();
  scene.area.rings = {{{2, 2}, {8, 2}, {8, 8}, {2, 8}}};
  EXPECT_TRUE(AreaRim(scene, 0).HasEdge({0, 0}, {8, 3, 1}, {8, 4, 1}));
  EXPECT_FALSE(AreaRim(scene, 0).HasEdge({0, 0}, {5, 5, 1}, {5.5, 5, 1}));
}

TEST(AreaRimTest, NeighboursAreThoseWithinReach) {
  const AreaRim rim(TwoCells(), 0.1);
  EXPECT_THAT(rim.NeighboursAt({0, 0}, {9.95, 5, 0}), ElementsAre(CellId{1, 0}));
  EXPECT_THAT(rim.NeighboursAt({0, 0}, {9.5, 5, 0}), testing::IsEmpty());
}

TEST(CarriedFilesTest, MaterialsAreDefinedOnce) {
  EXPECT_FALSE(DefinesAgain("newmtl a\nnewmtl a\n", "newmtl a\nnewmtl a\nnewmtl b\nnewmtl b\n"));
  EXPECT_FALSE(DefinesAgain("", "newmtl a\nnewmtl a\n"));
  EXPECT_TRUE(DefinesAgain("newmtl a\nKd 1 1 1\n", "newmtl a\nKd 1 1 1\nnewmtl a\nKd 1 0 0\n"));
}

TEST(CarriedFilesTest, MaterialFilesMayBeLongerAndImagesMayNot) {
  const TemporaryFolder folder;
  folder.Write("in/a.mtl", "newmtl a\n");
  folder.Write("out/a.mtl", "newmtl a\nnewmtl b\n");
  folder.Write("in/a.jpg", "abc");
  folder.Write("out/a.jpg", "abcd");
  folder.Write("in/b.jpg", std::string(70000, 'x'));
  folder.Write("out/b.jpg", std::string(69999, 'x') + "y");
  folder.Write("in/c.jpg", "c");
  folder.Write("in/d.jpg", std::string(1 << 16, 'd'));
  folder.Write("out/d.jpg", std::string(1 << 16, 'd'));
  CarriedFiles files(folder / "in", folder / "out");
  files.Compare({{"a.mtl"}, {"a.jpg", "b.jpg", "c.jpg", "d.jpg"}, {}});
  files.Compare({{"a.mtl"}, {"c.jpg"}, {}});
  EXPECT_THAT(files.changed(), ElementsAre("a.jpg", "b.jpg"));
  EXPECT_THAT(files.missing(), ElementsAre("c.jpg"));
  EXPECT_EQ(files.compared(), 5U);
}

TEST(AcceptanceTextTest, TheVerdictNamesTheFaultsAlone) {
  Acceptance acceptance;
  acceptance.findings = {
      {"open_edges", "new open edge", "new open edges", true, 2, {{{1, 2}, Point3(3, 4, 5), "", 20}}},
      {"left_holes", "hole left open, as reported", "holes left open, as reported", false, 4, {}}};
  EXPECT_EQ(VerdictOf(acceptance), "not accepted: 2 new open edges");
  EXPECT_THAT(AcceptanceText(acceptance), HasSubstr("[3.00,4.00,5.00] in cell 1,2, hole 20\n             and 1 more"));
  EXPECT_THAT(AcceptanceCsv(acceptance), HasSubstr("open_edges,yes,1,2,3.0000,4.0000,5.0000,20,\r\n"));
  EXPECT_EQ(AcceptanceJson(acceptance)["findings"]["open_edges"]["places"][0]["cell"], nlohmann::ordered_json({1, 2}));
  EXPECT_EQ(AcceptanceJson(acceptance)["findings"]["open_edges"]["places"][0]["hole"], 20);
  EXPECT_THAT(AcceptanceText(acceptance), HasSubstr("what to do: user guide, \"If an output is not accepted\""));
  acceptance.findings[0].places[0].hole.reset();
  EXPECT_THAT(AcceptanceText(acceptance), HasSubstr("[3.00,4.00,5.00] in cell 1,2\n"));
  EXPECT_THAT(AcceptanceCsv(acceptance), HasSubstr("3.0000,4.0000,5.0000,,\r\n"));
  EXPECT_FALSE(AcceptanceJson(acceptance)["findings"]["open_edges"]["places"][0].contains("hole"));
  acceptance.findings[0].count = 0;
  EXPECT_THAT(VerdictOf(acceptance), testing::StartsWith("accepted"));
}

TEST(AcceptanceTextTest, OneIsNoPlural) {
  Acceptance acceptance;
  acceptance.tiles = acceptance.original_faces = acceptance.files = acceptance.water_fills = 1;
  acceptance.overlap_places = 1;
  for (const AcceptanceKindText& text : kAcceptanceKinds) {
    acceptance.findings.push_back({text.name, text.one, text.many, text.is_fault, 1, {}});
    EXPECT_STRNE(text.one, text.many);
  }
  EXPECT_THAT(VerdictOf(acceptance), HasSubstr(", 1 new open edge, 1 filled triangle that crosses another, "));
  EXPECT_THAT(AcceptanceText(acceptance), HasSubstr("compared: 1 tile, 1 original triangle, 0 cleared, 0 new, 1 file, "
                                                    "1 fill of water, 1 place where fills overlap\n"));
  EXPECT_THAT(AcceptanceText(acceptance), HasSubstr("        1  hole left open, as reported (no fault)\n"));
}

TEST(AcceptanceTextTest, SaysWhereFillsThatOverlapWereMeasured) {
  Acceptance acceptance;
  EXPECT_THAT(AcceptanceText(acceptance), testing::Not(HasSubstr("were measured")));
  acceptance.overlap_places = 3;
  EXPECT_THAT(AcceptanceText(acceptance), HasSubstr("fills that overlap were measured where one ends"));
}

TEST(AcceptanceTextTest, SaysOfCrossingsWhyTheReportHasFewer) {
  Acceptance acceptance;
  const AcceptanceKindText& kind = kAcceptanceKinds[kCrossedSurface];
  acceptance.findings = {{kind.name, kind.one, kind.many, true, 0, {}}};
  EXPECT_THAT(AcceptanceText(acceptance), testing::Not(HasSubstr("`crossings` in the report")));
  acceptance.findings[0].count = 5;
  EXPECT_THAT(AcceptanceText(acceptance), HasSubstr("\n`crossings` in the report"));
}

}  // namespace
}  // namespace tilemend
