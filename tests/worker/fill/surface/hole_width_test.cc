#include "worker/fill/surface/hole_width.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

namespace tilemend {
namespace {

// The outline of a polygon; clockwise ones are islands.
void AddLoop(const std::vector<Point3>& corners, std::vector<Point3>& points, std::vector<RegionSegment>& segments) {
  const auto first = static_cast<int32_t>(points.size()), n = static_cast<int32_t>(corners.size());
  points.insert(points.end(), corners.begin(), corners.end());
  for (int32_t k = 0; k < n; ++k) segments.push_back({first + k, first + (k + 1) % n});
}

TEST(HoleWidthTest, IsTheDiameterOfADiscAndTheWidthOfAStrip) {
  std::vector<Point3> disc, strip;
  for (int k = 0; k < 90; ++k) disc.emplace_back(20 * std::cos(k * M_PI / 45) + 7, 20 * std::sin(k * M_PI / 45), k);
  for (int k = 0; k < 200; ++k) strip.emplace_back(k, 0, 0);
  for (int k = 200; k > 0; --k) strip.emplace_back(k - 0.5, 12, 0);
  for (const auto& [corners, width] : {std::pair(disc, 40.0), std::pair(strip, 12.0)}) {
    std::vector<Point3> points;
    std::vector<RegionSegment> segments;
    AddLoop(corners, points, segments);
    EXPECT_NEAR(HoleWidth(points, segments), width, 0.02 * width);
  }
}

TEST(HoleWidthTest, AnIslandMakesARing) {
  std::vector<Point3> points;
  std::vector<RegionSegment> segments;
  std::vector<Point3> outer, island;
  for (int k = 0; k < 90; ++k) outer.emplace_back(20 * std::cos(k * M_PI / 45), 20 * std::sin(k * M_PI / 45), 0);
  for (int k = 90; k > 0; --k) island.emplace_back(12 * std::cos(k * M_PI / 45), 12 * std::sin(k * M_PI / 45), 0);
  AddLoop(outer, points, segments);
  AddLoop(island, points, segments);
  EXPECT_NEAR(HoleWidth(points, segments), 8, 0.5);
}

TEST(HoleWidthTest, SegmentsThatBoundNothingHaveNone) {
  const std::vector<Point3> points = {{0, 0, 0}, {4, 4, 0}, {4, 0, 0}, {0, 4, 0}};
  EXPECT_EQ(HoleWidth(points, std::vector<RegionSegment>{{0, 1}, {1, 2}, {2, 3}, {3, 0}}), 0);
  EXPECT_EQ(HoleWidth(points, std::vector<RegionSegment>{}), 0);
}

}  // namespace
}  // namespace tilemend
