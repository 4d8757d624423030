#include "common/mesh/edge_loops.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

std::vector<std::vector<int32_t>> EdgesOf(const std::vector<EdgeWalk>& walks) {
  std::vector<std::vector<int32_t>> edges;
  for (const EdgeWalk& walk : walks) edges.push_back(walk.edges);
  return edges;
}

// Loops over a few vertices, so that they touch and cross often; the edges in any order.
std::vector<DirectedEdge> RandomLoops(std::mt19937& random) {
  std::vector<DirectedEdge> edges;
  for (int loop = 0; loop < 6; ++loop) {
    std::vector<int32_t> vertices(3 + random() % 5);
    for (int32_t& v : vertices) v = static_cast<int32_t>(random() % 12);
    for (size_t k = 0; k < vertices.size(); ++k) edges.push_back({vertices[k], vertices[(k + 1) % vertices.size()]});
  }
  std::shuffle(edges.begin(), edges.end(), random);
  return edges;
}

void ExpectEachEdgeOnceHeadToTail(const std::vector<DirectedEdge>& edges, const std::vector<EdgeWalk>& walks) {
  std::vector<int> times(edges.size(), 0);
  for (const EdgeWalk& walk : walks) {
    for (size_t k = 0; k < walk.edges.size(); ++k) {
      ++times[walk.edges[k]];
      if (k > 0) {
        EXPECT_EQ(edges[walk.edges[k]].from, edges[walk.edges[k - 1]].to);
      }
    }
    if (walk.closed) {
      EXPECT_EQ(edges[walk.edges.back()].to, edges[walk.edges.front()].from);
    }
  }
  EXPECT_EQ(times, std::vector<int>(edges.size(), 1));
}

TEST(LinkEdgesTest, OfNoEdgesIsNothing) { EXPECT_THAT(LinkEdges({}), IsEmpty()); }

TEST(LinkEdgesTest, FindsALoopWhateverTheOrderOfItsEdges) {
  const std::vector<DirectedEdge> edges = {{7, 3}, {100, 7}, {3, 100}};
  const std::vector<EdgeWalk> walks = LinkEdges(edges);
  EXPECT_THAT(EdgesOf(walks), ElementsAre(ElementsAre(0, 2, 1)));
  EXPECT_TRUE(walks[0].closed);
}

TEST(LinkEdgesTest, KeepsALoopWholeThatPassesAVertexTwice) {
  const std::vector<DirectedEdge> eight = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {3, 4}, {4, 0}};
  const std::vector<EdgeWalk> walks = LinkEdges(eight);
  EXPECT_THAT(EdgesOf(walks), ElementsAre(ElementsAre(0, 1, 2, 3, 4, 5)));
  EXPECT_TRUE(walks[0].closed);
}

TEST(LinkEdgesTest, PrefersTheEdgeThatFollowsInTheList) {
  // Both 1 and 4 leave vertex 1.
  const std::vector<DirectedEdge> edges = {{0, 1}, {1, 0}, {2, 0}, {0, 1}, {1, 2}};
  EXPECT_THAT(EdgesOf(LinkEdges(edges)), ElementsAre(ElementsAre(0, 1, 3, 4, 2)));
}

TEST(LinkEdgesTest, BeginsChainsAtTheirHeads) {
  const std::vector<DirectedEdge> edges = {{5, 6}, {6, 5}, {2, 3}, {1, 2}};
  const std::vector<EdgeWalk> walks = LinkEdges(edges);
  EXPECT_THAT(EdgesOf(walks), ElementsAre(ElementsAre(3, 2), ElementsAre(0, 1)));
  EXPECT_FALSE(walks[0].closed);
  EXPECT_TRUE(walks[1].closed);
}

TEST(LinkEdgesTest, EndsAWalkWhereAllThatLeaveAreWalked) {
  // Two chains arrive at vertex 1, one edge leaves.
  const std::vector<EdgeWalk> walks = LinkEdges(std::vector<DirectedEdge>{{0, 1}, {1, 2}, {3, 1}});
  EXPECT_THAT(EdgesOf(walks), ElementsAre(ElementsAre(0, 1), ElementsAre(2)));
  EXPECT_FALSE(walks[1].closed);
}

TEST(LinkEdgesTest, OfAnEdgeFromAVertexToItselfIsALoop) {
  const std::vector<EdgeWalk> walks = LinkEdges(std::vector<DirectedEdge>{{4, 4}});
  ASSERT_THAT(walks, SizeIs(1));
  EXPECT_TRUE(walks[0].closed);
}

TEST(LinkEdgesTest, ClosesAllWalksWhereAsManyEdgesLeaveAsArrive) {
  std::mt19937 random(1);
  for (int round = 0; round < 200; ++round) {
    const std::vector<DirectedEdge> edges = RandomLoops(random);
    const std::vector<EdgeWalk> walks = LinkEdges(edges);
    ExpectEachEdgeOnceHeadToTail(edges, walks);
    for (const EdgeWalk& walk : walks) EXPECT_TRUE(walk.closed);
  }
}

