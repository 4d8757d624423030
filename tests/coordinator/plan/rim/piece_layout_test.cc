#include "coordinator/plan/rim/piece_layout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "coordinator/plan/overlap/piece_outlines.h"
#include "tests/support/overlapping_scene.h"

namespace tilemend {
namespace {

const std::vector<std::string> kUncut(20, std::string(20, '#'));

// Four pieces that overlap by twice `margin`, turned.
SurveyRecord TurnedPieces(double margin, double angle) {
  SurveyRecord record = OverlappingScene(kUncut, 20, margin, 2).records.begin()->second;
  for (BoundaryVertex& v : record.vertices) {
    const Point3 p = v.position;
    v.position.x() = std::cos(angle) * p.x() - std::sin(angle) * p.y();
    v.position.y() = std::sin(angle) * p.x() + std::cos(angle) * p.y();
  }
  return record;
}

TEST(PieceLayoutTest, TellsHowFarPiecesOverlap) {
  const auto layout = FindPieceLayout(TurnedPieces(0.1, 0));
  ASSERT_TRUE(layout);
  EXPECT_NEAR(layout->reach, 3 * 0.2, 1e-4);
  EXPECT_NEAR(std::abs(layout->axis.x() * layout->axis.y()), 0, 1e-9);
}

TEST(PieceLayoutTest, TellsWhichWayTheyWereCut) {
  for (const double angle : {-0.3, 0.0178, 0.6, 0.785, 1.2}) {
    const SurveyRecord record = TurnedPieces(0.1, angle);
    const auto layout = FindPieceLayout(record);
    ASSERT_TRUE(layout) << angle;
    const double turn = std::atan2(layout->axis.y(), layout->axis.x()) - angle;
    EXPECT_NEAR(std::remainder(turn, std::acos(0.0)), 0, 1e-5) << angle;
    const std::vector<bool> outlines = FindPieceOutlines(record, *layout);
    EXPECT_EQ(std::ranges::count(outlines, true), 4 * 2 * 10) << "two inner sides of four pieces";
  }
}

// As leaves whose vertices do not match, or cracks in one surface.
TEST(PieceLayoutTest, PiecesThatJustMeetHaveNone) { EXPECT_FALSE(FindPieceLayout(TurnedPieces(1e-4, 0.2))); }

// Triangles that lie anywhere, thousands around each edge: too many to look at.
TEST(PieceLayoutTest, ASoupHasNone) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(0, 15), way(-0.5, 0.5);
  SurveyRecord soup;
  for (int32_t t = 0; t < 20'000; ++t) {
    const Point3 middle(place(random), place(random), place(random));
    for (int32_t k = 0; k < 3; ++k) {
      soup.vertices.emplace_back().position = middle + Point3(way(random), way(random), way(random));
      soup.edges.push_back({3 * t + k, 3 * t + (k + 1) % 3, t});
    }
  }
  EXPECT_FALSE(FindPieceLayout(soup));
}

TEST(PieceLayoutTest, PiecesThatPartMayBeTheSidesOfADitch) { EXPECT_FALSE(FindPieceLayout(TurnedPieces(-0.05, 0))); }

TEST(PieceLayoutTest, ATileOfOnePieceHasNone) {
  EXPECT_FALSE(FindPieceLayout(OverlappingScene(kUncut, 20, 0.1).records.begin()->second));
  EXPECT_FALSE(FindPieceLayout(SurveyRecord()));
}

TEST(PieceLayoutTest, ABoundaryThatDoesNotCloseHasNone) {
  SurveyRecord record = TurnedPieces(0.1, 0);
  record.edges.pop_back();
  EXPECT_FALSE(FindPieceLayout(record));
}

// All edges of a frame lie 1 m from an opposite one.
TEST(PieceLayoutTest, AStripOfOnePieceIsNoOverlap) {
  const std::vector<std::string> frame = {"######", "#....#", "#....#", "#....#", "#....#", "######"};
  EXPECT_FALSE(FindPieceLayout(OverlappingScene(frame, 6, 0).records.begin()->second));
}

// A winding river of one piece has opposite shores, but at all distances.
TEST(PieceLayoutTest, ShoresAreNoPieces) {
  const std::vector<std::string> river = {"##########", "....######", "###..#####", "####...###", "######..##",
                                          "#####..###", "####...###", "###....###", "##.....###", "##########"};
  EXPECT_FALSE(FindPieceLayout(OverlappingScene(river, 10, 0).records.begin()->second));
}

}  // namespace
}  // namespace tilemend
