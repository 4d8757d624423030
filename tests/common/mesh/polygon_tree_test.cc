#include "common/mesh/polygon_tree.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

PlanePolygon Square(double x) { return {{{{x, 0}, {x + 1, 0}, {x + 1, 1}, {x, 1}}}}; }

TEST(PolygonTreeTest, FindsWhatMeetsABoxOrTouchesIt) {
  const std::vector<PlanePolygon> polygons = {Square(3), Square(0), {}, Square(1), Square(9)};
  const PolygonTree tree(polygons.size(), [&](size_t i) { return polygons[i]; });
  EXPECT_THAT(tree.Meeting({1, 0.5}, {3, 0.5}), ElementsAre(0, 1, 3));
  EXPECT_THAT(tree.Meeting({1.5, 0.5}, {1.5, 0.5}), ElementsAre(3));
  EXPECT_THAT(tree.Meeting({1, 1.5}, {3, 2}), IsEmpty());
}

TEST(PolygonTreeTest, FindsNothingAmongNone) {
  EXPECT_THAT(PolygonTree().Meeting({0, 0}, {1, 1}), IsEmpty());
  const PolygonTree empty(2, [](size_t) { return PlanePolygon(); });
  EXPECT_THAT(empty.Meeting({-1, -1}, {1, 1}), IsEmpty());
}

TEST(PolygonTreeTest, VisitsFewOfMany) {
  const PolygonTree tree(10000, [](size_t i) { return Square(2.0 * static_cast<double>(i)); });
  std::vector<int32_t> visited;
  tree.ForMeeting({4000, 0}, {4002, 1}, [&](int32_t i) { visited.push_back(i); });
  EXPECT_THAT(visited, ::testing::UnorderedElementsAre(2000, 2001));
}

}  // namespace
}  // namespace tilemend