TEST(LinkEdgesTest, TakesEachEdgeOnceWhereSomeAreMissing) {
  std::mt19937 random(2);
  for (int round = 0; round < 200; ++round) {
    std::vector<DirectedEdge> edges = RandomLoops(random);
    edges.resize(edges.size() - 1 - random() % 9);
    ExpectEachEdgeOnceHeadToTail(edges, LinkEdges(edges));
  }
}

TEST(LinkEdgesTest, TurnsAsItIsToldWhereLoopsTouch) {
  // Two loops in one list that touch at vertex 0: taken apart by running back into the loop that one came from.
  const std::vector<DirectedEdge> edges = {{0, 1}, {1, 0}, {0, 2}, {2, 0}};
  const std::vector<EdgeWalk> walks = LinkEdges(edges, [](int32_t edge, std::span<const int32_t> candidates) {
    EXPECT_TRUE(std::is_sorted(candidates.begin(), candidates.end()));
    return edge == 1 || edge == 3 ? *std::find(candidates.begin(), candidates.end(), edge - 1) : candidates[0];
  });
  EXPECT_THAT(EdgesOf(walks), ElementsAre(ElementsAre(0, 1), ElementsAre(2, 3)));
}

TEST(LinkEdgesTest, OffersTheFirstEdgeOfAWalkAndNoOtherThatIsWalked) {
  const std::vector<DirectedEdge> edges = {{0, 1}, {1, 0}, {0, 1}, {1, 0}};
  std::map<int32_t, std::vector<int32_t>> offered;
  LinkEdges(edges, [&](int32_t edge, std::span<const int32_t> candidates) {
    offered[edge].assign(candidates.begin(), candidates.end());
    return candidates.back();
  });
  EXPECT_THAT(offered[0], ElementsAre(1, 3));
  EXPECT_THAT(offered[3], ElementsAre(0, 2));
  EXPECT_THAT(offered[2], ElementsAre(1));
  EXPECT_THAT(offered[1], ElementsAre(0));
}

TEST(FollowEdgesTest, BeginsChainsAtTheirHeadsAndLoopsAtTheirLowestEdge) {
  const std::vector<EdgeWalk> walks = FollowEdges(std::vector<int32_t>{3, 0, -1, 1, 2, 5});
  EXPECT_THAT(EdgesOf(walks), ElementsAre(ElementsAre(4, 2), ElementsAre(0, 3, 1), ElementsAre(5)));
  EXPECT_FALSE(walks[0].closed);
  EXPECT_TRUE(walks[1].closed);
  EXPECT_TRUE(walks[2].closed);
}

TEST(FollowEdgesTest, WalksThePermutationThatLinkEdgesFound) {
  std::mt19937 random(3);
  for (int round = 0; round < 50; ++round) {
    const std::vector<DirectedEdge> edges = RandomLoops(random);
    const std::vector<EdgeWalk> walks = LinkEdges(edges);
    std::vector<int32_t> next(edges.size(), -1);
    for (const EdgeWalk& walk : walks) {
      for (size_t k = 0; k < walk.edges.size(); ++k) next[walk.edges[k]] = walk.edges[(k + 1) % walk.edges.size()];
    }
    EXPECT_EQ(EdgesOf(FollowEdges(next)), EdgesOf(walks));
  }
}

TEST(CutWhereItTouchesTest, LeavesASimpleLoopAsItIs) {
  const std::vector<int32_t> loop = {4, 2, 7};
  EXPECT_THAT(CutWhereItTouches<int32_t>(loop), ElementsAre(ElementsAre(4, 2, 7)));
  EXPECT_THAT(CutWhereItTouches<int32_t>({}), IsEmpty());
}

TEST(CutWhereItTouchesTest, CutsOffWhatLiesBetweenTwoPassages) {
  const std::vector<int32_t> eight = {0, 1, 2, 0, 3, 4};
  EXPECT_THAT(CutWhereItTouches<int32_t>(eight), ElementsAre(ElementsAre(0, 1, 2), ElementsAre(0, 3, 4)));
  const std::vector<int32_t> nested = {0, 1, 2, 3, 4, 2, 1, 5};
  EXPECT_THAT(CutWhereItTouches<int32_t>(nested),
              ElementsAre(ElementsAre(2, 3, 4), ElementsAre(1, 2), ElementsAre(0, 1, 5)))
      << "the way from 1 to 2 and back is a loop of two";
}

TEST(CutWhereItTouchesTest, KeepsEveryStep) {
  std::mt19937 random(5);
  for (int round = 0; round < 100; ++round) {
    std::vector<int32_t> loop(1 + random() % 30);
    for (int32_t& v : loop) v = static_cast<int32_t>(random() % 9);
    std::multiset<std::pair<int32_t, int32_t>> before, after;
    const auto add = [](const std::vector<int32_t>& l, std::multiset<std::pair<int32_t, int32_t>>& steps) {
      for (size_t i = 0; i < l.size(); ++i) steps.insert({l[i], l[(i + 1) % l.size()]});
    };
    add(loop, before);
    for (const std::vector<int32_t>& part : CutWhereItTouches<int32_t>(loop)) {
      add(part, after);
      EXPECT_EQ(std::set<int32_t>(part.begin(), part.end()).size(), part.size());
    }
    EXPECT_EQ(before, after);
  }
}

}  // namespace
}  // namespace tilemend
