#include "coordinator/plan/seam/seam_path.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace tilemend {
namespace {

using ::testing::ElementsAre;

// One loop around a hole, clockwise seen from above, 10 m wide and reaching 5 m south of its first point and its east
// end; `north` are the points between these on its north side.
Rim HoleBelow(const std::vector<Point2>& north) {
  std::vector<Point2> way = {{0, 0}};
  way.insert(way.end(), north.begin(), north.end());
  way.emplace_back(10, 0);
  way.emplace_back(10, -5);
  way.emplace_back(0, -5);
  Rim rim;
  rim.loops.emplace_back();
  const auto n = static_cast<int32_t>(way.size());
  for (int32_t i = 0; i < n; ++i) {
    rim.points.emplace_back();
    rim.points.back().position << way[static_cast<size_t>(i)], 0;
    rim.points.back().size = 1;
    rim.edges.push_back({i, (i + 1) % n, {}});
    rim.loops[0].push_back(i);
  }
  return rim;
}

std::vector<int32_t> Bent(const Rim& rim, const std::vector<int32_t>& path,
                          double reach = std::numeric_limits<double>::infinity()) {
  const RimIndex index(rim);
  return BendToRim(
      path, rim, index, [&](int32_t v) { return Point2(rim.points[v].position.head<2>()); }, reach);
}

TEST(BendToRimTest, LeavesAnEdgeAloneThatIsClearOfTheRim) {
  const Rim rim = HoleBelow({{3, 4}, {5, 2.5}, {7, 4}});
  EXPECT_THAT(Bent(rim, {0, 4}), ElementsAre(0, 4));
}

TEST(BendToRimTest, GoesOverAPointCloseBesideIt) {
  const Rim rim = HoleBelow({{3, 4}, {5, 0.5}, {7, 4}});
  EXPECT_THAT(Bent(rim, {0, 4}), ElementsAre(0, 2, 4));
}

TEST(BendToRimTest, GoesOverEveryPointCloseBesideIt) {
  const Rim rim = HoleBelow({{3, 0.4}, {5, 4}, {7, 0.3}});
  EXPECT_THAT(Bent(rim, {0, 4}), ElementsAre(0, 1, 3, 4));
}

TEST(BendToRimTest, LeavesAlonePointsOutOfReach) {
  const Rim rim = HoleBelow({{3, 0.1}, {5, 4}, {7, 0.3}});
  EXPECT_THAT(Bent(rim, {0, 4}, 0.2), ElementsAre(0, 1, 4));
}

TEST(BendToRimTest, LeavesAlonePointsBeyondItsEnds) {
  const Rim rim = HoleBelow({{-1, 0.5}, {5, 4}, {11, 0.5}});
  EXPECT_THAT(Bent(rim, {0, 4}), ElementsAre(0, 4));
}

TEST(BendToRimTest, LeavesAPathAlongTheRimAsItIs) {
  const Rim rim = HoleBelow({{3, 0.4}, {5, 0.1}, {7, 0.3}});
  EXPECT_THAT(Bent(rim, {0, 1, 2, 3, 4}), ElementsAre(0, 1, 2, 3, 4));
}

}  // namespace
}  // namespace tilemend
