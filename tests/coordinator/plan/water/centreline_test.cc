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

TEST(FindCentrelineTest, RunsAlongTheMiddle) {
  const Centreline line = FindCentreline(Channel(), 25);
  ASSERT_GE(line.points.size(), 16u);
  for (const Point2& p : line.points) EXPECT_NEAR(p.y(), Bend(p.x()), 4) << p.transpose();
  EXPECT_NEAR(std::abs(line.points.front().x() - line.points.back().x()), 400, 12);
  EXPECT_NEAR(line.width * line.length, 400 * 20, 200);
}

TEST(FindCentrelineTest, AnIslandDoesNotSplitIt) {
  std::vector<PlaneSegment> channel = Channel();
  const double y = Bend(200);
  const auto island = Closed({{196, y - 4}, {204, y - 4}, {204, y + 4}, {196, y + 4}});
  channel.insert(channel.end(), island.begin(), island.end());
  const Centreline line = FindCentreline(channel, 25);
  EXPECT_NEAR(std::abs(line.points.front().x() - line.points.back().x()), 400, 12);
}

TEST(FindCentrelineTest, SegmentsThatOccurTwiceBoundNothing) {
  std::vector<PlaneSegment> channel = Channel();
  const Centreline whole = FindCentreline(channel, 25);
  const PlaneSegment seam = {{200, Bend(200) - 10}, {200, Bend(200) + 10}};
  channel.push_back(seam);
  channel.emplace_back(seam.second, seam.first);
  EXPECT_EQ(FindCentreline(channel, 25).points, whole.points);
}

TEST(FindCentrelineTest, TheOrderOfSegmentsDoesNotMatter) {
  std::vector<PlaneSegment> channel = Channel();
  const Centreline line = FindCentreline(channel, 25);
  std::reverse(channel.begin(), channel.end());
  EXPECT_EQ(FindCentreline(channel, 25).points, line.points);
}

TEST(FindCentrelineTest, NothingHasNone) { EXPECT_TRUE(FindCentreline({}, 25).points.empty()); }

}  // namespace
}  // namespace tilemend
