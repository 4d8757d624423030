#include "worker/fill/surface/walled_ground.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "tests/worker/fill/surface/plates.h"
#include "worker/fill/hole/cell_band.h"

namespace tilemend {
namespace {

using testing::Everywhere;
using testing::kHalf;
using testing::MakePlate;
using testing::Nowhere;
using testing::Plate;

const GroundTrend kLevel{{0, 0}, 0.1};

bool IsOnRim(const Point3& p) { return p.head<2>().cwiseAbs().maxCoeff() == kHalf; }

// Every known point of the patch is a reading.
std::vector<RimReading> AllReadings(const ThinPlateProblem& problem) {
  std::vector<RimReading> readings;
  for (const Point3& p : problem.points) readings.push_back(IsOnRim(p) ? RimReading::kReading : RimReading::kNothing);
  return readings;
}

double HeightAt(const Plate& plate, double x, double y) { return plate.problem.points[plate.at.at({x, y})].z(); }

// Readings at the rim of a square, in a plate without band.
Plate RimOf(const HeightFunction& height) {
  Plate plate = MakePlate(
      height, [](double x, double y) { return std::max(std::abs(x), std::abs(y)) <= kHalf; }, Nowhere);
  return plate;
}

TEST(WalledGroundTest, APlaneGoesOn) {
  const GroundTrend trend{{0.3, -0.2}, 0.1};
  const auto plane = [](double x, double y) { return 7 + 0.3 * x - 0.2 * y; };
  Plate plate = RimOf(plane);
  ASSERT_TRUE(SolveWalledGround(AllReadings(plate.problem), trend, plate.problem));
  EXPECT_LT(testing::LargestError(plate, plane), 1e-6);
}

// Half of the rim are feet of walls, which stand up to half a metre above the street.
TEST(WalledGroundTest, FeetOfWallsDoNotLiftTheStreet) {
  const auto feet = [](double x, double y) {
    const auto place = static_cast<int64_t>(std::lround(13 * x + 7 * y));
    return 3 + (place % 2 == 0 ? 0 : 0.1 * static_cast<double>(1 + std::abs(place) % 5));
  };
  Plate plate = RimOf(feet);
  double mean = 0, count = 0;
  for (const Point3& p : plate.problem.points) {
    if (IsOnRim(p)) mean += feet(p.x(), p.y()), ++count;
  }
  ASSERT_GT(mean / count, 3.1);
  ASSERT_TRUE(SolveWalledGround(AllReadings(plate.problem), kLevel, plate.problem));
  for (const Point3& p : plate.problem.points) {
    if (IsOnRim(p)) continue;
    EXPECT_NEAR(p.z(), 3, 0.06) << p.transpose();
  }
}

// A roof and a street: two squares that a gap of four metres joins.
TEST(WalledGroundTest, AWallStandsWhereItIsShortest) {
  const auto keep = [](double x, double y) {
    return std::max(std::abs(x), std::abs(y)) <= kHalf && (std::abs(x) > 1 || std::abs(y) <= 2);
  };
  const auto height = [](double x, double) { return x < 0 ? 12.0 : 3.0; };
  Plate plate = MakePlate(height, keep, [](double x, double y) { return std::abs(x) <= 1 && std::abs(y) == 2; });
  std::vector<RimReading> readings;
  for (size_t v = 0; v < plate.problem.points.size(); ++v) {
    const bool is_roof = plate.problem.points[v].x() < 0;
    readings.push_back(!plate.problem.known[v] ? RimReading::kNothing
                       : is_roof               ? RimReading::kFixed
                                               : RimReading::kReading);
  }
  ASSERT_TRUE(SolveWalledGround(readings, kLevel, plate.problem));
  for (const Point3& p : plate.problem.points) {
    if (std::abs(p.x()) < 3) continue;
    EXPECT_NEAR(p.z(), height(p.x(), 0), 0.3) << p.transpose();
  }
}

// What lies lower counts three times as much as what stands higher.
TEST(WalledGroundTest, BetweenTwoLevelsTheLowerOneIsTheGround) {
  Plate plate = RimOf([](double x, double) { return x <= -kHalf + 4 ? 0.9 : 3.4; });
  ASSERT_TRUE(SolveWalledGround(AllReadings(plate.problem), kLevel, plate.problem));
  EXPECT_LT(HeightAt(plate, 4, 0), 1.9);
}

TEST(WalledGroundTest, APartHasTheSurfaceOfTheWhole) {
  const auto rim = [](double x, double y) { return 3 + 0.4 * std::sin(1.3 * x + 2.1 * y) + (x > 3 ? 2 : 0); };
  Plate whole = RimOf(rim);
  ASSERT_TRUE(SolveWalledGround(AllReadings(whole.problem), kLevel, whole.problem));
  Plate part = MakePlate(
      rim, [](double x, double y) { return std::max(std::abs(x), std::abs(y)) <= kHalf && x >= 0; },
      [](double x, double) { return x == 0; });
  std::vector<RimReading> readings;
  for (size_t v = 0; v < part.problem.points.size(); ++v) {
    Point3& p = part.problem.points[v];
    const bool is_edge = IsOnRim(p) || p.x() == 0;
    if (is_edge) p.z() = HeightAt(whole, p.x(), p.y());
    readings.push_back(is_edge ? RimReading::kFixed : RimReading::kNothing);
  }
  ASSERT_TRUE(SolveWalledGround(readings, kLevel, part.problem));
  for (const Point3& p : part.problem.points) EXPECT_NEAR(p.z(), HeightAt(whole, p.x(), p.y()), 0.02) << p.transpose();
}

TEST(WalledGroundTest, AllHeightsAreKnownThenAndNoBandIsLeft) {
  Plate plate = MakePlate([](double, double) { return 1.0; }, Everywhere, Nowhere);
  std::vector<RimReading> readings = AllReadings(plate.problem);
  ASSERT_TRUE(SolveWalledGround(readings, kLevel, plate.problem));
  EXPECT_TRUE(plate.problem.band.empty());
  for (size_t v = 0; v < plate.problem.points.size(); ++v) {
    EXPECT_TRUE(plate.problem.known[v]);
    EXPECT_FALSE(plate.problem.has_equation[v]);
  }
}

TEST(WalledGroundTest, WithoutAnyReadingThereIsNoSurface) {
  Plate plate = RimOf([](double, double) { return 1.0; });
  plate.problem.known.assign(plate.problem.points.size(), false);
  const std::vector<RimReading> nothing(plate.problem.points.size(), RimReading::kNothing);
  EXPECT_FALSE(SolveWalledGround(nothing, kLevel, plate.problem));
}

// Of two parts that share no point one has objects alone, of which no ground is known.
TEST(WalledGroundTest, APartWithoutReadingsKeepsItsRim) {
  Plate plate = MakePlate([](double x, double) { return x < 0 ? 20.0 : 3.0; },
                          [](double x, double y) { return std::max(std::abs(x), std::abs(y)) <= kHalf && x != 0; },
                          [](double x, double) { return std::abs(x) == 1; });
  std::vector<RimReading> readings;
  for (size_t v = 0; v < plate.problem.points.size(); ++v) {
    const bool is_read = plate.problem.known[v] && plate.problem.points[v].x() > 0;
    readings.push_back(is_read ? RimReading::kReading : RimReading::kNothing);
  }
  for (size_t v = 0; v < readings.size(); ++v) {
    if (!plate.problem.known[v]) plate.problem.points[v].z() = 0;
  }
  ASSERT_TRUE(SolveWalledGround(readings, kLevel, plate.problem));
  for (const Point3& p : plate.problem.points) EXPECT_NEAR(p.z(), p.x() < 0 ? 20 : 3, 1e-6) << p.transpose();
}

TEST(WalledGroundTest, TheTrendIsThatOfTheBandWithoutItsWalls) {
  Plate plate =
      MakePlate([](double x, double y) { return 0.3 * x - 0.2 * y + (x > kHalf ? 40 : 0); }, Everywhere, Nowhere);
  const GroundTrend trend = TrendOf(plate.problem);
  EXPECT_NEAR(trend.slope.x(), 0.3, 1e-9);
  EXPECT_NEAR(trend.slope.y(), -0.2, 1e-9);
  EXPECT_NEAR(trend.steepness, 0.02, 1e-9);
  const auto rough = [](double x, double y) { return std::sin(2 * x) * std::sin(3 * y); };
  EXPECT_NEAR(TrendOf(MakePlate(rough, Everywhere, Nowhere).problem).steepness, 0.1, 1e-9);
  plate.problem.band.clear();
  EXPECT_DOUBLE_EQ(TrendOf(plate.problem).steepness, 0.1);
}

// A rim of 40 vertices, of which `objects` stand on objects.
bool HasWallsWith(int objects, double tension, double slope) {
  CellHoles cell;
  for (int v = 0; v < 40; ++v) {
    RimVertex vertex;
    vertex.index = v;
    vertex.on_object = v < objects;
    cell.vertices.push_back(vertex);
  }
  LocalHole hole;
  hole.cell = &cell;
  for (int v = 0; v < 40; ++v) hole.vertices.push_back(v);
  return HasWalls(hole, HoldOut{tension, 0, 0, 5}, {.slope = {0.6 * slope, -0.8 * slope}});
}

TEST(WalledGroundTest, IsForGentleGroundBetweenObjects) {
  EXPECT_TRUE(HasWallsWith(3, 0.01, 0.09));
  EXPECT_FALSE(HasWallsWith(1, 0.01, 0.09));
  EXPECT_FALSE(HasWallsWith(3, 0, 0.09));
  EXPECT_FALSE(HasWallsWith(3, 0.01, 0.11));
}

TEST(WalledGroundTest, ReadsGroundAndWhatIsKnownUnderObjects) {
  CellHoles cell;
  cell.vertices.resize(6);
  for (int v = 0; v < 5; ++v) cell.vertices[v].index = v;
  cell.vertices[0].on_ground = true;
  cell.vertices[1].on_object = true;
  cell.vertices[2].on_object = true;
  cell.vertices[2].ground = 3;
  cell.vertices[4].on_ground = true;
  cell.vertices[4].ground = 2.5;          // as the cluster's surface has it
  cell.vertices[5].height_known = false;  // on a seam
  LocalHole hole;
  hole.cell = &cell;
  hole.vertices = {0, 1, 2, 3, 4, 5, -1};
  using enum RimReading;
  EXPECT_EQ(ReadingsOf(hole), (std::vector{kReading, kNothing, kReading, kFixed, kReading, kNothing, kNothing}));
  cell.vertices[5].height_known = true;
  EXPECT_EQ(SettledReadingsOf(hole), (std::vector{kReading, kNothing, kFixed, kFixed, kFixed, kFixed, kNothing}));
}

}  // namespace
}  // namespace tilemend
