#include "worker/fill/fill_memory.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "tests/support/mesh_builders.h"
#include "tests/support/patch_checks.h"
#include "worker/fill/fill_holes.h"
#include "worker/fill/seam/sample_cluster.h"
#include "worker/papers/published_ways.h"

namespace tilemend {
namespace {

// A hole of `side` by `side` squares of a metre, with an island of `island` by `island` in it.
CellHoles SquareHole(int32_t side, int32_t island = 0) {
  const int32_t from = (side - island) / 2, to = from + island;
  const auto is_inside = [](int32_t i, int32_t lo, int32_t hi) { return i >= lo && i < hi; };
  const auto keep = [&](int32_t i, int32_t j) {
    return !is_inside(i, 0, side) || !is_inside(j, 0, side) || (is_inside(i, from, to) && is_inside(j, from, to));
  };
  const auto bent = [](double x, double y) { return 0.001 * x * y; };
  const auto in_hole = [&](double at) { return at >= 0 && at <= side; };
  CellHoles work =
      WorkOf(SquaresMesh(-2, side + 2, -2, side + 2, keep, bent), false, [&](const Point3& a, const Point3& b) {
        return in_hole(a.x()) && in_hole(a.y()) && in_hole(b.x()) && in_hole(b.y());
      });
  work.lattice_step = 0x1p-10;
  return work;
}

FillOptions Options(Surface surface, bool uniform) {
  FillOptions options;
  options.published = AllPublishedWays();
  options.surface = surface;
  options.refine.uniform = uniform;
  return options;
}

double Expected(const CellHoles& cell, const RefineOptions& options = {}) {
  return ExpectedVertices(cell, cell.holes[0], options);
}

TEST(ExpectedVerticesTest, AreAsManyAsAFillMakesButForAFactor) {
  for (const auto& [surface, uniform] : {std::pair(Surface::kThinPlate, true),
                                         {Surface::kThinPlate, false},
                                         {Surface::kWang, true},
                                         {Surface::kWang, false}}) {
    const CellHoles work = SquareHole(40);
    const FillOptions options = Options(surface, uniform);
    const std::vector<HolePatch> patches = FillHoles(work, options, {});
    ASSERT_EQ(patches[0].failure, "");
    const auto made = static_cast<double>(patches[0].new_points.size());
    EXPECT_GT(Expected(work, options.refine), 0.7 * made);
    EXPECT_LT(Expected(work, options.refine), 3 * made);
  }
}

TEST(ExpectedVerticesTest, GrowWithTheAreaOrWhereTrianglesGrowWithTheBoundary) {
  RefineOptions uniform;
  uniform.uniform = true;
  EXPECT_NEAR(Expected(SquareHole(80), uniform) / Expected(SquareHole(40), uniform), 4, 0.05);
  EXPECT_NEAR(Expected(SquareHole(80)) / Expected(SquareHole(40)), 2, 0.1);
  RefineOptions small;
  small.size_limit = 1;
  EXPECT_EQ(Expected(SquareHole(40), small), Expected(SquareHole(40), uniform));
}

TEST(ExpectedVerticesTest, AreNoneOnAnIsland) {
  RefineOptions uniform;
  uniform.uniform = true;
  EXPECT_NEAR(Expected(SquareHole(40, 20), uniform) / Expected(SquareHole(40), uniform), 0.75, 0.01);
}

TEST(ExpectedVerticesTest, AreNoneWithoutABoundaryOrSizes) {
  CellHoles work = SquareHole(4);
  for (RimVertex& v : work.vertices) v.size = 0;
  EXPECT_EQ(Expected(work), 0);
  work.holes[0].segments.clear();
  EXPECT_EQ(Expected(work), 0);
}

TEST(FillMemoryTest, FairingTakesMoreThanAPlateAndWaterNoMore) {
  CellHoles work = SquareHole(100);
  const int64_t plate = FillMemory(work, Options(Surface::kThinPlate, true));
  EXPECT_GT(FillMemory(work, Options(Surface::kWang, true)), plate);
  EXPECT_LT(FillMemory(work, Options(Surface::kWang, false)), plate);
  work.holes[0].level = 1.0;
  EXPECT_EQ(FillMemory(work, Options(Surface::kWang, true)), plate);
}

TEST(FillMemoryTest, OfAFairedVertexRisesWithTheirNumber) {
  const FillOptions options = Options(Surface::kWang, true);
  const auto small = static_cast<double>(FillMemory(SquareHole(150), options)),
             large = static_cast<double>(FillMemory(SquareHole(300), options));
  EXPECT_GT(large / small, 4.5);
}

TEST(FillMemoryTest, HolesOfACellAreFilledOneByOne) {
  CellHoles work = SquareHole(100);
  const FillOptions options = Options(Surface::kThinPlate, true);
  const int64_t one = FillMemory(work, options);
  work.holes.push_back(work.holes[0]);
  EXPECT_GT(FillMemory(work, options), one);
  EXPECT_LT(FillMemory(work, options), one + one / 2);
}

TEST(FillMemoryTest, CountsNoMoreVerticesThanTheFillMayHave) {
  CellHoles work = SquareHole(100);
  for (const Surface surface : {Surface::kThinPlate, Surface::kWang}) {
    FillOptions options = Options(surface, true);
    ASSERT_GT(Expected(work, options.refine), 5000);
    const int64_t free = FillMemory(work, options);
    options.refine.max_new_points = 2000;
    const int64_t limited = FillMemory(work, options);
    EXPECT_LT(limited, free / 2);
    CellHoles twice = work;
    twice.holes.push_back(work.holes[0]);
    EXPECT_EQ(FillMemory(twice, options), limited);
  }
}

TEST(SampleMemoryTest, IsOfAllHolesUpToWhatOneSolveMayHave) {
  CellHoles work = SquareHole(100);
  const FillOptions options = Options(Surface::kThinPlate, true);
  const int64_t one = SampleMemory(work, options);
  work.holes.push_back(work.holes[0]);
  EXPECT_GT(SampleMemory(work, options), one + one / 2);
  work.holes.resize(100, work.holes[0]);
  const int64_t most = SampleMemory(work, options);
  work.holes.resize(200, work.holes[0]);
  EXPECT_EQ(SampleMemory(work, options), most);
}

}  // namespace
}  // namespace tilemend
