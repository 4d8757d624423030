#include "coordinator/plan/overlap/lowest_heights.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
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

}  // namespace
}  // namespace tilemend
