#include "coordinator/plan/water/rim_membrane.h"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace tilemend {
namespace {

std::vector<PlaneSegment> BoxOutline(double width, double height) {
  const std::vector<Point2> corners = {{0, 0}, {width, 0}, {width, height}, {0, height}};
  std::vector<PlaneSegment> outline;
  for (size_t i = 0; i < 4; ++i) outline.emplace_back(corners[i], corners[(i + 1) % 4]);
  return outline;
}

std::vector<Point3> RimOf(double width, double height, const std::function<double(double, double)>& z) {
  std::vector<Point3> places;
  for (double x = 0; x <= width; x += 2)
    places.emplace_back(x, 0, z(x, 0)), places.emplace_back(x, height, z(x, height));
  for (double y = 2; y < height; y += 2) places.emplace_back(0, y, z(0, y)), places.emplace_back(width, y, z(width, y));
  return places;
}

TEST(MeanOffLevelTest, OfALevelRimIsHowFarItIsOff) {
  const auto rim = RimOf(60, 40, [](double, double) { return 3.5; });
  EXPECT_NEAR(MeanOffLevel(BoxOutline(60, 40), rim, 3.5), 0, 1e-9);
  EXPECT_NEAR(MeanOffLevel(BoxOutline(60, 40), rim, 3.0), 0.5, 1e-9);
}

// Planes are harmonic: from the middle of one, the mean is a quarter of its fall.
TEST(MeanOffLevelTest, OfAPlaneIsThePlanes) {
  const auto rim = RimOf(60, 40, [](double x, double) { return 0.1 * x; });
  EXPECT_NEAR(MeanOffLevel(BoxOutline(60, 40), rim, 3), 1.5, 0.1);
  EXPECT_NEAR(MeanOffLevel(BoxOutline(60, 40), rim, -10), 13, 0.1);
}

TEST(MeanOffLevelTest, WhatIsNarrowerThanASquareCounts) {
  const auto rim = RimOf(3000, 1, [](double, double) { return 2.0; });
  EXPECT_NEAR(MeanOffLevel(BoxOutline(3000, 1), rim, 1), 1, 1e-9);
}

TEST(MeanOffLevelTest, SegmentsThatOccurTwiceBoundNothing) {
  std::vector<PlaneSegment> outline = BoxOutline(60, 40);
  outline.emplace_back(Point2(30, 0), Point2(30, 40));
  outline.emplace_back(Point2(30, 40), Point2(30, 0));
  const auto rim = RimOf(60, 40, [](double x, double) { return 0.1 * x; });
  EXPECT_EQ(MeanOffLevel(outline, rim, 3), MeanOffLevel(BoxOutline(60, 40), rim, 3));
}

}  // namespace
}  // namespace tilemend
