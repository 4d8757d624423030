#include "common/rpc/surface_payloads.h"

#include <gtest/gtest.h>

#include <cmath>

#include "common/rpc/stage_payloads.h"

namespace tilemend {
namespace {

bool IsTaken(const HoldOut& hold_out) { return FromProto(ToProto(hold_out)).ok(); }

TEST(SurfacePayloadsTest, ComeBackBitForBit) {
  const auto back = FromProto(ToProto(HoldOut{0.1, 0.2, 0.3, 4, {{0.5, -1.0 / 3}, 0.25}}));
  ASSERT_TRUE(back.ok()) << back.status();
  EXPECT_EQ(back->tension, 0.1);
  EXPECT_EQ(back->error, 0.2);
  EXPECT_EQ(back->error_at_start, 0.3);
  EXPECT_EQ(back->blocks, 4);
  EXPECT_EQ(back->walls.slope, Point2(0.5, -1.0 / 3));
  EXPECT_EQ(back->walls.steepness, 0.25);
  EXPECT_FALSE(FromProto(ToProto(HoldOut{1, 0, 0, 0}))->walls.is_told());
}

TEST(SurfacePayloadsTest, HolesOfGroundWithWallsComeBackBitForBit) {
  CellHoles holes;
  holes.lattice_step = 1;
  holes.vertices.resize(3);
  holes.vertices[1].on_ground = true;
  holes.vertices[1].ground = 7.25;
  holes.holes = {{.segments = {{0, 1}, {1, 2}, {2, 0}}, .walls = {{0.25, -0.5}, 0.125}},
                 {.segments = {{0, 1}, {1, 0}}}};
  v1::CellHolesBlob proto = ToProto(holes);
  const auto back = FromProto(proto);
  ASSERT_TRUE(back.ok()) << back.status();
  EXPECT_EQ(back->holes[0].walls.slope, Point2(0.25, -0.5));
  EXPECT_EQ(back->holes[0].walls.steepness, 0.125);
  EXPECT_FALSE(back->holes[1].walls.is_told());
  EXPECT_TRUE(back->vertices[1].on_ground);
  EXPECT_FALSE(back->vertices[0].on_ground);
  EXPECT_EQ(back->vertices[1].ground, 7.25);
  EXPECT_FALSE(back->vertices[0].ground.has_value());

  v1::CellHolesBlob bad = proto;
  bad.mutable_holes(0)->mutable_walls()->set_steepness(-1);
  EXPECT_FALSE(FromProto(bad).ok());
  bad = proto;
  bad.mutable_vertices()->mutable_on_ground()->RemoveLast();
  EXPECT_FALSE(FromProto(bad).ok());
}

TEST(SurfacePayloadsTest, WhatNobodyCanHaveFoundIsMalformed) {
  const double nan = std::nan("");
  EXPECT_TRUE(IsTaken({0, 0, 0, 0}));
  EXPECT_FALSE(IsTaken({-1, 0, 0, 0}));
  EXPECT_FALSE(IsTaken({nan, 0, 0, 0}));
  EXPECT_FALSE(IsTaken({0, nan, 0, 0}));
  EXPECT_FALSE(IsTaken({0, 0, HUGE_VAL, 0}));
  EXPECT_FALSE(IsTaken({0, 0, 0, -1}));
  for (const GroundTrend& trend : {GroundTrend{{0, 0}, 1e-300}, GroundTrend{{0, 0}, HUGE_VAL},
                                   GroundTrend{{1e20, 0}, 1}, GroundTrend{{0, nan}, 1}, GroundTrend{{0, 0}, 11}}) {
    EXPECT_FALSE(IsTaken({1, 0, 0, 0, trend})) << trend.slope.transpose() << " " << trend.steepness;
    EXPECT_FALSE(FromProto(ToProto(trend)).ok());
  }
  v1::HoldOut flat = ToProto(HoldOut{1, 0, 0, 0});
  flat.mutable_walls()->set_steepness(0);
  EXPECT_FALSE(FromProto(flat).ok());
}

}  // namespace
}  // namespace tilemend
