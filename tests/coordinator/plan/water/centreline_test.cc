#include "coordinator/plan/water/centreline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace tilemend {
namespace {

std::vector<PlaneSegment> Closed(const std::vector<Point2>& ring) {
  std::vector<PlaneSegment> segments;
  for (size_t i = 0; i < ring.size(); ++i) segments.emplace_back(ring[i], ring[(i + 1) % ring.size()]);
  return segments;
}

double Bend(double x) { return 30 * std::sin(x / 70); }

// A channel of 400 m along a wave, 20 m wide in y.
std::vector<PlaneSegment> Channel() {
  std::vector<Point2> ring;
  for (int x = 0; x <= 400; x += 2) ring.emplace_back(x, Bend(x) - 10);
  for (int x = 400; x >= 0; x -= 2) ring.emplace_back(x, Bend(x) + 10);
  return Closed(ring);
}

TEST(FindCentrelinesTest, RunsAlongTheMiddle) {
  const Centreline line = FindCentrelines(Channel(), 25)[0];
  ASSERT_GE(line.points.size(), 16u);
  for (const Point2& p : line.points) EXPECT_NEAR(p.y(), Bend(p.x()), 4) << p.transpose();
  EXPECT_NEAR(std::abs(line.points.front().x() - line.points.back().x()), 400, 12);
  EXPECT_NEAR(line.width * line.length, 400 * 20, 200);
}

TEST(FindCentrelinesTest, AnIslandDoesNotSplitIt) {
  std::vector<PlaneSegment> channel = Channel();
  const double y = Bend(200);
  const auto island = Closed({{196, y - 4}, {204, y - 4}, {204, y + 4}, {196, y + 4}});
  channel.insert(channel.end(), island.begin(), island.end());
  const Centreline line = FindCentrelines(channel, 25)[0];
  EXPECT_NEAR(std::abs(line.points.front().x() - line.points.back().x()), 400, 12);
}

TEST(FindCentrelinesTest, SegmentsThatOccurTwiceBoundNothing) {
  std::vector<PlaneSegment> channel = Channel();
  const Centreline whole = FindCentrelines(channel, 25)[0];
  const PlaneSegment seam = {{200, Bend(200) - 10}, {200, Bend(200) + 10}};
  channel.push_back(seam);
  channel.emplace_back(seam.second, seam.first);
  EXPECT_EQ(FindCentrelines(channel, 25)[0].points, whole.points);
}

// A bridge of 8 m, and beside it a puddle.
TEST(FindCentrelinesTest, EveryLargePartHasOne) {
  std::vector<PlaneSegment> both = Closed({{0, 0}, {250, 0}, {250, 20}, {0, 20}});
  for (const auto& part : {Closed({{258, 0}, {400, 0}, {400, 20}, {258, 20}}), Closed({{252, 8}, {255, 8}, {255, 11}})})
    both.insert(both.end(), part.begin(), part.end());
  const std::vector<Centreline> lines = FindCentrelines(both, 25);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_NEAR(lines[0].length, 250, 12);
  EXPECT_NEAR(lines[1].length, 142, 12);
  for (const Centreline& line : lines) EXPECT_NEAR(line.width * line.length, line.length * 20, 200);
}

TEST(FindCentrelinesTest, TheOrderOfSegmentsDoesNotMatter) {
  std::vector<PlaneSegment> channel = Channel();
  const Centreline line = FindCentrelines(channel, 25)[0];
  std::reverse(channel.begin(), channel.end());
  EXPECT_EQ(FindCentrelines(channel, 25)[0].points, line.points);
}

TEST(FindCentrelinesTest, NothingHasNone) { EXPECT_TRUE(FindCentrelines({}, 25).empty()); }

}  // namespace
}  // namespace tilemend
