#include "coordinator/plan/water/platforms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

namespace tilemend {
namespace {

constexpr double kStep = 1;  // metres between points along a shore

// A tower of 40 m, from `begin` to `end` along x, with a shelf on its east; ground at 3 m on both sides.
struct MadeTower {
  double begin = 20, end = 40;
  double shelf = 12, shelf_width = 6, height = 40;
};

// Two shores 30 m apart with the hole between them: the southern one runs east, the northern one west.
class PlatformsTest : public ::testing::Test {
 protected:
  void AddShore(double y, bool west, const std::vector<MadeTower>& towers, double ground = 3) {
    std::vector<Point3> shore;
    std::vector<ShorePoint> kinds;
    for (double x = 0; x <= 100; x += kStep) {
      shore.emplace_back(x, y, ground);
      kinds.push_back(ShorePoint::kGround);
      for (const MadeTower& t : towers) {
        const bool on_shelf = x >= t.end && x < t.end + t.shelf_width, on_tower = x >= t.begin && x < t.end;
        if (!on_shelf && !on_tower) continue;
        shore.back().z() = on_tower ? t.height : t.shelf;
        kinds.back() = ShorePoint::kOther;
      }
    }
    if (west) {
      std::ranges::reverse(shore);
      std::ranges::reverse(kinds);
    }
    const auto first = static_cast<int32_t>(points_.size());
    points_.insert(points_.end(), shore.begin(), shore.end());
    kinds_.insert(kinds_.end(), kinds.begin(), kinds.end());
    for (int32_t v = first; v + 1 < std::ssize(points_); ++v) edges_.push_back({v, v + 1});
  }

  std::vector<Point3> Platforms() const { return FindPlatforms(points_, kinds_, edges_); }

