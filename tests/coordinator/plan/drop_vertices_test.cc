#include "coordinator/plan/drop_vertices.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "tests/support/surveyed_scene.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::SizeIs;

TEST(DropUnusedVerticesTest, KeepsWhatHolesAndSeamsNameInItsOrder) {
  Plan plan;
  plan.vertices.resize(8);
  for (int32_t v = 0; v < 8; ++v) plan.vertices[v].index = v;
  plan.holes.resize(1);
  plan.holes[0].segments = {{6, 1, false}, {1, 6, true}};
  plan.holes[0].own_regions = {{{6, 7, false}}};
  plan.seams = {{{0, 0}, {1, 0}, {3}}};
  plan.vertices[7].follows = 2;  // is kept for it
  plan.vertices[0].follows = 6;  // is not
  plan.vertex_of_boundary[{0, 0}] = {0, 1, -1, 6};
  plan.vertex_of_boundary[{1, 0}] = {4, 5, 0, -1};
  DropUnusedVertices(plan);
  std::vector<int32_t> kept;
  for (const PlanVertex& v : plan.vertices) kept.push_back(v.index);
  EXPECT_THAT(kept, ElementsAre(1, 2, 3, 6, 7));
  EXPECT_EQ(plan.holes[0].segments[0].from, 3);
  EXPECT_EQ(plan.holes[0].segments[0].to, 0);
  EXPECT_EQ(plan.holes[0].own_regions[0][0].to, 4);
  EXPECT_THAT(plan.seams[0].vertices, ElementsAre(2));
  EXPECT_EQ(plan.vertices[4].follows, 1);
  EXPECT_EQ(plan.vertices[0].follows, -1);
  EXPECT_THAT(plan.vertex_of_boundary.at({0, 0}), ElementsAre(-1, 0, -1, 3));
  EXPECT_FALSE(plan.vertex_of_boundary.contains({1, 0})) << "none of them bounds a hole";
}

TEST(DropUnusedVerticesTest, NothingOfTheRimOfTheAreaStays) {
  const SurveyedScene scene = PictureScene({"####|####",  //
                                            "#.##|####",  //
                                            "####|####",  //
                                            "####|####"},
                                           4);
  const Plan plan = MakePlan(scene.Input(), {});
  ASSERT_EQ(CountsOf(plan), "1 closed");
  EXPECT_THAT(plan.vertices, SizeIs(4));
  EXPECT_FALSE(plan.vertex_of_boundary.contains({1, 0}));
}

}  // namespace
}  // namespace tilemend
