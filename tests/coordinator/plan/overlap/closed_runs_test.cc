#include "coordinator/plan/overlap/closed_runs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <utility>
#include <vector>

namespace tilemend {
namespace {

constexpr Outline kTile{{0, 20, 0, 10}};

// Along the southern outline.
struct Profile {
  SurveyRecord record;
  std::vector<bool> on_outline;
  std::vector<OutlineGap> gaps;

  int32_t Add(double x, double z) {
    record.vertices.push_back({-1, {x, 0, z}});
    return static_cast<int32_t>(record.vertices.size()) - 1;
  }
  void AddRun(const std::vector<int32_t>& vertices) {
    for (size_t k = 1; k < vertices.size(); ++k) {
      record.edges.push_back({vertices[k - 1], vertices[k], 0});
      on_outline.push_back(true);
    }
  }
  void AddOpen(int32_t from, int32_t to) {
    gaps.push_back({from, to, record.vertices[from].position.x(), record.vertices[to].position.x()});
  }
  void AddClosed(int32_t from, int32_t to) { gaps.push_back({from, to, 0, 0, false}); }
  void Join() { JoinClosedRuns(record, on_outline, kTile, gaps); }
};

// A street, and a house with an overhang whose lower side lacks a face.
struct Overhang : Profile {
  int32_t street = Add(4, 3), eave = Add(12, 7), foot = Add(12.4, 3.6), niche = Add(13, 4), below = Add(13.2, 5.2);

  Overhang() {
    AddRun({Add(0, 3), street});
    AddRun({eave, Add(20, 7)});
    AddRun({foot, niche, below});
  }
};

TEST(ClosedRunsTest, TheStreetEndsAtTheFootBelowAnOverhang) {
  Overhang house;
  house.AddOpen(house.street, house.eave);
  house.AddClosed(house.below, house.foot);
  house.Join();
  EXPECT_EQ(house.gaps[0].to, house.foot);
  EXPECT_TRUE(house.gaps[0].open);
  EXPECT_EQ(std::pair(house.gaps[0].begin, house.gaps[0].end), std::pair(4.0, 12.4));
  EXPECT_EQ(house.gaps[1].to, house.eave);
  EXPECT_FALSE(house.gaps[1].open);
}

TEST(ClosedRunsTest, AnEaveAcrossTheStreetMakesNoDifference) {
  Overhang house;
  house.record.vertices[house.street].position.z() = 7;
  house.AddOpen(house.street, house.eave);
  house.AddClosed(house.below, house.foot);
  house.Join();
  EXPECT_EQ(house.gaps[0].to, house.foot);
}

// The hole is in the roof, above a niche of the street that lacks a face.
TEST(ClosedRunsTest, AGapInARoofEndsAtTheRoof) {
  Profile house;
  const int32_t roof = house.Add(4, 36), street = house.Add(15, 4), niche = house.Add(15.7, 7);
  const int32_t other_roof = house.Add(15.8, 36);
  house.AddRun({other_roof, house.Add(18, 36), house.Add(18, 7), niche});
  house.AddRun({street, house.Add(20, 4)});
  house.AddOpen(roof, street);
  house.AddOpen(niche, other_roof);
  house.Join();
  EXPECT_EQ(house.gaps[0].to, other_roof);
  EXPECT_EQ(house.gaps[1].to, street);
  EXPECT_TRUE(house.gaps[0].open);
  EXPECT_FALSE(house.gaps[1].open);
}

TEST(ClosedRunsTest, WhatStandsAboveTheStreetStaysClosedForItself) {
  Overhang house;
  house.record.vertices[house.eave].position.z() = 3;
  house.AddOpen(house.street, house.eave);
  for (const int32_t v : {house.foot, house.niche, house.below}) house.record.vertices[v].position.z() += 4;
  house.AddClosed(house.below, house.foot);
  house.Join();
  EXPECT_EQ(house.gaps[0].to, house.eave);
  EXPECT_EQ(house.gaps[1].to, house.foot);
}

// A house between two streets may not float, although that would be shorter.
TEST(ClosedRunsTest, ARunThatGapsLeadThroughStaysBetweenThem) {
  Profile house;
  const int32_t west = house.Add(4, 3), roof = house.Add(8, 20), eave = house.Add(9, 20), east = house.Add(14, 3);
  house.AddRun({roof, eave});
  house.AddOpen(west, roof);
  house.AddOpen(eave, east);
  house.Join();
  EXPECT_EQ(house.gaps[0].to, roof);
  EXPECT_EQ(house.gaps[1].to, east);
}

// A street, a rest of the ground below a tree, and the tree's lower side, which runs backward.
struct Tree : Profile {
  int32_t street = Add(4, 3.4), ground = Add(9.9, 3.1), crown = Add(11.5, 6.3), bend = Add(10.3, 6.5);
  int32_t trunk = Add(9.7, 7.2);

  Tree() {
    AddRun({Add(0, 3.4), street});
    AddRun({ground, Add(12.1, 3.7)});
    AddRun({crown, bend, trunk});
    AddOpen(street, crown);
    AddClosed(trunk, ground);
  }
};

TEST(ClosedRunsTest, TheStreetEndsAtTheGroundBelowATree) {
  Tree tree;
  tree.Join();
  EXPECT_EQ(tree.gaps[0].to, tree.ground);
  EXPECT_TRUE(tree.gaps[0].open);
  EXPECT_EQ(tree.gaps[1].to, tree.crown);
  EXPECT_FALSE(tree.gaps[1].open);
}

TEST(ClosedRunsTest, AHoleAboveARunEndsAtTheRun) {
  Tree tree;
  tree.Join();
  EXPECT_EQ(tree.gaps[0].along, std::vector<int32_t>());
  EXPECT_EQ(tree.gaps[1].along, std::vector<int32_t>({2, 3}));
  EXPECT_EQ(tree.gaps[1].link, std::pair(tree.trunk, tree.trunk));
}

TEST(ClosedRunsTest, AHoleEndsStraightWhereTheRunIsADetour) {
  Tree tree;
  tree.record.vertices[tree.bend].position.z() = 11;
  tree.Join();
  EXPECT_EQ(tree.gaps[1].to, tree.crown);
  EXPECT_EQ(tree.gaps[1].along, std::vector<int32_t>());
  EXPECT_EQ(tree.gaps[1].link, std::nullopt);
}

TEST(ClosedRunsTest, GapsThatEndOffTheOutlineStay) {
  Overhang house;
  house.AddOpen(house.street, house.eave);
  house.AddClosed(house.below, house.foot);
  house.record.vertices[house.eave].position.y() = 1;
  house.Join();
  EXPECT_EQ(house.gaps[0].to, house.eave);
  EXPECT_EQ(house.gaps[1].to, house.foot);
}

}  // namespace
}  // namespace tilemend
