#include "common/rpc/clear_payloads.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const ClearArea kArea{{{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{1, 1}, {2, 1}, {1, 2}}}}, 2.5, {{{-1, 0}, {1.0 / 3, 9}}}};

TEST(ClearPayloadsTest, AreasComeBackBitForBit) {
  ClearArea area = kArea;
  for (const double top : {2.5, 1.0 / 3, std::numeric_limits<double>::infinity()}) {
    area.top = top;
    const auto back = FromProto(ToProto(area));
    ASSERT_TRUE(back.ok()) << back.status();
    EXPECT_EQ(back->polygon.rings, area.polygon.rings);
    EXPECT_EQ(back->top, top);
    EXPECT_EQ(back->outline, area.outline);
  }
}

TEST(ClearPayloadsTest, RefusesAreasThatNobodyMade) {
  const std::function<void(v1::ClearArea&)> changes[] = {
      [](v1::ClearArea& a) { a.add_point(1); },
      [](v1::ClearArea& a) { a.add_ring_points(3); },
      [](v1::ClearArea& a) { a.set_ring_points(0, -1); },
      [](v1::ClearArea& a) { a.set_ring_points(1, 2), a.mutable_point()->Truncate(12); },
      [](v1::ClearArea& a) { a.add_outline(1); },
      [](v1::ClearArea& a) { a.set_outline(2, std::numeric_limits<double>::infinity()); },
      [](v1::ClearArea& a) { a.set_point(3, std::numeric_limits<double>::infinity()); },
      [](v1::ClearArea& a) { a.set_top(std::numeric_limits<double>::quiet_NaN()); }};
  for (const auto& change : changes) {
    v1::ClearArea proto = ToProto(kArea);
    change(proto);
    EXPECT_THAT(std::string(FromProto(proto).status().message()), HasSubstr("malformed payload"));
  }
}

TEST(ClearPayloadsTest, TalliesComeBack) {
  const HeightTally tally{{{-3, 7}, {0, int64_t{1} << 40}}};
  const auto back = FromProto(ToProto(tally));
  ASSERT_TRUE(back.ok()) << back.status();
  EXPECT_EQ(back->area_of_bin, tally.area_of_bin);
}

TEST(ClearPayloadsTest, RefusesTalliesThatNobodyMade) {
  const std::function<void(v1::HeightTally&)> changes[] = {[](v1::HeightTally& t) { t.add_bin(9); },
                                                           [](v1::HeightTally& t) { t.set_area(0, 0); },
                                                           [](v1::HeightTally& t) { t.set_bin(0, 5); }};
  for (const auto& change : changes) {
    v1::HeightTally proto = ToProto(HeightTally{{{-3, 7}, {0, 9}}});
    change(proto);
    EXPECT_FALSE(FromProto(proto).ok());
  }
}

TEST(ClearPayloadsTest, ATileIsItsFileWithoutWhatIsTakenOut) {
  v1::TileRef tile;
  tile.set_path("a.obj");
  *tile.add_clear() = ToProto(kArea);
  const auto cleared = ClearTile(tile, "v 3 0 1\nv 4 0 1\nv 4 1 1\nf 1 2 3\n");
  ASSERT_TRUE(cleared.ok()) << cleared.status();
  EXPECT_THAT(cleared->triangles, ElementsAre(1));
  EXPECT_EQ(cleared->bytes, "v 3 0 1\nv 4 0 1\nv 4 1 1\n");
}

}  // namespace
}  // namespace tilemend
