#include "coordinator/plan/overlap/chain_groups.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::SizeIs;

SurveyRecord RecordOf(int32_t vertices, const std::vector<BoundaryEdge>& edges) {
  SurveyRecord record;
  record.vertices.resize(static_cast<size_t>(vertices));
  record.edges = edges;
  return record;
}

std::vector<ChainGroup> Group(const SurveyRecord& record, const std::vector<OutlineGap>& gaps,
                              const std::vector<std::vector<int32_t>>& edges_of_hole) {
  return GroupChains(record, std::vector<bool>(record.edges.size(), true), gaps, edges_of_hole);
}

TEST(ChainGroupsTest, FollowsChainsOverGaps) {
  // Two chains with gaps between their ends, and one that belongs to nobody.
  const SurveyRecord record = RecordOf(9, {{0, 1}, {1, 2}, {3, 4}, {4, 5}, {6, 7}, {7, 8}});
  const auto groups = Group(record, {{0, 5}, {3, 2}, {6, 8}}, {{0}});
  ASSERT_THAT(groups, SizeIs(1));
  EXPECT_THAT(groups[0].holes, ElementsAre(0));
  EXPECT_THAT(groups[0].edges, ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(groups[0].gaps, SizeIs(2));
}

TEST(ChainGroupsTest, MakesOneOfHolesThatAChainHoldsTogether) {
  const SurveyRecord record = RecordOf(3, {{0, 1}, {1, 2}, {2, 0}});
  EXPECT_THAT(Group(record, {}, {{0}, {2}}), SizeIs(1));
}

TEST(ChainGroupsTest, KeepsLoopsThatMeetInAVertexApart) {
  const SurveyRecord record = RecordOf(5, {{0, 1}, {1, 2}, {2, 0}, {2, 3}, {3, 4}, {4, 2}});
  const auto groups = Group(record, {}, {{0, 1, 2}, {3, 4, 5}});
  ASSERT_THAT(groups, SizeIs(2));
  EXPECT_THAT(groups[0].edges, ElementsAre(0, 1, 2));
  EXPECT_THAT(groups[1].edges, ElementsAre(3, 4, 5));
}

TEST(ChainGroupsTest, TakesALoopWithoutAHoleToTheOneThatItMeets) {
  const SurveyRecord record = RecordOf(5, {{0, 1}, {1, 2}, {2, 0}, {2, 3}, {3, 4}, {4, 2}});
  const auto groups = Group(record, {}, {{0, 1, 2}});
  ASSERT_THAT(groups, SizeIs(1));
  EXPECT_THAT(groups[0].edges, SizeIs(6));
}

}  // namespace
}  // namespace tilemend
