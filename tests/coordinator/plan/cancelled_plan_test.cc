// When a plan is cancelled.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "coordinator/plan/plan.h"
#include "tests/support/surveyed_scene.h"

namespace tilemend {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

TEST(CancelledPlanTest, IsEmptyOnceItIsCancelled) {
  const SurveyedScene scene = PictureScene({"####", "#..#", "#..#", "####"}, 2);
  for (int last = 0; last < 12; ++last) {
    PlanOptions options;
    int asked = 0;
    options.is_cancelled = [&] { return asked++ >= last; };
    const bool is_empty = MakePlan(scene.Input(), options).holes.empty();
    EXPECT_EQ(is_empty, asked > last) << last;
  }
}

// A square hole in one cell, without seams.
SurveyedScene OneSquareHole(int32_t edges_a_side) {
  const std::string whole(edges_a_side + 2, '#');
  std::vector<std::string> picture(edges_a_side + 2, "#" + std::string(edges_a_side, '.') + "#");
  picture.front() = picture.back() = whole;
  return PictureScene(picture, edges_a_side + 2);
}

// A hole may have a million rim vertices: each of them is an occasion to end.
TEST(CancelledPlanTest, IsEmptyWheneverItIsCancelledAlongARim) {
  constexpr int kMostAskedAfter = 10;
  int asked = 0, last = std::numeric_limits<int>::max();
  const auto plan = [&](const SurveyedScene& scene) {
    PlanOptions options;
    options.is_cancelled = [&] { return asked++ >= last; };
    asked = 0;
    return MakePlan(scene.Input(), options);
  };
  ASSERT_THAT(plan(OneSquareHole(4)).holes.at(0).segments, SizeIs(16));
  const int with_16 = asked;
  const SurveyedScene scene = OneSquareHole(8);
  const Plan whole = plan(scene);
  ASSERT_THAT(whole.holes.at(0).segments, SizeIs(32));
  EXPECT_THAT(whole.seams, IsEmpty());
  const int with_32 = asked;
  EXPECT_GE(with_32, with_16 + 16);
  for (last = 0; last < with_32; ++last) {
    EXPECT_THAT(plan(scene).holes, IsEmpty()) << last;
    EXPECT_LE(asked, last + kMostAskedAfter) << last;
  }
}

// A file of polygons may be long: each of them is an occasion to end.
TEST(CancelledPlanTest, IsEmptyIfItIsCancelledWhileItLooksAtPolygons) {
  const SurveyedScene scene = PictureScene({"####", "#..#", "#..#", "####"}, 2);
  int asked = 0, last = std::numeric_limits<int>::max();
  const auto count = [&](size_t polygons) {
    PlanOptions options;
    options.water.areas.assign(polygons, {true, {{{{-1e6, -1e6}, {1e6, -1e6}, {1e6, 1e6}, {-1e6, 1e6}}}}});
    options.is_cancelled = [&] { return asked++ >= last; };
    asked = 0;
    return MakePlan(scene.Input(), options).holes.size();
  };
  ASSERT_GT(count(1), 0U);
  const int with_one = asked;
  ASSERT_GT(count(50), 0U);
  const int with_all = asked;
  EXPECT_GE(with_all, with_one + 3 * 49) << "FindWater, which areas cover a hole, what became of each";
  for (last = with_one; last < with_all; last += 9) EXPECT_EQ(count(50), 0U) << last;
}

}  // namespace
}  // namespace tilemend
