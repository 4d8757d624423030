#include "worker/ground/surroundings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/support/ground_rasters.h"
#include "worker/ground/rim_objects.h"

namespace tilemend {
namespace {

// A street along x between houses, 6 m wide, with a hole from 45 to 55.
double Street(int32_t c, int32_t r) {
  if (c >= 45 && c < 55 && r >= 47 && r < 53) return std::numeric_limits<double>::quiet_NaN();
  return r >= 47 && r < 53 ? 2 : 9;
}

std::vector<Point3> RimOfStreet() {
  std::vector<Point3> rim;
  for (int32_t r = 47; r < 53; ++r) {
    rim.emplace_back(44.5, r + 0.5, 2);
    rim.emplace_back(55.5, r + 0.5, 2);
  }
  return rim;
}

TEST(GroundAroundHolesTest, HasTheStreetAndNoRoof) {
  const std::vector<GroundRaster> rasters = {BuiltRaster(0, 0, 100, 100, Street)};
  const RimGround rim = GroundAtRim(RimOfStreet(), rasters);
  EXPECT_EQ(rim.side, 3);
  double farthest = 0;  // metres from the hole
  for (const GroundSquare& square : rim.around) {
    EXPECT_EQ(square.height, 2);
    EXPECT_TRUE(square.row >= 15 && square.row <= 17) << square.row;
    EXPECT_TRUE(square.col < 15 || square.col > 17) << "in the hole";
    farthest = std::max(farthest, std::abs(3 * square.col + 1.5 - 50) - 5);
  }
  EXPECT_GE(farthest, kSurroundingsReach);
  EXPECT_LE(farthest, kSurroundingsReach + 3 * SquareBlocks::kSide);
}

TEST(GroundAroundHolesTest, WithoutAHoleThereIsNone) {
  const std::vector<GroundRaster> rasters = {
      BuiltRaster(0, 0, 100, 100, [](int32_t c, int32_t) { return c < 50 ? 0 : 7; })};
  EXPECT_TRUE(GroundAtRim(std::vector<Point3>{{20.5, 20.5, 0}, {99.5, 99.5, 0}}, rasters).around.empty());
}

// Of two tiles, each with its own vertices and the rasters in reach: together the squares within the reach are there.
TEST(GroundAroundHolesTest, ItIsTheSameHoweverTheSceneIsCut) {
  const std::vector<GroundRaster> parts = {BuiltRaster(0, 0, 50, 51, Street), BuiltRaster(50, 0, 50, 51, Street),
                                           BuiltRaster(0, 51, 100, 49, Street)};
  const std::vector<Point3> rim = RimOfStreet();
  std::vector<Point3> west, east;
  for (const Point3& p : rim) (p.x() < 50 ? west : east).push_back(p);
  std::vector<GroundSquare> joined = GroundAtRim(west, parts).around;
  for (const GroundSquare& square : GroundAtRim(east, parts).around) joined.push_back(square);
  int within = 0;
  for (const GroundSquare& square :
       GroundAtRim(rim, std::vector<GroundRaster>{BuiltRaster(0, 0, 100, 100, Street)}).around) {
    const Point2 middle(3 * square.col + 1.5, 3 * square.row + 1.5);
    const auto is_within = [&](const Point3& p) { return (p.head<2>() - middle).norm() <= kSurroundingsReach; };
    if (std::ranges::none_of(rim, is_within)) continue;
    ++within;
    EXPECT_TRUE(std::ranges::find(joined, square) != joined.end()) << square.col << " " << square.row;
  }
  EXPECT_GT(within, 20);
}

}  // namespace
}  // namespace tilemend
