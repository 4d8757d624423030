#include "common/mesh/triangulation/insertion_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

namespace tilemend::internal {
namespace {

std::vector<Point32> RandomPoints(int count, int32_t side) {
  std::mt19937 random(1);
  std::vector<Point32> points;
  for (int i = 0; i < count; ++i) {
    points.push_back({static_cast<int32_t>(random() % static_cast<uint32_t>(side)),
                      static_cast<int32_t>(random() % static_cast<uint32_t>(side))});
  }
  return points;
}

std::vector<int32_t> All(size_t count) {
  std::vector<int32_t> indices(count);
  std::iota(indices.begin(), indices.end(), 0);
  return indices;
}

double LengthAlong(const std::vector<Point32>& points, const std::vector<int32_t>& order) {
  double length = 0;
  for (size_t i = 1; i < order.size(); ++i) {
    length += std::hypot(points[order[i]].x - points[order[i - 1]].x, points[order[i]].y - points[order[i - 1]].y);
  }
  return length;
}

TEST(SortAlongCurveTest, VisitsTheSquareInFourQuarters) {
  // The Hilbert curve of the first order: up, right, down.
  const std::vector<Point32> points = {{3, 0}, {0, 3}, {3, 3}, {0, 0}};
  std::vector<int32_t> order = All(4);
  SortAlongCurve(points, order);
  const std::vector<int32_t> one_way = {3, 1, 2, 0}, other_way = {3, 0, 2, 1};
  EXPECT_TRUE(order == one_way || order == other_way);
}

TEST(SortAlongCurveTest, StaysNear) {
  const int count = 4000, side = 1 << 20;
  const std::vector<Point32> points = RandomPoints(count, side);
  std::vector<int32_t> order = All(points.size());
  SortAlongCurve(points, order);
  // A shortest tour of n random points takes 0.7 sqrt(n) sides; the curve at most twice that.
  EXPECT_LT(LengthAlong(points, order), 1.4 * std::sqrt(count) * side);
  EXPECT_GT(LengthAlong(points, All(points.size())), 0.3 * count * side);
}

TEST(SortAlongCurveTest, DoesNotDependOnWhereThePointsLie) {
  const std::vector<Point32> points = RandomPoints(500, 1000);
  std::vector<Point32> moved = points;
  for (Point32& p : moved) p = {p.x - 500'000'000, p.y + 400'000'000};
  std::vector<int32_t> order = All(500), moved_order = order;
  SortAlongCurve(points, order);
  SortAlongCurve(moved, moved_order);
  EXPECT_EQ(order, moved_order);
}

TEST(SortForInsertionTest, KeepsEveryIndexAndIsTheSameEveryTime) {
  const std::vector<Point32> points = RandomPoints(1000, 1 << 29);
  std::vector<int32_t> chosen;
  for (int32_t i = 0; i < 1000; i += 3) chosen.push_back(i);
  std::vector<int32_t> order = chosen, again = chosen;
  SortForInsertion(points, order);
  SortForInsertion(points, again);
  EXPECT_EQ(order, again);
  std::sort(again.begin(), again.end());
  EXPECT_EQ(again, chosen);
}

TEST(SortForInsertionTest, BeginsWithAFewThatLieAllOver) {
  const std::vector<Point32> points = RandomPoints(4096, 1000);
  std::vector<int32_t> order = All(points.size());
  SortForInsertion(points, order);
  // Along one curve the first 256 would lie in a sixteenth of the square.
  std::vector<int> in_quarter(4, 0);
  for (int i = 0; i < 256; ++i) ++in_quarter[(points[order[i]].x >= 500 ? 1 : 0) + (points[order[i]].y >= 500 ? 2 : 0)];
  EXPECT_GT(*std::min_element(in_quarter.begin(), in_quarter.end()), 32);
}

TEST(SortForInsertionTest, TakesNoneAndOne) {
  std::vector<int32_t> none, one = {0};
  SortForInsertion({}, none);
  EXPECT_TRUE(none.empty());
  const std::vector<Point32> points = {{5, 5}};
  SortForInsertion(points, one);
  EXPECT_EQ(one, std::vector<int32_t>{0});
}

}  // namespace
}  // namespace tilemend::internal
