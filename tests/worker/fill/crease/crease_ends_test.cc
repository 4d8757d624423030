#include "worker/fill/crease/crease_ends.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/support/folded_meshes.h"
#include "tests/worker/fill/crease/crease_loops.h"
#include "worker/fill/hole/local_hole.h"

namespace tilemend {
namespace {

TEST(CreaseEndsTest, FindsWhereARoofsEdgeEntersAHole) {
  const CellHoles work = WorkOfSheet(Disc(0, kWallHeight, 6), FoldToBuilding, kNoise);
  const std::vector<RimLoop> loops = LoopsOf(work);
  const std::vector<CreaseEnd> ends = FindCreaseEnds(loops);
  ASSERT_EQ(ends.size(), 2u);
  for (const CreaseEnd& end : ends) {
    const Point3& p = loops[end.loop].positions[end.place];
    EXPECT_NEAR(p.y(), 0, kNoise);
    EXPECT_NEAR(p.z(), kWallHeight, kNoise);
    EXPECT_NEAR(end.tangent.x(), p.x() < 0 ? 1 : -1, 0.01) << "into the hole";
    EXPECT_NEAR(std::abs(end.before.z() - end.after.z()), 1, 0.05) << "roof and wall";
  }
}

TEST(CreaseEndsTest, FindsNoCreaseOnAHill) {
  const auto hill = [](const Point3& p) {
    return Point3(p.x(), p.y(), 12 * std::exp(-(p - Point3(0, 5, 0)).squaredNorm() / 60));
  };
  EXPECT_TRUE(FindCreaseEnds(LoopsOf(WorkOfSheet(Disc(2, 8, 5), hill, 0.02))).empty());
}

TEST(CreaseEndsTest, FindsNoCreaseOnARoundWall) {
  EXPECT_TRUE(FindCreaseEnds(LoopsOf(WorkOfSheet(Disc(0, 5, 6), RollRoundTank(6, 0), kNoise))).empty());
}

}  // namespace
}  // namespace tilemend
