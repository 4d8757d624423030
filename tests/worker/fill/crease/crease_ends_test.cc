#include "worker/fill/crease/crease_ends.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "tests/support/folded_meshes.h"
#include "tests/worker/fill/crease/crease_loops.h"
#include "worker/fill/hole/local_hole.h"

namespace tilemend {
namespace {

TEST(CreaseEndsTest, FindsWhereARoofsEdgeEntersAHole) {
  const CellHoles work = WorkOfSheet(Disc(0, kWallHeight, 6), FoldToBuilding, kNoise);
  const std::vector<RimLoop> loops = LoopsOf(work);
  const std::vector<CreaseEnd> ends = FindCreaseEnds(loops, Bends::kAtOneEdge);
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
  EXPECT_TRUE(FindCreaseEnds(LoopsOf(WorkOfSheet(Disc(2, 8, 5), hill, 0.02)), Bends::kOverSeveralEdges).empty());
}

TEST(CreaseEndsTest, FindsNoCreaseOnARoundWall) {
  EXPECT_TRUE(FindCreaseEnds(LoopsOf(WorkOfSheet(Disc(0, 5, 6), RollRoundTank(6, 0), kNoise)), Bends::kOverSeveralEdges)
                  .empty());
}

// A loop along a ridge and across it at both ends, with one edge there for each of the slopes given, in degrees.
RimLoop LoopAcrossARidge(const std::vector<double>& slopes) {
  constexpr int32_t kLength = 10;
  RimLoop loop;
  const auto add = [&](double x, double y, double degrees) {
    const double angle = degrees / 180 * std::numbers::pi;
    loop.vertices.push_back(loop.size());
    loop.positions.emplace_back(x, y, -std::abs(y) * std::tan(24.0 / 180 * std::numbers::pi));
    loop.outside.emplace_back(0, std::sin(angle), std::cos(angle));
  };
  const auto edges = static_cast<double>(slopes.size());
  for (int32_t x = kLength; x > 0; --x) add(x, 1, 24);
  for (size_t k = 0; k < slopes.size(); ++k) add(0, 1 - 2 * static_cast<double>(k) / edges, slopes[k]);
  for (int32_t x = 0; x < kLength; ++x) add(x, -1, -24);
  for (size_t k = 0; k < slopes.size(); ++k) {
    add(kLength, -1 + 2 * static_cast<double>(k) / edges, slopes[slopes.size() - 1 - k]);
  }
  return loop;
}

TEST(CreaseEndsTest, TakesABendOverSeveralEdgesForACreaseOrForRoundAsAsked) {
  const std::vector<RimLoop> round = {LoopAcrossARidge({12, 0, -12})}, sharp = {LoopAcrossARidge({24, -24})};
  EXPECT_FALSE(FindCreaseEnds(round, Bends::kOverSeveralEdges).empty());
  EXPECT_TRUE(FindCreaseEnds(round, Bends::kAtOneEdge).empty());
  EXPECT_EQ(FindCreaseEnds(sharp, Bends::kOverSeveralEdges).size(), 2u);
  EXPECT_EQ(FindCreaseEnds(sharp, Bends::kAtOneEdge).size(), 2u);
}

}  // namespace
}  // namespace tilemend
