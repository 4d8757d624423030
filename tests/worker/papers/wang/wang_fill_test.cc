#include "worker/papers/wang/wang_fill.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "tests/support/folded_meshes.h"

namespace tilemend {
namespace {

Point3 Waves(const Point3& p) { return Point3(p.x(), p.y(), std::sin(0.4 * p.x()) + std::cos(0.5 * p.y())); }

class WangFillTest : public testing::Test {
 protected:
  LocalPatch Fill(const FillOptions& options) const {
    return FillAsWang(hole_, ProjectionFrame::Upright(), options, false);
  }
  LocalPatch Fill() const { return Fill(With(Surface::kWang)); }

  const CellHoles work_ = WorkOfSheet(Disc(0, 5, 6), Waves, 0.05);
  const CellBand band_{work_};
  const LocalHole hole_ = MakeLocalHole(work_, band_, work_.holes[0]);
};

TEST_F(WangFillTest, ClosesAHoleWithTrianglesThatFaceUp) {
  const LocalPatch patch = Fill();
  ASSERT_TRUE(patch.ok());
  EXPECT_FALSE(patch.new_points.empty());
  EXPECT_EQ(patch.loop_cuts, 0);
  for (const Triangle& t : patch.triangles) {
    const SpaceTriangle corners = InSpace(hole_, patch, t);
    EXPECT_GT((corners[1] - corners[0]).cross(corners[2] - corners[0]).z(), 0);
  }
  ExpectClosesHole(work_, work_.holes[0], ToHolePatch(hole_, patch));
}

TEST_F(WangFillTest, TheAdjustmentIsSeen) {
  FillOptions without = With(Surface::kWang);
  without.wang.adjust = false;
  EXPECT_NE(Fill().new_points, Fill(without).new_points);
}

TEST_F(WangFillTest, TheFairingIsSeen) {
  FillOptions without = With(Surface::kWang);
  without.wang.fairing_steps = 0;
  EXPECT_NE(Fill().new_points, Fill(without).new_points);
}

TEST_F(WangFillTest, CountsTheCutsOfALongLoop) {
  FillOptions options = With(Surface::kWang);
  options.wang.longest_loop = 12;
  const LocalPatch patch = Fill(options);
  EXPECT_GT(patch.loop_cuts, 2);
  const HolePatch filled = ToHolePatch(hole_, patch);
  EXPECT_EQ(filled.loop_cuts, patch.loop_cuts);
  ExpectClosesHole(work_, work_.holes[0], filled);
}

TEST(WangFillOfIslandsTest, KeepsIslands) {
  const auto ring = [](double u, double v) { return std::hypot(u, v - 5) > 2 && std::hypot(u, v - 5) < 6; };
  const CellHoles work = WorkOfSheet(ring, Waves, 0.05);
  const CellBand band(work);
  const LocalHole hole = MakeLocalHole(work, band, work.holes[0]);
  ExpectClosesHole(work, work.holes[0],
                   ToHolePatch(hole, FillAsWang(hole, ProjectionFrame::Upright(), With(Surface::kWang), false)));
}

TEST(ShapeAsWangTest, RefinesAPatchThatProjectsOnNoPlane) {
  // Around the corner between a wall and the ground.
  const CellHoles work = WorkOfSheet(Disc(0, 0, 4), FoldToBuilding, 0);
  const CellBand band(work);
  const LocalHole hole = MakeLocalHole(work, band, work.holes[0]);
  std::vector<Triangle> fan;
  const std::vector<int32_t>& loop = hole.loops.at(0).vertices;
  for (size_t i = 2; i < loop.size(); ++i) fan.push_back({loop[0], loop[i - 1], loop[i]});
  const LocalPatch patch = ShapeAsWang(hole, fan, With(Surface::kWang));
  ASSERT_TRUE(patch.ok());
  EXPECT_FALSE(patch.new_points.empty());
  ExpectClosesHole(work, work.holes[0], ToHolePatch(hole, patch));
}

}  // namespace
}  // namespace tilemend