  std::vector<Point3> points_;
  std::vector<ShorePoint> kinds_;
  std::vector<DirectedEdge> edges_;
};

TEST_F(PlatformsTest, GoOnBetweenTowers) {
  AddShore(0, false, {MadeTower()});
  AddShore(30, true, {MadeTower()});
  int on_south = 0, on_north = 0, tops = 0, feet = 0;
  for (const Point3& p : Platforms()) {
    if (p.z() == 12) {
      EXPECT_GE(p.x(), 20) << p.transpose();
      EXPECT_LE(p.x(), 45) << p.transpose();
      const bool inside = p.y() > 0 && p.y() < 30;
      EXPECT_TRUE(!inside || p.x() == 20 || p.x() == 45) << p.transpose();
      tops += inside;
      on_south += p.y() == 0;
      on_north += p.y() == 30;
    } else {
      EXPECT_EQ(p.z(), 3) << p.transpose();
      EXPECT_TRUE(p.x() == 19.5 || p.x() == 45.5) << p.transpose();
      EXPECT_TRUE(p.y() > 0 && p.y() < 30) << p.transpose();
      ++feet;
    }
  }
  EXPECT_GE(on_south, 26);
  EXPECT_GE(on_north, 26);
  EXPECT_EQ(tops, 28);  // of two walls, every 2 m of 30
  EXPECT_EQ(feet, 28);
}

// The shelf may have been taken for ground.
TEST_F(PlatformsTest, AShelfThatIsGroundToOthersCounts) {
  AddShore(0, false, {MadeTower()});
  AddShore(30, true, {MadeTower()});
  const size_t all = Platforms().size();
  for (size_t v = 0; v < points_.size(); ++v) {
    if (points_[v].z() == 12) kinds_[v] = ShorePoint::kGround;
  }
  EXPECT_EQ(Platforms().size(), all);
}

TEST_F(PlatformsTest, EndWhereTheFirstTowerEndsIfThatHasNoShelfThere) {
  AddShore(0, false, {MadeTower()});
  AddShore(30, true, {MadeTower{.begin = 10}});
  const std::vector<Point3> platforms = Platforms();
  ASSERT_FALSE(platforms.empty());
  EXPECT_EQ(std::ranges::min(platforms, {}, [](const Point3& p) { return p.x(); }).x(), 19.5);
}

TEST_F(PlatformsTest, WallsRunFromOneShelfToTheOther) {
  AddShore(0, false, {MadeTower()});
  AddShore(30, true, {MadeTower{.end = 50}});
  const std::vector<Point3> platforms = Platforms();
  const auto in_the_middle = [](const Point3& p) { return p.z() == 12 && p.x() > 46 && p.y() > 1 && p.y() < 29; };
  const auto top = std::ranges::find_if(platforms, in_the_middle);
  ASSERT_NE(top, platforms.end());
  EXPECT_NEAR(top->x(), 45 + 10 * top->y() / 30, 1e-9);
}

TEST_F(PlatformsTest, ThereIsNoneWithoutAShelfAcross) {
  AddShore(0, false, {MadeTower()});
  AddShore(30, true, {MadeTower{.shelf_width = 0}});
  EXPECT_TRUE(Platforms().empty());
}

TEST_F(PlatformsTest, ThereIsNoneBetweenShelvesOfDifferentHeights) {
  AddShore(0, false, {MadeTower()});
  AddShore(30, true, {MadeTower{.shelf = 15}});
  EXPECT_TRUE(Platforms().empty());
}

TEST_F(PlatformsTest, ThereIsNoneBelowLowThings) {
  AddShore(0, false, {MadeTower{.height = 20}});
  AddShore(30, true, {MadeTower{.height = 20}});
  EXPECT_TRUE(Platforms().empty());
}

TEST_F(PlatformsTest, ThereIsNoneOnOneShore) {
  AddShore(0, false, {MadeTower(), MadeTower{.begin = 55, .end = 75}});
  AddShore(30, true, {});
  EXPECT_TRUE(Platforms().empty());
}

TEST_F(PlatformsTest, ThereIsNoneBetweenTowersThatDoNotFaceEachOther) {
  AddShore(0, false, {MadeTower()});
  AddShore(30, true, {MadeTower{.begin = 50, .end = 70}});
  EXPECT_TRUE(Platforms().empty());
}

TEST_F(PlatformsTest, ThereIsNoneFarAcross) {
  AddShore(0, false, {MadeTower()});
  AddShore(60, true, {MadeTower()});
  EXPECT_TRUE(Platforms().empty());
}

// Where there is no hole, but surface, between them.
TEST_F(PlatformsTest, ThereIsNoneBehindTowers) {
  AddShore(0, true, {MadeTower()});
  AddShore(30, false, {MadeTower()});
  EXPECT_TRUE(Platforms().empty());
}

// The points, in the reverse order, and edges, as another grid would number them.
TEST_F(PlatformsTest, TheyDoNotDependOnTheOrderOfShores) {
  const auto add_south = [&] { AddShore(0, false, {MadeTower()}); };
  const auto add_north = [&] {
    const size_t first = points_.size();
    AddShore(30, true, {MadeTower{.end = 50, .shelf = 13}, MadeTower{.begin = 70, .end = 85}});
    for (size_t v = first; v < points_.size(); ++v) points_[v].y() += points_[v].x() / 8;
  };
  add_south();
  add_north();
  const std::vector<Point3> platforms = Platforms();
  ASSERT_FALSE(platforms.empty());
  points_.clear(), kinds_.clear(), edges_.clear();
  add_north();
  add_south();
  EXPECT_EQ(Platforms(), platforms);
}

// As many metres in any direction.
TEST_F(PlatformsTest, TheyTurnWithTheShore) {
  AddShore(0, false, {MadeTower()});
  AddShore(30, true, {MadeTower{.begin = 10}});
  for (size_t v = points_.size() / 2; v < points_.size(); ++v) points_[v].y() += points_[v].x() / 8;
  std::vector<Point3> platforms = Platforms();
  ASSERT_FALSE(platforms.empty());
  for (Point3& p : points_) p.head<2>() *= -1;
  std::vector<Point3> turned = Platforms();
  for (Point3& p : turned) p.head<2>() *= -1;
  const auto by_place = [](const Point3& p) {
    return std::tuple(std::round(p.x() * 1e6), std::round(p.y() * 1e6), p.z());
  };
  std::ranges::sort(platforms, {}, by_place);
  std::ranges::sort(turned, {}, by_place);
  ASSERT_EQ(turned.size(), platforms.size());
  for (size_t i = 0; i < turned.size(); ++i)
    EXPECT_LT((turned[i] - platforms[i]).norm(), 1e-6) << turned[i].transpose();
}

// A quay of 5 km that counts as an object, two metres above the ground: level, but no shelf from any of its points.
// 5 km of quay with a tower at its end: quadratic in its points this would take minutes.
TEST_F(PlatformsTest, ALongLevelWayIsNoShelf) {
  constexpr int kPoints = 100000;
  for (int v = 0; v < kPoints; ++v) {
    const bool ground = v == 0 || v == kPoints - 1;
    points_.emplace_back(0.05 * v, 0, ground ? 3 : v > kPoints - 500 ? 40 : 5);
    kinds_.push_back(ground ? ShorePoint::kGround : ShorePoint::kOther);
    if (v > 0) edges_.push_back({v - 1, v});
  }
  EXPECT_TRUE(Platforms().empty());
}

TEST_F(PlatformsTest, NoShoreHasNone) { EXPECT_TRUE(Platforms().empty()); }

}  // namespace
}  // namespace tilemend
