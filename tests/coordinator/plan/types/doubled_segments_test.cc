#include "coordinator/plan/types/doubled_segments.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace tilemend {
namespace {

using Ends = std::pair<int32_t, int32_t>;

std::vector<Ends> LeftOf(std::vector<RimSegment> segments) {
  DropDoubled(segments);
  std::vector<Ends> ends;
  for (const RimSegment& s : segments) ends.emplace_back(s.from, s.to);
  return ends;
}

// Two squares that a link joins: without it they are two loops.
TEST(DropDoubledTest, ALinkThereAndBackBoundsNothing) {
  const std::vector<Ends> loops = {{0, 1}, {1, 2}, {2, 0}, {5, 6}, {6, 7}, {7, 5}};
  EXPECT_EQ(LeftOf({{0, 1}, {1, 2}, {2, 5}, {2, 0}, {5, 6}, {5, 2}, {6, 7}, {7, 5}}), loops);
}

TEST(DropDoubledTest, OneWayIsKeptHoweverOften) {
  const std::vector<Ends> same = {{0, 1}, {0, 1}, {1, 2}};
  EXPECT_EQ(LeftOf({{0, 1}, {0, 1}, {1, 2}}), same);
}

TEST(DropDoubledTest, TakesSegmentsOutOfOtherItems) {
  std::vector<std::pair<char, RimSegment>> items = {{'a', {0, 1}}, {'b', {1, 2}}, {'c', {1, 0}}};
  DropDoubled(items, &std::pair<char, RimSegment>::second);
  ASSERT_EQ(items.size(), 1U);
  EXPECT_EQ(items[0].first, 'b');
}

}  // namespace
}  // namespace tilemend
