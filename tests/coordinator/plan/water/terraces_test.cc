#include "coordinator/plan/water/terraces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace tilemend {
namespace {

// Shores that run east, as heights of points 2 m apart; `o` in `objects` stands on an object.
class TerracesTest : public ::testing::Test {
 protected:
  struct Run {
    size_t points;
    double height;
    char kind = ' ';
  };

  static constexpr Run kTower = {5, 30, 'o'};

  void AddShore(double y, const std::vector<Run>& runs) {
    size_t i = 0;
    for (const Run& run : runs) {
      for (size_t k = 0; k < run.points; ++k, ++i) {
        const auto v = static_cast<int32_t>(points_.size());
        points_.emplace_back(2.0 * static_cast<double>(i), y, run.height);
        kinds_.push_back(run.kind == 'o' ? ShorePoint::kOther : ShorePoint::kGround);
        if (i > 0) edges_.push_back({v - 1, v});
      }
    }
  }

  // All points of these heights are on terraces, and no others.
  void ExpectRaised(const std::vector<double>& heights) const {
    const std::vector<bool> raised = OnTerraces(points_, kinds_, edges_);
    ASSERT_EQ(raised.size(), points_.size());
    for (size_t v = 0; v < points_.size(); ++v) {
      const bool expected = std::ranges::find(heights, points_[v].z()) != heights.end();
      EXPECT_EQ(raised[v], expected) << points_[v].transpose();
    }
  }

  std::vector<Point3> points_;
  std::vector<ShorePoint> kinds_;
  std::vector<DirectedEdge> edges_;
};

TEST_F(TerracesTest, AStretchBetweenTowersAboveAllAroundIsOne) {
  AddShore(0, {{20, 3}, kTower, {15, 8}, kTower, {20, 3.5}});
  AddShore(30, {{55, 4}});
  ExpectRaised({8});
}

TEST_F(TerracesTest, ItGoesOnBehindATower) {
  AddShore(0, {{20, 3}, kTower, {5, 8}, kTower, {5, 8.5}, kTower, {20, 3.5}});
  ExpectRaised({8, 8.5});
}

TEST_F(TerracesTest, ItMayEndWithTheShore) {
  AddShore(0, {{30, 3}, kTower, {15, 8}});
  AddShore(30, {{50, 3}});
  ExpectRaised({8});
}

TEST_F(TerracesTest, AWallThatIsSeenIsAStepOfTheGround) {
  AddShore(0, {{20, 3}, kTower, {15, 8}, {20, 3.5}});
  ExpectRaised({});
}

TEST_F(TerracesTest, AShortStretchIsNone) {
  AddShore(0, {{20, 3}, kTower, {6, 8}, kTower, {20, 3}});
  ExpectRaised({});
}

TEST_F(TerracesTest, ALowStretchIsNone) {
  AddShore(0, {{20, 3}, kTower, {15, 5.5}, kTower, {20, 3}});
  ExpectRaised({});
}

TEST_F(TerracesTest, AStepOnTheWayUpIsNone) {
  AddShore(0, {{20, 3}, kTower, {15, 8}, kTower, {20, 14}, {20, 3}});
  ExpectRaised({});
}

TEST_F(TerracesTest, WhereMostGroundIsAsHighItIsNone) {
  AddShore(0, {{10, 3}, kTower, {30, 8}, kTower, {10, 3}});
  ExpectRaised({});
}

TEST_F(TerracesTest, WhereTheOtherShoreIsAsHighItIsNone) {
  AddShore(0, {{10, 3}, kTower, {15, 8}, kTower, {10, 3}});
  AddShore(20, {{80, 7.5}});
  ExpectRaised({});
}

TEST_F(TerracesTest, TwoThatFaceEachOtherAreBoth) {
  AddShore(0, {{20, 3}, kTower, {15, 8}, kTower, {20, 3}});
  AddShore(20, {{20, 3}, kTower, {15, 7.5}, kTower, {20, 3}});
  ExpectRaised({8, 7.5});
}

TEST_F(TerracesTest, ShortStretchesNearOneAreScrapsOfIt) {
  AddShore(0, {{20, 3}, kTower, {15, 8}, kTower, {2, 12}, kTower, {20, 3.5}});
  ExpectRaised({8, 12});
}

TEST_F(TerracesTest, LowScrapsAndThoseFarAwayStay) {
  AddShore(0, {{20, 3}, kTower, {15, 8}, kTower, {2, 5}, {22, 30, 'o'}, {2, 12}, kTower, {20, 3.5}});
  AddShore(30, {{50, 3}});
  ExpectRaised({8});
}

TEST_F(TerracesTest, NoShoreHasNone) { ExpectRaised({}); }

}  // namespace
}  // namespace tilemend
