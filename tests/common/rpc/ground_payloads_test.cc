#include "common/rpc/ground_payloads.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace tilemend {
namespace {

GroundRaster Slope(double rise) {
  GroundRaster raster = EmptyRaster(2, -7, 5, 20, 10);
  for (size_t i = 0; i < raster.heights.size(); i += 2) {
    raster.heights[i] = static_cast<float>(100 + rise * static_cast<double>(i));
  }
  return raster;
}

TEST(GroundPayloadsTest, ARasterComesBackToTheStep) {
  for (const double rise : {0.01, 30.0}) {
    const GroundRaster raster = Slope(rise);
    const v1::GroundRasterBlob proto = ToProto(raster);
    const auto back = FromProto(proto);
    ASSERT_TRUE(back.ok()) << back.status();
    EXPECT_EQ(back->col, -7);
    EXPECT_EQ(back->row, 5);
    EXPECT_EQ(back->cols, 20);
    EXPECT_EQ(back->square, 2);
    for (size_t i = 0; i < raster.heights.size(); ++i) {
      EXPECT_EQ(std::isnan(back->heights[i]), std::isnan(raster.heights[i]));
      if (std::isnan(raster.heights[i])) continue;
      EXPECT_NEAR(back->heights[i], raster.heights[i], proto.step() / 2 + 1e-4);
    }
  }
}

TEST(GroundPayloadsTest, TwoBytesASquare) { EXPECT_EQ(ToProto(Slope(1)).heights().size(), 400); }

TEST(GroundPayloadsTest, OneThatNobodyMadeIsRefused) {
  const std::function<void(v1::GroundRasterBlob&)> faults[] = {
      [](auto& p) { p.mutable_heights()->push_back('x'); },
      [](auto& p) { p.set_cols(-1); },
      [](auto& p) { p.set_cols(1 << 30), p.set_rows(1 << 30); },
      [](auto& p) { p.set_square(0); },
      [](auto& p) { p.set_square(std::nan("")); },
      [](auto& p) { p.set_step(0); },
      [](auto& p) { p.set_step(INFINITY); },
      [](auto& p) { p.set_middle(std::nan("")); },
      [](auto& p) { p.set_col(INT32_MAX); }};
  for (const auto& fault : faults) {
    v1::GroundRasterBlob proto = ToProto(Slope(1));
    fault(proto);
    EXPECT_TRUE(absl::IsInvalidArgument(FromProto(proto).status())) << proto.ShortDebugString().substr(0, 80);
  }
}

RimGround Rim() { return {{true, false}, {3.5F, -1}, 3, {{-4, 7, 2.25F}, {5, 8, 2}}}; }

TEST(GroundPayloadsTest, RimsComeBack) {
  const auto rim = FromProto(ToProto(Rim()), 2);
  ASSERT_TRUE(rim.ok()) << rim.status();
  EXPECT_EQ(rim->on_object, Rim().on_object);
  EXPECT_EQ(rim->ground, Rim().ground);
  EXPECT_EQ(rim->side, 3);
  EXPECT_EQ(rim->around, Rim().around);
}

TEST(GroundPayloadsTest, ARimThatNobodyMadeIsRefused) {
  const std::function<void(v1::GroundOutput&)> faults[] = {[](auto& p) { p.add_ground(1); },
                                                           [](auto& p) { p.clear_on_object(); },
                                                           [](auto& p) { p.add_around_col(1); },
                                                           [](auto& p) { p.mutable_around_row()->RemoveLast(); },
                                                           [](auto& p) { p.set_side(INFINITY); },
                                                           [](auto& p) { p.set_around_height(1, std::nanf("")); },
                                                           [](auto& p) {
                                                             for (int i = 0; i < 512; ++i)
                                                               p.add_around_col(1), p.add_around_row(1),
                                                                   p.add_around_height(1);
                                                           }};
  for (const auto& fault : faults) {
    v1::GroundOutput proto = ToProto(Rim());
    fault(proto);
    EXPECT_TRUE(absl::IsInvalidArgument(FromProto(proto, 2).status())) << proto.ShortDebugString().substr(0, 80);
  }
}

}  // namespace
}  // namespace tilemend
