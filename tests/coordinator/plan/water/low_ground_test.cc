#include "coordinator/plan/water/low_ground.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "tests/support/surveyed_scene.h"

namespace tilemend {
namespace {

// A hole of 10 x 10 squares of 1 m in the middle of 40 x 40, and the share around it that is lower than its rim.
double ShareAround(const HeightFunction& height, double noise = 0.1) {
  std::vector<std::string> picture(40, std::string(40, '#'));
  for (int row = 15; row < 25; ++row) picture[row].replace(15, 10, 10, '.');
  SurveyedScene scene = PictureScene(picture, 40, height);
  Shore shore;
  shore.mean_edge = 1;
  shore.noise = noise;
  for (double k = 15.5; k < 25; ++k) {
    for (const Point2& p : {Point2(k, 15), Point2(k, 25), Point2(15, k), Point2(25, k)}) {
      shore.edges.emplace_back(p.x(), p.y(), 5);
    }
  }
  return GroundAroundShores(Plan(), scene.Input(), std::vector<Shore>{shore})[0].low;
}

// Ten edges along y = 0, at a height of 5.
Shore StraightShore() {
  Shore shore;
  shore.mean_edge = 1;
  for (double k = 0.5; k < 10; ++k) shore.edges.emplace_back(k, 0, 5);
  return shore;
}

// The record of a tile there without a band.
StoredRecord SomewhereAt(double x, double y) {
  SurveyRecord record;
  record.vertex_count = 1;
  record.lo = record.hi = Point3(x, y, 5);
  return StoredRecord(std::make_shared<const SurveyRecord>(record));
}

TEST(GroundAroundShoresTest, IsTheShareOfTheSurfaceAround) {
  EXPECT_EQ(ShareAround([](double, double) { return 6; }), 0);
  EXPECT_EQ(ShareAround([](double, double) { return 4; }), 1);
  EXPECT_NEAR(ShareAround([](double x, double) { return x < 20 ? 4 : 6; }), 0.5, 0.1);
}

// A street between houses: each square counts once, by its lowest vertex, wherever the lattice of squares lies.
TEST(GroundAroundShoresTest, RoofsDoNotCount) {
  for (const double shift : {0.0, 0.4, 0.7, 1.1}) {
    const auto every_third_row_is_street = [&](double, double y) {
      return std::fmod(y + shift + 9, 3) < 1 ? 5.05 : 12;
    };
    EXPECT_EQ(ShareAround(every_third_row_is_street), 1);
  }
  EXPECT_EQ(ShareAround([](double, double) { return 12; }), 0);
}

// A row of squares among 27 is no street.
TEST(GroundAroundShoresTest, AFewLowSquaresDoNotCount) {
  for (const double shift : {0.0, 0.4, 0.7, 1.1}) {
    EXPECT_EQ(ShareAround([&](double x, double y) { return y < 5 + shift && x < 16 ? 5 : 12; }), 0);
  }
}

TEST(GroundAroundShoresTest, FiveSquaresWithGroundTell) {
  Shore shore;
  shore.mean_edge = 1;
  for (double k = 0; k < 30; ++k) shore.edges.emplace_back(k, 0, 5);
  for (const int32_t squares : {4, 5}) {
    PlanInput input;
    RimGround& rim = input.rim_ground[{0, 0}];
    rim.side = 3;
    for (int32_t col = 0; col < squares; ++col) rim.around.push_back({col, 3, 5});
    input.cells[{0, 0}] = SomewhereAt(15, 0);
    EXPECT_EQ(GroundAroundShores(Plan(), input, std::vector<Shore>{shore})[0].low, squares == 5 ? 1 : 0);
  }
}

// The surface rises by 2 cm per metre: a bank, unless the heights are as rough as that.
TEST(GroundAroundShoresTest, NoiseIsNoHigher) {
  const auto bank = [](double x, double y) { return 5 + 0.02 * std::max({15 - x, x - 25, 15 - y, y - 25, 0.0}); };
  EXPECT_LT(ShareAround(bank, 0.02), 0.15);
  EXPECT_EQ(ShareAround(bank, 0.2), 1);
}

// East of the hole its rim is a quay: what lies behind that does not count.
TEST(GroundAroundShoresTest, SurfaceBehindQuaysDoesNotCount) {
  std::vector<std::string> picture(40, std::string(40, '#'));
  for (int row = 15; row < 25; ++row) picture[row].replace(15, 10, 10, '.');
  SurveyedScene scene = PictureScene(picture, 40, [](double x, double) { return x < 24 ? 6 : 4; });
  Shore shore;
  shore.mean_edge = 1;
  for (double k = 15.5; k < 25; ++k) {
    for (const Point2& p : {Point2(k, 15), Point2(k, 25), Point2(15, k)}) shore.edges.emplace_back(p.x(), p.y(), 5);
    shore.edges.emplace_back(25, k, std::numeric_limits<double>::quiet_NaN());
  }
  EXPECT_LT(GroundAroundShores(Plan(), scene.Input(), std::vector<Shore>{shore})[0].low, 0.25);
}

// With edges of 6 m the squares do not reach far enough, and bands tell: there are none.
TEST(GroundAroundShoresTest, LongEdgesAskForMoreThanSquares) {
  Shore shore;
  shore.mean_edge = 6;
  for (double k = 3; k < 60; k += 6) shore.edges.emplace_back(k, 0, 5);
  PlanInput input;
  RimGround& rim = input.rim_ground[{0, 0}];
  rim.side = 3;
  for (int32_t col = 0; col < 20; ++col) rim.around.push_back({col, 3, 5});
  input.cells[{0, 0}] = SomewhereAt(30, 0);
  EXPECT_EQ(GroundAroundShores(Plan(), input, std::vector<Shore>{shore})[0].low, 0);
  shore.mean_edge = 4;
  EXPECT_EQ(GroundAroundShores(Plan(), input, std::vector<Shore>{shore})[0].low, 1);
}

// Lidar has a vertex in each square metre: bands of two rings of triangles tell of no street behind a house.
TEST(GroundAroundShoresTest, GroundBeyondTheBandsCounts) {
  Shore shore = StraightShore();
  PlanInput input;
  input.cells[{0, 0}] = SomewhereAt(5, 0);
  RimGround& rim = input.rim_ground[{0, 0}];
  rim.side = 3;
  for (int32_t col = 0; col < 4; ++col) {
    rim.around.push_back({col, -3, 5.02F});
    rim.around.push_back({col, 0, 5});  // at the shore
    rim.around.push_back({col, 2, 4.9F});
    rim.around.push_back({col, 3, 8});
  }
  EXPECT_NEAR(GroundAroundShores(Plan(), input, std::vector<Shore>{shore})[0].low, 2.0 / 3, 1e-9) << "8 of 12";
  for (GroundSquare& square : rim.around) square.height += 0.4F;
  for (const double noise : {0.0, 0.2}) {  // of crowns above the shore
    shore.noise = noise;
    EXPECT_NEAR(GroundAroundShores(Plan(), input, std::vector<Shore>{shore})[0].low, 0, 1e-9) << noise;
  }
}

// A rim of crowns: the ground of the wood lies far below.
TEST(GroundAroundShoresTest, GroundBelowTheRimIsSunk) {
  Shore shore = StraightShore();
  shore.noise = 0.3;
  PlanInput input;
  input.cells[{0, 0}] = SomewhereAt(5, 0);
  RimGround& rim = input.rim_ground[{0, 0}];
  rim.side = 3;
  for (int32_t col = 0; col < 4; ++col) {
    rim.around.push_back({col, -3, 4.2F});
    rim.around.push_back({col, 2, 4});
    rim.around.push_back({col, 3, 4});
  }
  EXPECT_NEAR(GroundAroundShores(Plan(), input, std::vector<Shore>{shore})[0].sunk, 2.0 / 3, 1e-9);
  EXPECT_EQ(GroundAroundShores(Plan(), input, std::vector<Shore>{shore})[0].low, 1);
}

TEST(GroundAroundShoresTest, WithoutSurfaceAroundNothingIsKnown) {
  Shore shore;
  shore.mean_edge = 1;
  shore.edges = {Point3(0, 0, 5)};
  EXPECT_EQ(GroundAroundShores(Plan(), PlanInput(), std::vector<Shore>{shore})[0].low, 0);
}

}  // namespace
}  // namespace tilemend
