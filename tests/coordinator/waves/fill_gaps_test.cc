#include "coordinator/waves/fill_gaps.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

namespace tilemend {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

// Two cells of 100 m that overlap by 0.2 and 0.4 m.
BorderAudit Overlap() {
  BorderAudit border;
  border.a = {0, 0}, border.b = {1, 0};
  border.kind = BorderKind::kOverlap;
  border.margins = {0.2, 0.4};
  border.offset = 0.6;
  return border;
}

Grid Cells() {
  Grid grid;
  grid.cell_size = Point2(100, 100);
  return grid;
}

// A patch over a rectangle. One of its corners is a vertex of a seam.
struct Fill {
  std::vector<RimVertex> vertices;
  std::vector<HolePatch> patches;
};

Fill Rectangle(double x0, double x1, double y0, double y1, const std::function<double(double, double)>& height) {
  const auto at = [&](double x, double y) { return Point3(x, y, height(x, y)); };
  HolePatch patch;
  patch.new_points = {at(x1, y0), at(x1, y1), at(x0, y1)};
  patch.triangles = {{0, -1, -2}, {0, -2, -3}};
  RimVertex seam;
  seam.index = -1;
  seam.position = at(x0, y0);
  return {{seam}, {patch}};
}

double Slope(double, double y) { return 0.001 * y; }

void Take(CellId cell, const Fill& fill, FillGaps& gaps) { gaps.Take(cell, fill.vertices, fill.patches); }

TEST(FillGapsTest, AreZeroOfOneSurface) {
  FillGaps gaps(Cells(), {Overlap()});
  Take({0, 0}, Rectangle(50, 100.2, 20, 60, Slope), gaps);
  Take({1, 0}, Rectangle(99.6, 150, 30, 70, Slope), gaps);
  ASSERT_THAT(gaps.gaps(), SizeIs(1));
  const SurfaceGap& gap = gaps.gaps().begin()->second;
  EXPECT_NEAR(gap.percentile_99, 0, 1e-5);
  EXPECT_NEAR(static_cast<double>(gap.places), 3 * 256 * 0.3, 6) << "where both lie, 30 to 60 of 100 m";
}

TEST(FillGapsTest, SayHowFarFillsDifferInAnyOrder) {
  for (const bool turned : {false, true}) {
    FillGaps gaps(Cells(), {Overlap()});
    const auto take = [&](int cell) {
      if (cell == 0) Take({0, 0}, Rectangle(50, 100.2, 20, 60, Slope), gaps);
      if (cell == 1) {
        Take({1, 0}, Rectangle(99.6, 150, 20, 60, [](double x, double y) { return Slope(x, y) + 0.25; }), gaps);
      }
    };
    take(turned), take(!turned);
    ASSERT_THAT(gaps.gaps(), SizeIs(1));
    EXPECT_NEAR(gaps.gaps().begin()->second.median, 0.25, 1e-4);
    EXPECT_NEAR(gaps.gaps().begin()->second.percentile_99, 0.25, 1e-4);
  }
}

TEST(FillGapsTest, TakeTheLowestOfSeveralHeights) {
  FillGaps gaps(Cells(), {Overlap()});
  Fill fill = Rectangle(50, 100.2, 20, 60, Slope);
  const Fill roof = Rectangle(50, 100.2, 20, 60, [](double x, double y) { return Slope(x, y) + 9; });
  fill.patches.push_back({1, {}, FillWay::kGround, {}, {}, {}});
  fill.patches.back().new_points = roof.patches[0].new_points;
  fill.patches.back().triangles = {{-1, -2, -3}};
  Take({0, 0}, fill, gaps);
  Take({1, 0}, Rectangle(99.6, 150, 20, 60, Slope), gaps);
  EXPECT_NEAR(gaps.gaps().begin()->second.percentile_99, 0, 1e-5);
}

TEST(FillGapsTest, LeaveOutWhatMeetsOriginals) {
  FillGaps gaps(Cells(), {Overlap()});
  Fill fill = Rectangle(50, 100.2, 20, 60, Slope);
  fill.vertices[0].index = 7;
  Take({0, 0}, fill, gaps);
  Take({1, 0}, Rectangle(99.6, 150, 20, 60, Slope), gaps);
  EXPECT_THAT(gaps.gaps(), IsEmpty());
}

TEST(FillGapsTest, WallsAreComparedInSpace) {
  FillGaps gaps(Cells(), {Overlap()});
  const auto wall = [](double shift) { return [shift](double, double y) { return 50 * (y + shift); }; };
  Take({0, 0}, Rectangle(50, 100.2, 20, 60, wall(0)), gaps);
  Take({1, 0}, Rectangle(99.6, 150, 20, 60, wall(0.02)), gaps);
  EXPECT_NEAR(gaps.gaps().begin()->second.median, 0.02, 1e-3) << "and not a metre";
}

TEST(FillGapsTest, NothingIsSaidWhereOneIsMissingOrTilesMeet) {
  FillGaps gaps(Cells(), {Overlap()});
  Take({0, 0}, Rectangle(50, 100.2, 20, 60, Slope), gaps);
  Take({1, 0}, Rectangle(120, 150, 20, 60, Slope), gaps);
  EXPECT_THAT(gaps.gaps(), IsEmpty());
  BorderAudit exact = Overlap();
  exact.kind = BorderKind::kExact;
  EXPECT_FALSE(FillGaps(Cells(), {exact}).Wants({0, 0}));
}

}  // namespace
}  // namespace tilemend
