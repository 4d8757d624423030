#include "common/mesh/disjoint_sets.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <utility>
#include <vector>

namespace tilemend {
namespace {

using ::testing::ElementsAre;

TEST(DisjointSetsTest, BeginsWithEachThingAlone) { EXPECT_THAT(DisjointSets(3).Groups(), ElementsAre(0, 1, 2)); }

TEST(DisjointSetsTest, NamesAGroupByItsLowestThing) {
  DisjointSets sets(6);
  sets.Join(5, 3);
  sets.Join(3, 4);
  EXPECT_EQ(sets.LowestOf(5), 3);
  EXPECT_EQ(sets.LowestOf(4), 3);
  sets.Join(4, 1);
  EXPECT_EQ(sets.LowestOf(5), 1);
  EXPECT_THAT(sets.Groups(), ElementsAre(0, 1, 2, 1, 1, 1));
}

TEST(DisjointSetsTest, GroupsDoNotDependOnTheOrderOfJoining) {
  std::mt19937 random(1);
  std::vector<std::pair<int32_t, int32_t>> pairs;
  for (int k = 0; k < 60; ++k) pairs.emplace_back(random() % 100, random() % 100);
  std::vector<int32_t> first;
  for (int round = 0; round < 20; ++round) {
    DisjointSets sets(100);
    for (const auto& [a, b] : pairs) sets.Join(a, b);
    const std::vector<int32_t> groups = sets.Groups();
    for (const auto& [a, b] : pairs) EXPECT_EQ(groups[a], groups[b]);
    if (round == 0) first = groups;
    EXPECT_EQ(groups, first);
    std::shuffle(pairs.begin(), pairs.end(), random);
    for (auto& [a, b] : pairs) std::swap(a, b);
  }
  // 100 things and at most 60 joins.
  EXPECT_GE(*std::max_element(first.begin(), first.end()), 39);
}

}  // namespace
}  // namespace tilemend
