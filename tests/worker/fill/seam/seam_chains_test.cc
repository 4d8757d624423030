#include "worker/fill/seam/seam_chains.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr uint8_t kVertical = 1, kCorner = 3;

RimVertex Vertex(double y, int32_t index, uint8_t lines) {
  RimVertex v;
  v.position = Point3(10, y, 0);
  v.index = index;
  v.lines = lines;
  v.size = 1;
  return v;
}

// A seam on x = 10 from an original vertex over three new ones, a grid corner and two new ones to another original.
// Holes on both sides have the first part, one on the west side alone has the second.
CellHoles OneSeam() {
  CellHoles cluster;
  cluster.vertices = {Vertex(0, 5, 0),          Vertex(1, -1, kVertical), Vertex(2, -1, kVertical),
                      Vertex(3, -1, kVertical), Vertex(4, -1, kCorner),   Vertex(5, -1, kVertical),
                      Vertex(6, -1, kVertical), Vertex(7, 6, 0)};
  CellHole west{0, true, {}}, east{1, true, {}};
  for (int32_t v = 0; v < 7; ++v) {
    west.segments.push_back({v, v + 1, true});
    if (v < 4) east.segments.push_back({v + 1, v, true});
  }
  east.segments.push_back({0, 7, false});
  cluster.holes = {west, east};
  return cluster;
}

TEST(SeamChainsTest, EndAtOriginalVerticesAndGridCorners) {
  const std::vector<SeamChain> chains = SeamChains(OneSeam());
  ASSERT_EQ(chains.size(), 2U);
  EXPECT_THAT(chains[0].vertices, ElementsAre(0, 1, 2, 3, 4));
  EXPECT_TRUE(chains[0].forward);
  EXPECT_TRUE(chains[0].backward);
  EXPECT_THAT(chains[1].vertices, ElementsAre(4, 5, 6, 7));
  EXPECT_TRUE(chains[1].forward);
  EXPECT_FALSE(chains[1].backward);
}

TEST(SeamChainsTest, EndWhereTheDirectionsChange) {
  CellHoles cluster = OneSeam();
  cluster.holes[1].segments.erase(cluster.holes[1].segments.begin());  // 1 -> 0
  const std::vector<SeamChain> chains = SeamChains(cluster);
  ASSERT_EQ(chains.size(), 3U);
  EXPECT_THAT(chains[0].vertices, ElementsAre(0, 1));
  EXPECT_THAT(chains[1].vertices, ElementsAre(1, 2, 3, 4));
}

TEST(SeamChainsTest, HolesWithoutSeamsHaveNone) {
  CellHoles cluster = OneSeam();
  for (CellHole& hole : cluster.holes) {
    for (RimSegment& s : hole.segments) s.seam = false;
  }
  EXPECT_THAT(SeamChains(cluster), IsEmpty());
}

TEST(ThinnedChainTest, KeepsTheEndsAndWhatIsFarApart) {
  const CellHoles cluster = OneSeam();
  const SeamChain chain = SeamChains(cluster)[0];
  EXPECT_THAT(ThinnedChain(cluster, chain, 0), ElementsAre(0, 1, 2, 3, 4));
  EXPECT_THAT(ThinnedChain(cluster, chain, 2), ElementsAre(0, 2, 4));
  EXPECT_THAT(ThinnedChain(cluster, chain, 100), ElementsAre(0, 4));
}

TEST(InterpolatedAlongTest, PassesThroughTheKnotsAndFollowsParabolas) {
  const auto parabola = [](double x) { return 3 - 2 * x + 0.7 * x * x; };
  const std::vector<double> knots = {0, 1, 3, 4.5, 9}, at = {0, 0.2, 1, 1.7, 3, 4, 5.5, 8.9, 9};
  std::vector<double> values;
  for (const double x : knots) values.push_back(parabola(x));
  const std::vector<double> result = InterpolatedAlong(knots, values, at);
  ASSERT_EQ(result.size(), at.size());
  for (size_t i = 0; i < at.size(); ++i) EXPECT_NEAR(result[i], parabola(at[i]), 1e-12) << at[i];
}

TEST(InterpolatedAlongTest, IsStraightBetweenTwoKnots) {
  const std::vector<double> knots = {2, 6}, values = {1, 3}, at = {2, 3, 6};
  EXPECT_THAT(InterpolatedAlong(knots, values, at), ElementsAre(1, 1.5, 3));
}

}  // namespace
}  // namespace tilemend
