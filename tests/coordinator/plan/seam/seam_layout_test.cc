#include "coordinator/plan/seam/seam_layout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "absl/strings/str_cat.h"
#include "tests/support/rim_builders.h"
#include "tests/support/seam_scene.h"

namespace tilemend {
namespace {

SeamLayout Lay(const SeamScene& s, SeamsOverRim over_rim = SeamsOverRim::kYes) {
  return LaySeams(s.Site(), s.closing, over_rim);
}

Point2 PositionOf(const SeamScene& s, const SeamLayout& layout, int32_t v) {
  const auto points = static_cast<int32_t>(s.rim.points.size());
  return v < points ? Point2(s.rim.points[v].position.head<2>()) : layout.vertices[v - points].position;
}

TEST(LaySeamsTest, LaysASeamFromJunctionToJunction) {
  const SeamScene s({"####|####", "##..|.###", "##..|.###", "####|####"}, 4);
  const SeamLayout layout = Lay(s);
  ASSERT_EQ(layout.seams.size(), 1U);
  const Seam& seam = layout.seams[0];
  EXPECT_EQ(seam.a, (CellId{0, 0}));
  EXPECT_EQ(seam.b, (CellId{1, 0}));
  EXPECT_EQ(PositionOf(s, layout, seam.vertices.front()), Point2(4, 1));
  EXPECT_EQ(PositionOf(s, layout, seam.vertices.back()), Point2(4, 3));
  EXPECT_TRUE(layout.failures.empty());
}

TEST(LaySeamsTest, LaysNoneWithoutHolesOverLines) {
  const SeamScene s({"####|####", "#..#|####", "#..#|####", "####|####"}, 4);
  const SeamLayout layout = Lay(s);
  EXPECT_TRUE(layout.seams.empty());
  EXPECT_TRUE(layout.vertices.empty());
}

TEST(LaySeamsTest, LaysThemTowardsTheOutsideOfTheAreaToo) {
  const SeamScene s({"####", "##..", "##..", "####"}, 4);
  const SeamLayout layout = Lay(s);
  ASSERT_EQ(layout.seams.size(), 1U);
  EXPECT_EQ(layout.seams[0].b, (CellId{1, 0}));
}

TEST(LaySeamsTest, LeavesTheRimOfAnUnknownAreaOpen) {
  SurveyedScene scene = PictureScene({"####", "##..", "##..", "####"}, 4);
  scene.area_known = false;
  EXPECT_TRUE(Lay(SeamScene(std::move(scene))).seams.empty());
}

TEST(LaySeamsTest, MeetsInOneVertexAtACornerInAHole) {
  const SeamScene s({"####|####", "#...|...#", "#...|...#", "#...|...#", "----+----",  //
                     "#...|...#", "#...|...#", "#...|...#", "####|####"},
                    4);
  const SeamLayout layout = Lay(s);
  ASSERT_EQ(layout.seams.size(), 4U);
  int at_corner = 0;
  for (const Seam& seam : layout.seams) {
    for (const int32_t end : {seam.vertices.front(), seam.vertices.back()}) {
      if (PositionOf(s, layout, end) == Point2(4, 4)) ++at_corner;
    }
  }
  EXPECT_EQ(at_corner, 4);
  EXPECT_EQ(
      std::count_if(layout.vertices.begin(), layout.vertices.end(), [](const SeamVertex& v) { return v.lines == 3; }),
      1);
}

// One hole over three rows of four cells: two cells in the middle have no rim.
TEST(LaySeamsTest, HandsProjectedPlacesOnFromLayerToLayer) {
  const std::string whole = "#..|...|...|..#", edge = "###|###|###|###", line = "---+---+---+---";
  SeamScene s({edge, whole, whole, line, whole, whole, whole, line, whole, whole, edge}, 3);
  s.options.seam_points = SeamPoints::kProjected;
  const SeamLayout layout = Lay(s);
  EXPECT_TRUE(layout.failures.empty());
  const auto heights_on = [&](CellId a, CellId b) {
    std::set<double> at;
    for (const Seam& seam : layout.seams) {
      if (seam.a != a || seam.b != b) continue;
      for (const int32_t v : seam.vertices) at.insert(PositionOf(s, layout, v).y());
    }
    return at;
  };
  EXPECT_EQ(heights_on({0, 1}, {1, 1}), (std::set<double>{3, 4, 5, 6}));  // opposite the western rim
  EXPECT_EQ(heights_on({1, 1}, {2, 1}), (std::set<double>{3, 4, 5, 6}));  // opposite those
}

// Two banks run straight across the line; what is opposite the line lies far from both.
TEST(LaySeamsTest, WhereTilesOverlapSpacedPlacesLieBetweenProjectedOnesThatAreFarApart) {
  const std::string shore(12, '#'), lake = "#...........|...........#";
  std::vector<std::string> picture(12, lake);
  for (const int row : {0, 11}) picture[row] = absl::StrCat(shore, "|", shore);
  SeamScene s(picture, 12);
  s.options.seam_points = SeamPoints::kProjected;
  const auto heights = [&] {
    const SeamLayout layout = Lay(s);
    std::set<double> at;
    for (const int32_t v : layout.seams.at(0).vertices) at.insert(PositionOf(s, layout, v).y());
    return at;
  };
  const std::set<double> shared = heights();
  EXPECT_EQ(shared, (std::set<double>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}));
  s.lines.joined = true;
  const std::set<double> overlapping = heights();
  EXPECT_TRUE(std::ranges::includes(overlapping, shared));
  EXPECT_LT(*std::next(overlapping.begin()), 1.2) << "close to the rim";
  EXPECT_GT(*std::prev(overlapping.end(), 2), 10.8);
}

TEST(LaySeamsTest, TakesRimPointsBesideItsWayOnlyWhereAskedTo) {
  SurveyedScene scene = PictureScene({"######|######", "#.##..|.....#", "#.##..|.....#", "#.....|.....#",  //
                                      "#.....|.....#", "######|######"},
                                     6);
  const Point3 tip(5.9, 3, 0);
  for (Point3& p : scene.tiles.at({0, 0}).points) {
    if (p == Point3(4, 3, 0)) p = tip;
  }
  const SeamScene s(SurveyScene(scene.grid, std::move(scene.tiles)));
  const auto passes = [&](SeamsOverRim over_rim) {
    const SeamLayout layout = Lay(s, over_rim);
    const std::vector<int32_t>& way = layout.seams.at(0).vertices;
    return std::any_of(way.begin(), way.end(), [&](int32_t v) { return PositionOf(s, layout, v) == tip.head<2>(); });
  };
  EXPECT_TRUE(passes(SeamsOverRim::kYes));
  EXPECT_FALSE(passes(SeamsOverRim::kNo));
}

// A piece of the southern tile stands out over the grid corner at the rim of the area, and its tile closes on its top.
TEST(LaySeamsTest, BeginsAtTheRimWhereSurfaceCoversTheCorner) {
  SurveyedScene scene = PictureScene({"####", "####", "...#", "...#", "----", "#..#", "...#", "####", "####"}, 4);
  const Point3 west(0, 4.25, 0), east(1, 4.25, 0);
  for (const CellId cell : {CellId{0, 0}, CellId{0, 1}}) {
    for (Point3& p : scene.tiles.at(cell).points) {
      if (p == Point3(0, 4, 0)) p = west;
      if (p == Point3(1, 4, 0)) p = east;
      if (p == Point3(3, 4, 0)) p.y() = 3.75;  // a ragged cut
    }
  }
  const SeamScene s(SurveyScene(scene.grid, std::move(scene.tiles)));
  ClosingCells closing = s.closing;
  for (size_t e = 0; e < s.rim.edges.size(); ++e) {
    const RimEdge& edge = s.rim.edges[e];
    if (s.rim.points[edge.from].position == east && s.rim.points[edge.to].position == west) closing[e] = {0, 0};
    if (s.rim.points[edge.from].position == west && s.rim.points[edge.to].position == east) closing[e] = {0, 0};
  }
  const SeamLayout layout = LaySeams(s.Site(), closing, SeamsOverRim::kYes);
  EXPECT_TRUE(layout.failures.empty()) << layout.failures.front().reason;
  EXPECT_TRUE(std::any_of(layout.seams.begin(), layout.seams.end(), [&](const Seam& seam) {
    return seam.a == CellId{0, 0} && seam.b == CellId{0, 1} &&
           PositionOf(s, layout, seam.vertices.front()) == west.head<2>();
  }));
}

TEST(LaySeamsTest, SaysWhereInsideAndOutsideCannotBeToldApart) {
  const SeamScene s(
      {"######|######", "####..|....##", "####..|.#..##", "####..|....##", "####..|....##", "######|######"}, 6);
  ClosingCells closing = s.closing;
  // The east side of the island, as if the western cell closed on it.
  for (size_t e = 0; e < s.rim.edges.size(); ++e) {
    const RimEdge& edge = s.rim.edges[e];
    if (s.rim.points[edge.from].position == Point3(8, 3, 0) && s.rim.points[edge.to].position == Point3(8, 4, 0)) {
      closing[e] = {0, 0};
    }
  }
  ASSERT_NE(closing, s.closing);
  const SeamLayout layout = LaySeams(s.Site(), closing, SeamsOverRim::kYes);
  EXPECT_FALSE(layout.failures.empty());
  EXPECT_FALSE(layout.trouble.empty());
  for (const LeftOpen& failure : layout.failures) EXPECT_TRUE(s.area.contains(failure.cell));
}

// A hole that a quarter turn about the middle of the scene maps to another place: the seams turn with it.
TEST(LaySeamsTest, TurnsWithTheScene) {
  const std::vector<std::string> picture = {"########", "#....###", "#....###", "##.....#",  //
                                            "##.....#", "#####..#", "########", "########"};
  std::vector<std::string> turned(8, std::string(8, '#'));
  for (int32_t r = 0; r < 8; ++r) {
    for (int32_t c = 0; c < 8; ++c) turned[7 - c][r] = picture[r][c];
  }
  const SeamScene before(picture, 4), after(turned, 4);
  const auto lengths = [](const SeamScene& s) {
    const SeamLayout layout = Lay(s);
    std::vector<double> of_seams;
    for (const Seam& seam : layout.seams) {
      of_seams.push_back(
          (PositionOf(s, layout, seam.vertices.front()) - PositionOf(s, layout, seam.vertices.back())).norm());
    }
    std::sort(of_seams.begin(), of_seams.end());
    return of_seams;
  };
  EXPECT_EQ(lengths(before), lengths(after));
  EXPECT_EQ(lengths(before).size(), 4U);
}

}  // namespace
}  // namespace tilemend
