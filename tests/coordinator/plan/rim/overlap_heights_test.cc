#include "coordinator/plan/rim/overlap_heights.h"

#include <gtest/gtest.h>

#include "tests/support/overlapping_scene.h"

namespace tilemend {
namespace {

// A tile of 10 x 10 squares of 1 m from `west`, surveyed.
SurveyRecord TileFrom(double west, const HeightFunction& height) {
  const auto whole = [](int32_t, int32_t) { return true; };
  std::map<CellId, TriMesh> tiles;
  tiles[{0, 0}] = Moved(SquaresMesh(0, 10, 0, 10, whole),
                        [&](const Point3& p) { return Point3(p.x() + west, p.y(), height(p.x() + west, p.y())); });
  return SurveyScene(Grid(), std::move(tiles)).records.at({0, 0});
}

// Two tiles over a slope, the eastern one `up` higher; they overlap by 0.4 m.
HeightGap Compare(const HeightFunction& up) {
  const auto slope = [](double x, double y) { return 0.5 * x + 0.2 * y; };
  const SurveyRecord a = TileFrom(0, slope);
  const SurveyRecord b = TileFrom(9.6, [&](double x, double y) { return slope(x, y) + up(x, y); });
  return CompareHeights({a, 10}, {b, 9.6}, 0);
}

TEST(CompareHeightsTest, FindsNothingBetweenPartsOfOneSurface) {
  const HeightGap gap = Compare([](double, double) { return 0; });
  EXPECT_EQ(gap.places, 22);
  EXPECT_NEAR(gap.ninth_decile, 0, 1e-9) << "the slope between the outlines is no difference";
}

TEST(CompareHeightsTest, FindsHowMuchHigherOneTileIs) {
  const HeightGap gap = Compare([](double, double) { return -0.07; });
  EXPECT_NEAR(gap.median, 0.07, 1e-9);
  EXPECT_NEAR(gap.ninth_decile, 0.07, 1e-9);
}

TEST(CompareHeightsTest, TellsTheUsualFromTheLargest) {
  const HeightGap gap = Compare([](double, double y) { return y > 7 ? 0.5 : 0.02; });
  EXPECT_NEAR(gap.median, 0.02, 1e-9);
  EXPECT_NEAR(gap.ninth_decile, 0.5, 1e-9);
}

TEST(CompareHeightsTest, KnowsNothingOfTilesThatDoNotMeet) {
  const auto flat = [](double, double) { return 0; };
  const SurveyRecord a = TileFrom(0, flat), b = TileFrom(12, flat);
  EXPECT_EQ(CompareHeights({a, 10}, {b, 12}, 0).places, 0);
}

}  // namespace
}  // namespace tilemend
