#include "common/mesh/vertex_lists.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

const std::vector<Triangle> kTriangles = {{0, 1, 2}, {2, 1, 3}, {3, 0, 2}};

TEST(VertexListsTest, ListsEntriesInTheOrderInWhichTheyAreGiven) {
  const std::vector<std::pair<int32_t, int32_t>> entries = {{2, 7}, {0, 5}, {2, -1}, {2, 7}};
  const VertexLists lists(4, [&](const auto& use) {
    for (const auto& [vertex, entry] : entries) use(vertex, entry);
  });
  EXPECT_THAT(lists.Of(0), ElementsAre(5));
  EXPECT_THAT(lists.Of(1), IsEmpty());
  EXPECT_THAT(lists.Of(2), ElementsAre(7, -1, 7));
  EXPECT_THAT(lists.Of(3), IsEmpty());
}

TEST(VertexListsTest, ListsNothingWithoutTriangles) { EXPECT_THAT(CornersAt({}, 1).Of(0), IsEmpty()); }

TEST(VertexListsTest, ListsTheCornersAtEachVertex) {
  const VertexLists corners = CornersAt(kTriangles, 5);
  EXPECT_THAT(corners.Of(0), ElementsAre(0, 9));
  EXPECT_THAT(corners.Of(2), ElementsAre(2, 4, 10));
  EXPECT_THAT(corners.Of(4), IsEmpty());
  for (int32_t v = 0; v < 5; ++v) {
    for (const int32_t c : corners.Of(v)) EXPECT_EQ(kTriangles[c >> 2][c & 3], v);
  }
}

TEST(VertexListsTest, ListsTheEndsOfTheEdgesFromEachVertex) {
  const VertexLists ends = EdgeEndsFrom(kTriangles, 4);
  EXPECT_THAT(ends.Of(0), ElementsAre(1, 2));
  EXPECT_THAT(ends.Of(1), ElementsAre(2, 3));
  EXPECT_THAT(ends.Of(2), ElementsAre(0, 1, 3));
  EXPECT_THAT(ends.Of(3), ElementsAre(2, 0));
}

}  // namespace
}  // namespace tilemend
