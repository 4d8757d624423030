#include "coordinator/plan/overlap/lowest_heights.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <vector>

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Pair;

// The outline of a tile whose north side is at y = 10.
class LowestHeightsTest : public testing::Test {
 protected:
  void Add(const std::vector<Point3>& loop) {
    const auto first = static_cast<int32_t>(record_.vertices.size()), count = static_cast<int32_t>(loop.size());
    for (int32_t k = 0; k < count; ++k) {
      record_.vertices.emplace_back().position = loop[k];
      BoundaryEdge& edge = record_.edges.emplace_back();
      edge.from = first + k;
      edge.to = first + (k + 1) % count;
    }
  }

  // A piece that reaches the north side between two places.
  void AddPiece(double from, double to, double height) {
    Add({{from, 0, height}, {to, 0, height}, {to, 10, height}, {from, 10, height}});
  }

  std::map<double, double> AtNorth() const {
    return LowestHeights(record_, 0, [](const Point3& p) { return p.y() >= 10; });
  }

  SurveyRecord record_;
};

TEST_F(LowestHeightsTest, HasTheVerticesBeyondTheLine) {
  EXPECT_THAT(AtNorth(), IsEmpty());
  Add({{0, 0, 1}, {9, 0, 2}, {9, 10, 3}, {4, 10.5, 4}, {0, 10, 5}});
  EXPECT_THAT(AtNorth(), ElementsAre(Pair(0, 5), Pair(4, 4), Pair(9, 3)));
}

TEST_F(LowestHeightsTest, LeavesOutAnEaveOverTheStreet) {
  AddPiece(0, 9, 1);
  AddPiece(3, 5, 8);
  EXPECT_THAT(AtNorth(), ElementsAre(Pair(0, 1), Pair(9, 1)));
}

TEST_F(LowestHeightsTest, LeavesOutTheRoofAboveAPassage) {
  AddPiece(3, 5, -7);
  Add({{0, 0, 1}, {9, 0, 1}, {9, 10, 1}, {4, 10, 1}, {0, 10, 1}});
  EXPECT_THAT(AtNorth(), ElementsAre(Pair(0, 1), Pair(3, -7), Pair(5, -7), Pair(9, 1)));
}

TEST_F(LowestHeightsTest, TakesTheLowerOfTwoVerticesInOnePlace) {
  AddPiece(0, 9, 4);
  AddPiece(0, 9, 1);
  AddPiece(0, 9, 6);
  EXPECT_THAT(AtNorth(), ElementsAre(Pair(0, 1), Pair(9, 1)));
}

// Edges that cross each other, against all vertices over all edges.
TEST_F(LowestHeightsTest, IsTheSameAsLookingAtEachPairOfVertexAndEdge) {
  std::mt19937 random(1);
  const auto next = [&](int32_t count) { return static_cast<double>(random() % static_cast<uint32_t>(count)); };
  for (int round = 0; round < 20; ++round) {
    record_ = {};
    for (int k = 0; k < 40; ++k) {
      const double from = next(50), height = next(100);
      Add({{from, 10, height}, {from + 1 + next(20), 11, next(100)}, {from, 0, height}});
    }
    std::map<double, double> expected;
    for (const BoundaryVertex& v : record_.vertices) {
      if (v.position.y() < 10) continue;
      const double t = v.position.x(), z = v.position.z();
      const bool is_above = std::ranges::any_of(record_.edges, [&](const BoundaryEdge& e) {
        const Point3 &a = record_.vertices[e.from].position, &b = record_.vertices[e.to].position;
        const double share = (t - a.x()) / (b.x() - a.x());
        return a.y() >= 10 && b.y() >= 10 && share > 0 && share < 1 && a.z() + share * (b.z() - a.z()) < z - 0.002;
      });
      if (is_above) continue;
      double& lowest = expected.emplace(t, z).first->second;
      lowest = std::min(lowest, z);
    }
    EXPECT_EQ(AtNorth(), expected);
    EXPECT_LT(expected.size(), 45) << "some are left out";
  }
}

}  // namespace
}  // namespace tilemend
