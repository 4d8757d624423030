#include "worker/propose/level_regions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <vector>

namespace tilemend {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

struct Made {
  GroundRaster heights = EmptyRaster(1, -20, 40, 100, 80);
  std::vector<bool> is_ground = std::vector<bool>(100 * 80, true);

  // Heights at the middles of squares, from the low corner.
  explicit Made(const std::function<double(double, double)>& height) {
    for (int32_t row = 0; row < heights.rows; ++row) {
      for (int32_t col = 0; col < heights.cols; ++col) {
        heights.heights[static_cast<size_t>(row) * heights.cols + col] =
            static_cast<float>(height(col + 0.5, row + 0.5));
      }
    }
  }
  std::vector<LowRegion> Regions() const { return FindLevelRegions(heights, is_ground, {}); }
};

bool InPond(double x, double y) { return std::hypot(x - 50, y - 40) < 15; }

double Pond(double x, double y) {
  static std::mt19937 random(1);
  const double noise = 0.1 * std::uniform_real_distribution<double>(-1, 1)(random);
  return InPond(x, y) ? 3 + noise : 4 + 0.01 * x + noise;
}

TEST(FindLevelRegionsTest, APondIsFoundWithItsLevel) {
  const std::vector<LowRegion> regions = Made(Pond).Regions();
  ASSERT_THAT(regions, SizeIs(1));
  EXPECT_NEAR(regions[0].level, 3, 0.1);
  EXPECT_NEAR(regions[0].sigma, 0.1, 0.05);
  EXPECT_NEAR(regions[0].area, M_PI * 15 * 15, 60);
  EXPECT_GT(regions[0].shore_share, 0.9);
  EXPECT_TRUE(Contains(regions[0].outline, {-20 + 50, 40 + 40}));
  EXPECT_FALSE(Contains(regions[0].outline, {-20 + 50, 40 + 58}));
}

TEST(FindLevelRegionsTest, PitsOfNoiseDoNoHarm) {
  Made made(Pond);
  for (int32_t row = 30; row < 36; ++row) {
    for (int32_t col = 44; col < 50; ++col) made.heights.heights[row * 100 + col] -= 4;
  }
  const std::vector<LowRegion> regions = made.Regions();
  ASSERT_THAT(regions, SizeIs(1));
  EXPECT_NEAR(regions[0].level, 3, 0.1);
}

TEST(FindLevelRegionsTest, ALargeIslandIsLeftOut) {
  const auto regions = Made([](double x, double y) {
                         return std::hypot(x - 50, y - 40) < 8 ? 5.0 : std::hypot(x - 50, y - 40) < 30 ? 3.0 : 4.5;
                       }).Regions();
  ASSERT_THAT(regions, SizeIs(1));
  EXPECT_THAT(regions[0].outline.rings, SizeIs(2));
  EXPECT_FALSE(Contains(regions[0].outline, {30, 80}));
}

TEST(FindLevelRegionsTest, ACanalFromEdgeToEdgeIsFound) {
  const auto regions = Made([](double x, double y) { return std::abs(y - 40 - 0.1 * x) < 8 ? 1.0 : 4.0; }).Regions();
  ASSERT_THAT(regions, SizeIs(1));
  EXPECT_NEAR(regions[0].area, 1600, 60);
}

TEST(FindLevelRegionsTest, SlopesBowlsAndPlainsAreNone) {
  EXPECT_THAT(Made([](double x, double) { return 0.05 * x; }).Regions(), IsEmpty());
  EXPECT_THAT(Made([](double, double) { return 2.0; }).Regions(), IsEmpty());
  EXPECT_THAT(Made([](double x, double y) { return 0.1 * std::hypot(x - 50, y - 40); }).Regions(), IsEmpty());
  EXPECT_THAT(Made([](double x, double y) { return InPond(x, y) ? 3.8 : 4.0; }).Regions(), IsEmpty()) << "a kerb";
  EXPECT_THAT(Made([](double x, double y) { return InPond(x, y) ? 6.0 : 4.0; }).Regions(), IsEmpty()) << "a terrace";
}

// Houses all around, and behind them a street as low.
TEST(FindLevelRegionsTest, AYardIsNone) {
  Made made([](double x, double y) {
    const double distance = std::max(std::abs(x - 50), std::abs(y - 40));
    return distance > 15 && distance < 20 ? 12.0 : 4.0;
  });
  for (size_t i = 0; i < made.is_ground.size(); ++i) made.is_ground[i] = made.heights.heights[i] < 10;
  EXPECT_THAT(made.Regions(), IsEmpty());
}

// Trees stand at it; what is behind them is higher.
TEST(FindLevelRegionsTest, AShoreWithTreesIsSeenBehindThem) {
  Made made([](double x, double y) {
    const double distance = std::hypot(x - 50, y - 40);
    return distance < 15 ? 3.0 : distance < 20 ? 12.0 : 4.0;
  });
  for (size_t i = 0; i < made.is_ground.size(); ++i) made.is_ground[i] = made.heights.heights[i] < 10;
  EXPECT_THAT(made.Regions(), SizeIs(1));
}

TEST(FindLevelRegionsTest, SmallOnesAreNone) {
  EXPECT_THAT(Made([](double x, double y) { return std::hypot(x - 50, y - 40) < 5 ? 3.0 : 4.0; }).Regions(), IsEmpty());
  EXPECT_THAT(FindLevelRegions({}, {}, {}), IsEmpty());
}

}  // namespace
}  // namespace tilemend
