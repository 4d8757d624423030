#include "worker/fill/crease/crease_fill.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <ostream>
#include <string>

#include "tests/support/folded_meshes.h"
#include "tests/support/patch_checks.h"
#include "worker/fill/fill_holes.h"
#include "worker/fill/hole/local_hole.h"
#include "worker/papers/published_ways.h"

namespace tilemend {
namespace {

// Patches follow the noise of their rim, a little amplified.
constexpr double kTolerance = 0.05;

FillOptions ThinPlate() {
  FillOptions options;
  options.surface = Surface::kThinPlate;
  return options;
}

HolePatch Fill(const CellHoles& work) { return FillHoles(work, ThinPlate()).at(0); }

// The patch closes the hole with good triangles, all over within tolerance of the truth.
void ExpectFollows(const CellHoles& work, const HolePatch& patch, const std::function<double(const Point3&)>& distance,
                   double tolerance) {
  ExpectClosesHole(work, work.holes[0], patch);
  const PatchQuality quality = QualityOf(work, patch);
  EXPECT_GT(quality.least, 0.3);
  EXPECT_GT(quality.mean, 0.85);
  for (const Triangle& t : patch.triangles) {
    const Point3 a = CornerOf(work, patch, t[0]), b = CornerOf(work, patch, t[1]), c = CornerOf(work, patch, t[2]);
    for (const Point3& p : {a, b, c, Point3((a + b) / 2), Point3((b + c) / 2), Point3((c + a) / 2)}) {
      EXPECT_LT(distance(p), tolerance) << p.transpose();
    }
  }
}

struct SheetCase {
  const char* name;
  double u, v, radius, noise;
};
void PrintTo(const SheetCase& c, std::ostream* os) { *os << c.name; }

class FoldedSheetTest : public testing::TestWithParam<SheetCase> {};
INSTANTIATE_TEST_SUITE_P(Holes, FoldedSheetTest,
                         testing::Values(SheetCase{"RoofEdge", 0, kWallHeight, 6, kNoise},
                                         SheetCase{"RoofEdgeExact", 0, kWallHeight, 6, 0},
                                         SheetCase{"SmallOnRoofEdge", 3, kWallHeight, 2.4, kNoise},
                                         SheetCase{"FootOfTheWall", 2, 0, 5, kNoise},
                                         SheetCase{"BothEdges", 0, kWallHeight / 2, 8, kNoise},
                                         SheetCase{"Wall", 0, kWallHeight / 2, 3, kNoise}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST_P(FoldedSheetTest, FollowsGroundWallAndRoof) {
  const SheetCase& c = GetParam();
  const CellHoles work = WorkOfSheet(Disc(c.u, c.v, c.radius), FoldToBuilding, c.noise);
  ExpectFollows(work, Fill(work), DistanceToBuilding, c.noise > 0 ? kTolerance : 0.002);
}

TEST_P(FoldedSheetTest, FollowsAnUprightBuildingTurnedOver) {
  const SheetCase& c = GetParam();
  const auto turn = [](const Point3& p) { return Point3(p.z() + 100, -p.x(), -p.y() + 7); };
  const auto back = [](const Point3& p) { return Point3(-p.y(), -(p.z() - 7), p.x() - 100); };
  const CellHoles work = WorkOfSheet(
      Disc(c.u, c.v, c.radius), [&](const Point3& p) { return turn(FoldToBuilding(p)); }, c.noise);
  ExpectFollows(
      work, Fill(work), [&](const Point3& p) { return DistanceToBuilding(back(p)); }, c.noise > 0 ? kTolerance : 0.002);
}

TEST(CreaseFillTest, PutsAVertexOnTheCornerOfABox) {
  const CellHoles work = WorkOfBoxCorner(6, kNoise);
  const HolePatch patch = Fill(work);
  const auto distance = [](const Point3& p) {
    double least = INFINITY;
    for (int k = 0; k < 3; ++k) {
      Point3 off = p.cwiseMax(0.0);
      off[k] = p[k];
      least = std::min(least, off.norm());
    }
    return least;
  };
  ExpectFollows(work, patch, distance, kTolerance);
  const bool has_corner = std::any_of(patch.new_points.begin(), patch.new_points.end(),
                                      [](const Point3& p) { return p.norm() < 3 * kNoise; });
  EXPECT_TRUE(has_corner);
}

TEST(CreaseFillTest, LeavesAnIslandOnARoofsEdge) {
  const auto ring = [](double u, double v) {
    const double r = std::hypot(u, v - kWallHeight);
    return r > 2.2 && r < 7;
  };
  const CellHoles work = WorkOfSheet(ring, FoldToBuilding, kNoise);
  const HolePatch patch = Fill(work);
  ExpectFollows(work, patch, DistanceToBuilding, kTolerance);
  const CellHoles whole = WorkOfSheet(Disc(0, kWallHeight, 7), FoldToBuilding, kNoise);
  EXPECT_NEAR(PatchArea(work, patch), PatchArea(whole, Fill(whole)) - 16, 0.5) << "16 squares stay";
}

TEST(CreaseFillTest, LeavesAnIslandOnTheRoof) {
  const auto hole = [](double u, double v) {
    return std::hypot(u, v - kWallHeight) < 7 && std::hypot(u - 1, v - kWallHeight - 3) > 1.5;
  };
  const CellHoles work = WorkOfSheet(hole, FoldToBuilding, kNoise);
  ExpectFollows(work, Fill(work), DistanceToBuilding, kTolerance);
}

// Three quarters of the way round a tank: over no plane.
TEST(CreaseFillTest, RefinesAHoleAroundATank) {
  const double radius = 5;
  const CellHoles work = WorkOfSheet(IsInTankSlit, RollRoundTank(radius), kNoise);
  ExpectFollows(
      work, Fill(work), [&](const Point3& p) { return std::abs(std::hypot(p.y(), p.z()) - radius); }, 0.4);
}

TEST(CreaseFillTest, RefinesADome) {
  const double radius = 6;
  const auto dome = [&](const Point3& p) {  // from the pole at (0, 5), distances along meridians
    const Point2 off = p.head<2>() - Point2(0, 5);
    const double angle = off.norm() / radius, r = radius * std::sin(angle) / std::max(off.norm(), 1e-9);
    return Point3(r * off.x(), r * off.y(), radius * std::cos(angle));
  };
  const CellHoles work = WorkOfSheet(Disc(0, 5, 7), dome, kNoise);
  const HolePatch patch = Fill(work);
  ExpectClosesHole(work, work.holes[0], patch);
  EXPECT_GT(QualityOf(work, patch).least, 0.2);
  EXPECT_GT(QualityOf(work, patch).mean, 0.85);
  for (const Point3& p : patch.new_points) EXPECT_NEAR(p.norm(), radius, 0.15 * radius) << p.transpose();
}

TEST(CreaseFillTest, HasNothingToDoOnAHill) {
  const auto hill = [](const Point3& p) {
    return Point3(p.x(), p.y(), 12 * std::exp(-(p - Point3(0, 5, 0)).squaredNorm() / 60));
  };
  const CellHoles work = WorkOfSheet(Disc(2, 8, 5), hill, 0.02);
  const CellBand band(work);
  const LocalHole local = MakeLocalHole(work, band, work.holes[0]);
  EXPECT_EQ(FillAlongCreases(local, ThinPlate()).failure, FillFailure::kNotApplicable);
  EXPECT_EQ(Fill(work).way, FillWay::kGround);
}

TEST(CreaseFillTest, KeepsTheRimsSizeAlongCreasesWhenUniform) {
  const CellHoles work = WorkOfSheet(Disc(0, kWallHeight, 8), FoldToBuilding, kNoise);
  FillOptions options = ThinPlate();
  options.refine.uniform = true;
  const HolePatch patch = FillHoles(work, options).at(0);
  ExpectFollows(work, patch, DistanceToBuilding, kTolerance);
  const auto on_crease = [](const Point3& p) { return std::hypot(p.y(), p.z() - kWallHeight) < 2 * kNoise; };
  const auto count = std::count_if(patch.new_points.begin(), patch.new_points.end(), on_crease);
  EXPECT_NEAR(static_cast<double>(count), 15, 2);
  EXPECT_LT(Fill(work).triangles.size(), patch.triangles.size());
}

TEST(CreaseFillTest, GivesTheSameBitsEveryTime) {
  const CellHoles work = WorkOfSheet(Disc(0, kWallHeight / 2, 8), FoldToBuilding, kNoise);
  const HolePatch a = Fill(work), b = Fill(work);
  EXPECT_EQ(a.new_points, b.new_points);
  EXPECT_EQ(a.triangles, b.triangles);
}

TEST(CreaseFillTest, LeavesThePapersSurfaceAlone) {
  const CellHoles work = WorkOfSheet(Disc(0, kWallHeight, 6), FoldToBuilding, kNoise);
  FillOptions wang;
  wang.surface = Surface::kWang;
  wang.published = AllPublishedWays();
  const HolePatch patch = FillHoles(work, wang).at(0);
  double most = 0;
  for (const Point3& p : patch.new_points) most = std::max(most, DistanceToBuilding(p));
  EXPECT_GT(most, 0.3) << "it rounds the edge off";
}

}  // namespace
}  // namespace tilemend
