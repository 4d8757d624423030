#include "coordinator/plan/water/area_index.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<Point2> Box(double x0, double x1) { return {{x0, 0}, {x1, 0}, {x1, 2}, {x0, 2}}; }

CoverLines RegionOf(double x0, double x1) {
  const std::vector<Point2> ring = Box(x0, x1);
  std::vector<PlaneSegment> segments;
  for (size_t i = 0; i < ring.size(); ++i) segments.emplace_back(ring[i], ring[(i + 1) % ring.size()]);
  return CoverLines(segments);
}

bool IsAny(const WaterArea&) { return true; }

TEST(AreaIndexTest, TellsInOrderWhatCoversSomeOfARegion) {
  const std::vector<WaterArea> areas = {{true, {{Box(0, 2)}}},   {true, {}},
                                        {true, {{Box(20, 30)}}}, {false, {{Box(1, 4)}}},
                                        {true, {{Box(4, 5)}}},   {true, {{Box(-9, 9)}}}};
  const AreaIndex index(areas);
  std::vector<size_t> numbers;
  for (const AreaShare& s : index.SharesOf(RegionOf(0, 4), IsAny)) {
    numbers.push_back(s.area);
    EXPECT_EQ(s.share, RegionOf(0, 4).ShareIn(areas[s.area]));
  }
  EXPECT_THAT(numbers, ElementsAre(0U, 3U, 5U)) << "4 touches it";
  const auto wet = index.SharesOf(RegionOf(0, 4), [](const WaterArea& area) { return area.water; });
  ASSERT_EQ(wet.size(), 2U);
  EXPECT_EQ(index.DeciderOf(RegionOf(0, 4), wet)->area, 5U);
}

TEST(AreaIndexTest, LooksAtAreasNearARegionAlone) {
  std::vector<WaterArea> areas;
  for (int i = 0; i < 10000; ++i) areas.push_back({true, {{Box(10 * i, 10 * i + 5)}}});
  int looked = 0;
  const AreaIndex index(areas);
  for (int i = 0; i < 100; ++i) {
    const auto shares =
        index.SharesOf(RegionOf(1000 * i, 1000 * i + 8), [&](const WaterArea&) { return ++looked > 0; });
    ASSERT_EQ(shares.size(), 1U);
  }
  EXPECT_EQ(looked, 100);
}

TEST(AreaIndexTest, OnceItIsCancelledThereIsNoShare) {
  const std::vector<WaterArea> areas(5, {true, {{Box(0, 4)}}});
  int asked = 0;
  const AreaIndex index(areas, [&] { return ++asked >= 3; });
  EXPECT_THAT(index.SharesOf(RegionOf(0, 4), IsAny), IsEmpty());
  EXPECT_EQ(asked, 3);
  EXPECT_TRUE(index.cancelled());
}

TEST(AreaIndexTest, WithoutAreasNothingDecides) {
  const std::vector<WaterArea> none;
  const AreaIndex index(none);
  EXPECT_THAT(index.SharesOf(RegionOf(0, 4), IsAny), IsEmpty());
  EXPECT_FALSE(index.DeciderOf(RegionOf(0, 4), {}));
}

}  // namespace
}  // namespace tilemend
