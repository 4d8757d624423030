#include "coordinator/plan/water/raised_levels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>
#include <string>
#include <vector>

namespace tilemend {
namespace {

// A shore that runs east, as the heights of points 2 m apart; `o` in `kinds` stands on an object.
std::vector<bool> RaisedAlong(const std::vector<double>& heights, const std::string& objects = "") {
  std::vector<Point3> points;
  std::vector<ShorePoint> kinds;
  std::vector<DirectedEdge> edges;
  for (size_t i = 0; i < heights.size(); ++i) {
    points.emplace_back(2.0 * static_cast<double>(i), 0, heights[i]);
    kinds.push_back(i < objects.size() && objects[i] == 'o' ? ShorePoint::kOther : ShorePoint::kGround);
    if (i > 0) edges.push_back({static_cast<int32_t>(i) - 1, static_cast<int32_t>(i)});
  }
  return OnRaisedLevels(points, kinds, edges);
}

std::vector<double> Joined(std::initializer_list<std::vector<double>> stretches) {
  std::vector<double> all;
  for (const std::vector<double>& s : stretches) all.insert(all.end(), s.begin(), s.end());
  return all;
}

std::vector<double> Level(size_t points, double height) { return std::vector<double>(points, height); }

// Of the points from `first` on `count` are raised, and no others.
void ExpectRaised(const std::vector<bool>& raised, ptrdiff_t first, ptrdiff_t count) {
  for (ptrdiff_t i = 0; i < std::ssize(raised); ++i) EXPECT_EQ(raised[i], i >= first && i < first + count) << i;
}

TEST(RaisedLevelsTest, ARoofBetweenTwoWallsIs) {
  ExpectRaised(RaisedAlong(Joined({Level(20, 3), Level(15, 25), Level(20, 4)})), 20, 15);
}

TEST(RaisedLevelsTest, ALowTerraceIsNot) {
  ExpectRaised(RaisedAlong(Joined({Level(20, 3), Level(15, 8), Level(20, 4)})), 0, 0);
}

TEST(RaisedLevelsTest, AHillThatNoWallBoundsIsNot) {
  std::vector<double> hill;
  for (int i = 0; i <= 40; ++i) hill.push_back(std::min(i, 40 - i) * 1.1);
  ExpectRaised(RaisedAlong(hill), 0, 0);
}

TEST(RaisedLevelsTest, GroundBesideAPitIsNot) {
  ExpectRaised(RaisedAlong(Joined({Level(30, 20), Level(8, 0), Level(25, 20)})), 0, 0);
}

// The walls' heights count: down into a pit, up again, and up to a roof.
TEST(RaisedLevelsTest, HeightsAddUpOverSeveralWalls) {
  ExpectRaised(RaisedAlong(Joined({Level(30, 20), Level(8, 0), Level(10, 20), Level(9, 40), Level(3, 60)})), 48, 12);
}

TEST(RaisedLevelsTest, TheGroundGoesOnBehindATree) {
  const std::string tree = std::string(10, ' ') + "ooo";
  ExpectRaised(RaisedAlong(Joined({Level(10, 3), {9, 12, 8}, Level(7, 4), Level(15, 25), Level(2, 4)}), tree), 20, 15);
}

// The roof is longer than the ground on either side, but not than both.
TEST(RaisedLevelsTest, MostOfTheShoreIsGround) {
  ExpectRaised(RaisedAlong(Joined({Level(12, 3), Level(15, 25), Level(10, 4)})), 12, 15);
  ExpectRaised(RaisedAlong(Joined({Level(12, 3), Level(40, 25), Level(10, 4)})), 0, 0);
}

// A house of 8 m hides the wall: nothing tells which of both sides is ground.
TEST(RaisedLevelsTest, BehindAnObjectWithAnotherHeightNothingIsKnown) {
  const std::string house = std::string(10, ' ') + std::string(8, 'o');
  ExpectRaised(RaisedAlong(Joined({Level(10, 3), Level(8, 12), Level(10, 11)}), house), 0, 0);
}

// Two shores that run east, 20 m apart; the northern one ends at the edge of the area on a roof, after a ledge. And
// farther off the end of a third one, on a roof as high.
class EndsOfShoreTest : public ::testing::Test {
 protected:
  EndsOfShoreTest() {
    Add(0, Joined({Level(40, 3)}), "");
    Add(20, Joined({Level(20, 3), Level(2, 12), Level(1, 11), Level(2, 20), Level(5, 25)}),
        std::string(20, ' ') + "oo oo");
    Add(60, {25, 25, 25}, "");
  }

  void Add(double y, const std::vector<double>& heights, const std::string& objects) {
    for (size_t i = 0; i < heights.size(); ++i) {
      const auto v = static_cast<int32_t>(points_.size());
      points_.emplace_back(2.0 * static_cast<double>(i) + (y == 60 ? 56 : 0), y, heights[i]);
      kinds_.push_back(i < objects.size() && objects[i] == 'o' ? ShorePoint::kOther : ShorePoint::kGround);
      if (i > 0) edges_.push_back({v - 1, v});
    }
    ends_.push_back(static_cast<int32_t>(points_.size()) - 1);
  }

  std::vector<Point3> points_;
  std::vector<ShorePoint> kinds_;
  std::vector<DirectedEdge> edges_;
  std::vector<int32_t> ends_;
};

TEST_F(EndsOfShoreTest, RoofsThereAreRaisedAndTheLedgeBelow) {
  const std::vector<bool> raised = OnRaisedLevels(points_, kinds_, edges_, ends_);
  for (size_t v = 0; v < raised.size(); ++v) {
    const bool roof = points_[v].z() == 25 || points_[v].z() == 11;
    EXPECT_EQ(raised[v], roof) << points_[v].transpose();
  }
}

TEST_F(EndsOfShoreTest, ShoresThatGoOnAreNotComparedAcross) {
  ExpectRaised(OnRaisedLevels(points_, kinds_, edges_), 0, 0);
}

TEST(RaisedLevelsTest, NothingIsWithoutEdges) {
  EXPECT_TRUE(OnRaisedLevels({}, {}, {}).empty());
  const std::vector<Point3> points = {{0, 0, 0}, {1, 0, 90}};
  const std::vector<ShorePoint> kinds(2, ShorePoint::kGround);
  EXPECT_EQ(OnRaisedLevels(points, kinds, {}), std::vector<bool>(2, false));
}

}  // namespace
}  // namespace tilemend
