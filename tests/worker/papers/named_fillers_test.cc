// Fillers by name, through FillHoles.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/mesh_builders.h"
#include "tests/support/patch_checks.h"
#include "worker/fill/fill_holes.h"
#include "worker/papers/published_ways.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

// The hole of a sheet of 10 x 10 squares, of which 6 x 6 are not there.
CellHoles SquareHole(const HeightFunction& height = Flat, bool open = false) {
  std::vector<std::string> picture(10, "##########");
  for (int row = 2; row < 8; ++row) picture[row] = "##......##";
  const auto inside = [](const Point3& p) { return p.x() > 0 && p.y() > 0 && p.x() < 10 && p.y() < 10; };
  return WorkOf(PictureMesh(picture, height), open,
                [&](const Point3& a, const Point3& b) { return inside(a) && inside(b); });
}

TEST(NamedFillersTest, FillAClosedHoleInTheirOwnWay) {
  const CellHoles work = SquareHole();
  for (const auto& [filler, way] : {std::pair{Filler::kAdvancingFrontNormal, FillWay::kAdvancingFrontNormal},
                                    {Filler::kAdvancingFrontCurvature, FillWay::kAdvancingFrontCurvature},
                                    {Filler::kAdvancingFrontPoisson, FillWay::kAdvancingFrontPoisson},
                                    {Filler::kSvmLaplacian, FillWay::kSvmLaplacian},
                                    {Filler::kMinimumArea, FillWay::kMinimumArea}}) {
    FillOptions options;
    options.published = AllPublishedWays();
    options.filler = filler;
    const HolePatch patch = FillHoles(work, options).at(0);
    ExpectClosesHole(work, work.holes[0], patch);
    EXPECT_EQ(patch.way, way);
    EXPECT_EQ(FillHoles(work, options).at(0).new_points, patch.new_points);
  }
}

TEST(NamedFillersTest, LeaveAHoleOpenWhereTheirPatchCrossesTheSurface) {
  const CellHoles work = SquareHole();
  const SurfaceNear stake = [](const Point3&, const Point3&) {
    return std::vector<SpaceTriangle>{{Point3(4.1, 4.2, -9), Point3(4.3, 4.4, -9), Point3(4.2, 4.7, 9)}};
  };
  FillOptions options;
  options.published = AllPublishedWays();
  options.filler = Filler::kAdvancingFrontNormal;
  const HolePatch patch = FillHoles(work, options, stake).at(0);
  EXPECT_THAT(patch.failure, HasSubstr("passes through"));
  EXPECT_THAT(patch.triangles, IsEmpty());
}

// Far wider triangles around the rim of SquareHole, in a moat: what is learnt from them in metres is too much inside.
std::vector<SpaceTriangle> Moat(const Point3& /*lo*/, const Point3& /*hi*/) {
  const auto at = [](int x, int y) {
    const int off = std::max(std::abs(x - 5), std::abs(y - 5));
    const double wide = off < 4 ? 1 : off == 4 ? 25 : 60;
    return Point3(5 + wide * (x - 5), 5 + wide * (y - 5), off == 4 ? -100 : 0);
  };
  std::vector<SpaceTriangle> triangles;
  for (int x = 0; x < 10; ++x) {
    for (int y = 0; y < 10; ++y) {
      if (x >= 2 && x < 8 && y >= 2 && y < 8) continue;
      triangles.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1)});
      triangles.push_back({at(x, y), at(x + 1, y + 1), at(x, y + 1)});
    }
  }
  return triangles;
}

TEST(NamedFillersTest, LeaveAHoleOpenWhereTheirPatchLeavesItsRimBehind) {
  const CellHoles work = SquareHole();
  FillOptions options;
  options.published = AllPublishedWays();
  options.filler = Filler::kSvmLaplacian;
  options.filling.scale = LaplacianScale::kMean;
  EXPECT_EQ(FillHoles(work, options).at(0).failure, "");
  EXPECT_THAT(FillHoles(work, options, Moat).at(0).failure, HasSubstr("further from its boundary"));
}

TEST(NamedFillersTest, TellOfPatchesThatFoldBack) {
  const auto creases = [](Filler filler, double slope) {
    FillOptions options;
    options.published = AllPublishedWays();
    options.filler = filler;
    const auto ridge = [slope](double x, double) { return -slope * std::abs(x - 5); };
    return FillHoles(SquareHole(ridge), options).at(0).creases;
  };
  for (const Filler filler : kFillers) EXPECT_EQ(creases(filler, 0.1), 0) << FillerName(filler);
  EXPECT_GT(creases(Filler::kAdvancingFrontNormal, 20), 0);
}

TEST(NamedFillersTest, LeaveOpenHolesToTheSurface) {
  const CellHoles work = SquareHole(Flat, true);
  FillOptions options;
  options.published = AllPublishedWays();
  options.filler = Filler::kAdvancingFrontNormal;
  EXPECT_EQ(FillHoles(work, options).at(0).way, FillWay::kGround);
}

}  // namespace
}  // namespace tilemend
