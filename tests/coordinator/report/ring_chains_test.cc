#include "coordinator/report/ring_chains.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using ::testing::UnorderedElementsAre;

TEST(RingsOfTest, FollowsSegmentsInAnyOrder) {
  EXPECT_THAT(RingsOf({{3, 0}, {1, 2}, {0, 1}, {2, 3}, {8, 9}, {7, 8}, {9, 7}}),
              UnorderedElementsAre(ElementsAre(0, 1, 2, 3), ElementsAre(7, 8, 9)));
}

TEST(RingsOfTest, ASeamBetweenTwoHolesBoundsNothing) {
  const auto rings = RingsOf({{0, 1}, {1, 2}, {2, 0}, {2, 1}, {1, 3}, {3, 2}});
  ASSERT_THAT(rings, SizeIs(1));
  EXPECT_THAT(rings[0], ElementsAre(0, 1, 3, 2));
}

TEST(RingsOfTest, RingsThatTouchAtAVertexAreTwo) {
  EXPECT_THAT(RingsOf({{0, 1}, {1, 2}, {2, 0}, {0, 3}, {3, 4}, {4, 0}}), SizeIs(2));
}

TEST(RingsOfTest, AWalkThatEndsNowhereIsLeftOut) {
  EXPECT_THAT(RingsOf({{0, 1}, {1, 2}}), IsEmpty());
  EXPECT_THAT(RingsOf({}), IsEmpty());
}

}  // namespace
}  // namespace tilemend
