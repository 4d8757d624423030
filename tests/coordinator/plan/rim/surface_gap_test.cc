#include "coordinator/plan/rim/surface_gap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

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

const double kCosine = 1 / std::sqrt(1 + 0.5 * 0.5 + 0.2 * 0.2);  // of the slope

// Two tiles over a slope, the eastern one `up` higher; they overlap by 0.4 m.
SurfaceGap Compare(const HeightFunction& up) {
  const auto slope = [](double x, double y) { return 0.5 * x + 0.2 * y; };
  const SurveyRecord a = TileFrom(0, slope);
  const SurveyRecord b = TileFrom(9.6, [&](double x, double y) { return slope(x, y) + up(x, y); });
  return MeasureGap({a, 10}, {b, 9.6}, 0);
}

TEST(SurfaceGapTest, FindsNothingBetweenPartsOfOneSurface) {
  const SurfaceGap gap = Compare([](double, double) { return 0; });
  EXPECT_EQ(gap.places, 22);
  EXPECT_NEAR(gap.ninth_decile, 0, 1e-9) << "the slope between the outlines is no difference";
}

TEST(SurfaceGapTest, FindsHowMuchHigherOneTileIs) {
  const SurfaceGap gap = Compare([](double, double) { return -0.07; });
  EXPECT_NEAR(gap.median, 0.07 * kCosine, 1e-9);
  EXPECT_NEAR(gap.ninth_decile, 0.07 * kCosine, 2e-3) << "at the ends of the border the nearest place is beyond";
}

TEST(SurfaceGapTest, TellsTheUsualFromTheLargest) {
  const SurfaceGap gap = Compare([](double, double y) { return y > 7 ? 0.5 : 0.02; });
  EXPECT_NEAR(gap.median, 0.02 * kCosine, 1e-3);
  EXPECT_NEAR(gap.ninth_decile, 0.5 * kCosine, 0.05);
}

// As where one was reconstructed apart from the others.
TEST(SurfaceGapTest, FindsTilesMetresApart) {
  EXPECT_NEAR(Compare([](double, double) { return 5; }).median, 5, 1e-9);
  EXPECT_NEAR(Compare([](double, double y) { return y > 7 ? 0 : -20; }).median, 20, 1e-9);
  EXPECT_NEAR(Compare([](double, double y) { return y > 3 ? 0 : 5; }).ninth_decile, 0, 1e-9) << "a house in one";
}

// Facades across the border, a hand apart: any vertical distance is their height.
TEST(SurfaceGapTest, MeasuresBetweenWallsAcross) {
  const auto wall = [](double at) { return [at](double, double y) { return 40 * std::clamp(y - at, 0.0, 1.0); }; };
  const SurveyRecord a = TileFrom(0, wall(4)), b = TileFrom(9.6, wall(4.05));
  EXPECT_LT(MeasureGap({a, 10}, {b, 9.6}, 0).ninth_decile, 0.1);
}

TEST(SurfaceGapTest, KnowsNothingOfTilesThatDoNotMeet) {
  const auto flat = [](double, double) { return 0; };
  const SurveyRecord a = TileFrom(0, flat), b = TileFrom(12, flat);
  EXPECT_EQ(MeasureGap({a, 10}, {b, 12}, 0).places, 0);
}

}  // namespace
}  // namespace tilemend
