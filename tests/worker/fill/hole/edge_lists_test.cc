#include "worker/fill/hole/edge_lists.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(EdgeListsTest, HasTheDirectedEdgesOfEachVertex) {
  const std::vector<Triangle> triangles = {{0, 1, 2}, {0, 2, 3}};
  const EdgeLists edges(triangles, 5);
  EXPECT_THAT(edges.From(0), ElementsAre(1, 2));
  EXPECT_THAT(edges.From(2), ElementsAre(0, 3));
  EXPECT_THAT(edges.From(4), IsEmpty());
  EXPECT_EQ(edges.Count(0, 2), 1);
  EXPECT_EQ(edges.Count(2, 0), 1);
  EXPECT_EQ(edges.Count(1, 0), 0);
}

TEST(EdgeListsTest, CountsRepeatedEdges) {
  const std::vector<Triangle> triangles = {{0, 1, 2}, {0, 1, 3}};
  EXPECT_EQ(EdgeLists(triangles, 4).Count(0, 1), 2);
}

}  // namespace
}  // namespace tilemend
