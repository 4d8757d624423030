// Single meshes from the survey to the patch: what does not depend on size and direction, and which loops are holes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "common/mesh/triangle_shape.h"
#include "tests/support/filled_mesh.h"
#include "tests/support/round_meshes.h"
#include "tests/support/space_meshes.h"

namespace tilemend {
namespace {

using ::testing::IsEmpty;

// Of each hole: edges, kind, way, reason.
using Outcome = std::tuple<int32_t, SingleType, FillWay, std::string>;

std::vector<Outcome> OutcomesOf(const FilledMesh& filled) {
  std::vector<Outcome> outcomes;
  for (const HolePatch& patch : filled.patches) {
    const PlannedHole& hole = filled.plan.holes[patch.hole];
    outcomes.emplace_back(hole.boundary_vertices, hole.single, patch.way, patch.failure);
  }
  return outcomes;
}

TriMesh Scaled(TriMesh mesh, double factor) {
  for (Point3& p : mesh.points) p *= factor;
  return mesh;
}

double Wave(double x, double y) { return 0.7 * std::sin(x) * std::cos(0.8 * y); }

std::vector<std::pair<const char*, TriMesh>> Meshes() {
  const auto in_corner = [](const Point3& p) { return p.norm() < 2.5; };
  const auto in_face = [](const Point3& p) { return (p - Point3(3, 3, 0)).norm() < 1.7; };
  const auto in_edge = [](const Point3& p) { return (p - Point3(3, 0, 0)).norm() < 1.7; };
  const auto in_sphere = [](const Point3& p) { return (p - Point3(0, 0.6, 0.8)).norm() < 0.5; };
  const auto in_sheet = [](int32_t i, int32_t j) { return i < 4 || i > 9 || j < 3 || j > 8; };
  TriMesh belts = SphereBelt(0, 60);
  AddMesh(SphereBelt(75, 150), belts);
  return {{"corner", Shaken(WithoutHole(BoxMesh(6), in_corner), 0.05, 1)},
          {"face", Shaken(WithoutHole(BoxMesh(6), in_face), 0.05, 2)},
          {"edge", Shaken(WithoutHole(BoxMesh(6), in_edge), 0.05, 3)},
          {"sphere", Shaken(WithoutHole(SphereBelt(0, 160), in_sphere), 0.005, 4)},
          {"sheet", SquaresMesh(0, 14, 0, 12, in_sheet, Wave)},
          {"belts", Shaken(belts, 0.005, 5)},
          {"torus", TorusPart(16, 40, 5, 1, 0.95)}};
}

TEST(MeshFillTest, GivesTheSameOutcomesForAMeshOfAnySizeTurnedInAnyWay) {
  for (const auto& [name, mesh] : Meshes()) {
    const FilledMesh plain = Fill(mesh);
    for (const double factor : {1e-6, 1e-3, 1.0, 1e3}) {
      for (int way = 0; way < 7; ++way) {
        SCOPED_TRACE(testing::Message() << name << " times " << factor << " turned " << way);
        const FilledMesh other = Fill(Turned(Scaled(mesh, factor), way));
        EXPECT_EQ(OutcomesOf(other), OutcomesOf(plain));
        EXPECT_EQ(other.detached, plain.detached);
        for (size_t h = 0; h < plain.patches.size(); ++h) {
          const double most = 0.2 * static_cast<double>(plain.patches[h].new_points.size()) + 1;
          EXPECT_NEAR(static_cast<double>(other.patches[h].new_points.size()),
                      static_cast<double>(plain.patches[h].new_points.size()), most);
        }
      }
    }
  }
}

TEST(MeshFillTest, GivesTheSamePatchesForAMeshSeveralTimesDoubled) {
  for (const auto& [name, mesh] : Meshes()) {
    const FilledMesh plain = Fill(mesh);
    for (const int power : {-20, -10, 3, 10}) {
      SCOPED_TRACE(testing::Message() << name << " doubled " << power << " times");
      const double factor = std::ldexp(1.0, power);
      const FilledMesh other = Fill(Scaled(mesh, factor));
      EXPECT_EQ(OutcomesOf(other), OutcomesOf(plain));
      ASSERT_EQ(other.patches.size(), plain.patches.size());
      for (size_t h = 0; h < plain.patches.size(); ++h) {
        EXPECT_EQ(other.patches[h].triangles, plain.patches[h].triangles);
        ASSERT_EQ(other.patches[h].new_points.size(), plain.patches[h].new_points.size());
        for (size_t p = 0; p < plain.patches[h].new_points.size(); ++p) {
          EXPECT_EQ(other.patches[h].new_points[p], plain.patches[h].new_points[p] * factor);
        }
      }
    }
  }
}

// Triangles around (0, 0, 0) up to a circle with heights by the turn.
TriMesh Fan(int32_t n, const std::function<double(double)>& height) {
  TriMesh fan;
  fan.points.emplace_back(0, 0, 0);
  for (int32_t i = 0; i < n; ++i) {
    const double turn = 2 * std::numbers::pi * i / n;
    fan.points.emplace_back(std::cos(turn), std::sin(turn), height(turn));
    fan.triangles.push_back({0, i + 1, (i + 1) % n + 1});
  }
  return fan;
}

FilledMesh WithOutlineFilled(const TriMesh& mesh, Surface surface) {
  MeshHoleOptions choice;
  choice.fill_outlines = true;
  return Fill(mesh, surface, choice);
}

// The middle of the patch would lie on the middle of the fan.
TEST(MeshFillTest, PutsNoNewVertexOnOneOfTheMesh) {
  for (const int32_t n : {16, 24, 32, 36, 60}) {
    SCOPED_TRACE(n);
    ExpectSound(WithOutlineFilled(Fan(n, [](double turn) { return std::cos(4 * turn); }), Surface::kThinPlate));
  }
}

TEST(MeshFillTest, CountsTheEdgesAtWhichAPublishedPatchFoldsBack) {
  for (const double height : {0.2, 2.0}) {
    const FilledMesh cup = WithOutlineFilled(Fan(24, [&](double) { return height; }), Surface::kWang);
    ASSERT_EQ(cup.patches.size(), 1u);
    EXPECT_EQ(cup.patches[0].failure, "");
    EXPECT_EQ(cup.patches[0].creases > 0, height < 1);
  }
}

TEST(MeshFillTest, TellsOfPatchesThatCrossWhatPassesThroughTheirBoundary) {
  const FilledMesh alone = Fill(SphereBelt(0, 100));
  ASSERT_EQ(alone.patches.size(), 1u);
  EXPECT_FALSE(alone.patches[0].rim_is_crossed);
  TriMesh through = SphereBelt(0, 100);
  through.points.insert(through.points.end(), {{0.5, -0.2, -3}, {2, -0.1, -0.2}, {0.5, 0.3, 3}});
  const auto n = static_cast<int32_t>(through.points.size());
  through.triangles.push_back({n - 3, n - 2, n - 1});
  const FilledMesh crossed = Fill(through);
  const auto tells = [](const HolePatch& patch) { return patch.failure.empty() && patch.rim_is_crossed; };
  EXPECT_TRUE(std::ranges::any_of(crossed.patches, tells));
}

TEST(MeshFillTest, TakesEveryLoopOfABodyForAHole) {
  // Limbs that widen towards the cut.
  for (const double widening : {-0.5, 0.0, 0.5, 1.0}) {
    SCOPED_TRACE(widening);
    const TriMesh limb = TubeMesh(24, 30, [&](double turn, double share) {
      const double radius = share > 0.99 ? 1e-3 : share < 0.3 ? 1 + widening * (0.3 - share) * 3 : 1;
      return Point3(radius * std::cos(turn), radius * std::sin(turn), 12 * share);
    });
    const FilledMesh filled = Fill(limb);
    EXPECT_EQ(filled.detached, 0);
    EXPECT_EQ(filled.plan.holes.size(), 2u);
  }
}

TEST(MeshFillTest, DoesNotChangeItsMindAboutSpheresCutAboutTheMiddle) {
  for (const double degrees : {84., 88., 89.9, 90., 90.1, 92., 96.}) {
    EXPECT_EQ(Fill(SphereBelt(0, degrees)).plan.holes.size(), 1u) << degrees;
  }
}

TEST(MeshFillTest, LeavesTheOutlineOfASheetAloneAndNoOtherLoop) {
  const auto keep = [](int32_t i, int32_t j) { return (i % 4 != 2 || j % 4 != 2) && (i < 17 || i > 18 || j != 17); };
  const TriMesh sheet = SquaresMesh(0, 20, 0, 20, keep, Wave);
  for (int way = 0; way < 7; ++way) {
    const FilledMesh filled = Fill(Turned(sheet, way));
    EXPECT_EQ(filled.detached, 1);
    EXPECT_EQ(filled.plan.holes.size(), 25u);
    EXPECT_THAT(filled.failures, IsEmpty());
  }
}

TEST(MeshFillTest, FillsOutlinesAndLeavesLongHolesIfAsked) {
  const TriMesh sheet = SquaresMesh(
      0, 9, 0, 9, [](int32_t i, int32_t j) { return i != 4 || j < 3 || j > 5; }, Wave);
  const FilledMesh all = Fill(sheet, Surface::kThinPlate, {true, {}});
  EXPECT_EQ(all.detached, 0);
  EXPECT_EQ(all.plan.holes.size(), 2u);
  const FilledMesh none = Fill(sheet, Surface::kThinPlate, {false, 7});
  EXPECT_EQ(none.plan.holes.size(), 0u);
  ASSERT_EQ(none.plan.left.size(), 2u);
  EXPECT_EQ(none.plan.left[0].reason, "longer than --largest-hole");
  EXPECT_FALSE(none.plan.left[0].is_hole);
  EXPECT_EQ(Fill(sheet, Surface::kThinPlate, {false, 8}).plan.holes.size(), 1u);
}

TEST(MeshFillTest, GoesOnAsASaddleOnTheInsideOfABentTube) {
  const Point3 middle = 1.6 * Point3(std::cos(0.8 * std::numbers::pi), std::sin(0.8 * std::numbers::pi), 0);
  const TriMesh tube = TorusPart(32, 80, 2.6, 1, 0.8);
  const FilledMesh filled = Fill(WithoutHole(tube, [&](const Point3& p) { return (p - middle).norm() < 0.9; }));
  double off = 0;
  int32_t points = 0;
  for (const HolePatch& patch : filled.patches) {
    for (const Point3& p : patch.new_points) {
      if ((p - middle).norm() > 0.95) continue;
      ++points;
      off = std::max(off, std::abs(std::hypot(p.head<2>().norm() - 2.6, p.z()) - 1));
    }
  }
  EXPECT_GT(points, 20);
  EXPECT_LT(off, 0.011);
}

// A sphere whose lower half has other vertices along the equator.
TriMesh SphereWithASeam(int32_t above, int32_t below) {
  TriMesh mesh = SphereBelt(0, 90, above), lower = SphereBelt(0, 90, below);
  for (Point3& p : mesh.points) p.z() = std::abs(p.z()) < 1e-9 ? 0 : p.z();
  for (Point3& p : lower.points) p = Point3(p.x(), -p.y(), std::abs(p.z()) < 1e-9 ? 0 : -p.z());
  for (Point3& p : mesh.points) {
    for (const Point3& q : lower.points) p = (p - q).norm() < 1e-9 ? q : p;
  }
  AddMesh(lower, mesh);
  return mesh;
}

TEST(MeshFillTest, FillsTheHolesOfASeamWhereOneSideHasMoreVertices) {
  for (const int32_t more : {2, 3, 4}) {
    for (const int way : {0, 3, 4, 6}) {
      const FilledMesh filled = Fill(Turned(SphereWithASeam(24, 24 * more), way));
      EXPECT_EQ(filled.detached, 0);
      EXPECT_EQ(filled.plan.holes.size(), 24u) << more << " turned " << way;
      EXPECT_THAT(filled.failures, IsEmpty());
      EXPECT_EQ(ExpectSound(filled), 0);
    }
  }
}

TEST(MeshFillTest, StitchesRimsThatNearlyCoincideAndCapsThemNotTwice) {
  for (const int32_t below : {36, 31}) {
    TriMesh mesh = SphereBelt(0, 90, 36), lower = SphereBelt(0, 90, below);
    for (Point3& p : lower.points) p = Point3(p.x(), -p.y(), -p.z() - 1e-3);
    AddMesh(lower, mesh);
    const FilledMesh filled = Fill(mesh);
    ASSERT_EQ(filled.plan.holes.size(), 1u);
    EXPECT_EQ(filled.plan.holes[0].single, SingleType::kAnnular);
    EXPECT_THAT(filled.failures, IsEmpty());
    double area = 0;
    for (size_t t = filled.originals; t < filled.mesh.triangles.size(); ++t) {
      area += TwiceVectorArea(filled.mesh.points, filled.mesh.triangles[t]).norm() / 2;
    }
    EXPECT_LT(area, 0.05) << "a cap has more than 3";
  }
}

// A bowl with an inner and an outer side, `thick` apart, cut at an angle from its pole.
TriMesh Bowl(double thick, double degrees) {
  TriMesh mesh = SphereBelt(0, degrees, 36), inner = mesh;
  for (Point3& p : inner.points) p *= 1 - thick;
  for (Triangle& t : inner.triangles) std::swap(t[0], t[1]);
  AddMesh(inner, mesh);
  return mesh;
}

TEST(MeshFillTest, JoinsTheTwoSidesOfAThinWall) {
  for (const double thick : {0.02, 0.1, 0.3}) {
    for (const double degrees : {50.0, 90.0, 125.0}) {
      SCOPED_TRACE(testing::Message() << thick << " thick, " << degrees << " degrees");
      const FilledMesh filled = Fill(Bowl(thick, degrees));
      EXPECT_EQ(filled.detached, 0);
      ASSERT_EQ(filled.plan.holes.size(), 1u);
      EXPECT_EQ(filled.plan.holes[0].single, SingleType::kAnnular);
      EXPECT_THAT(filled.failures, IsEmpty());
      EXPECT_EQ(ExpectSound(filled), 0);
    }
  }
}

TEST(MeshFillTest, MakesNoTunnelThroughAThinBody) {
  TriMesh lens = SphereBelt(0, 180, 40, 20);
  for (Point3& p : lens.points) p.z() *= 0.03;
  lens = WithoutHole(Welded(lens), [](const Point3& p) { return p.head<2>().norm() < 0.3; });
  const FilledMesh filled = Fill(lens);
  EXPECT_EQ(filled.plan.holes.size(), 2u);
  EXPECT_THAT(filled.failures, IsEmpty());
  EXPECT_EQ(ExpectSound(filled), 0);
}

// A flat ellipsoid without what is near a place, filled: the mean distance of new points from it, in directions across
// or along its plane.
double ErrorOnLens(int32_t around, double thickness, const Point3& place, double radius) {
  TriMesh lens = SphereBelt(0, 180, around, around / 3);
  for (Point3& p : lens.points) p.z() *= thickness;
  const auto in_hole = [&](const Point3& p) { return (p - place).norm() < radius; };
  const FilledMesh filled = Fill(WithoutHole(Welded(lens), in_hole));
  EXPECT_THAT(filled.failures, IsEmpty());
  double off = 0;
  size_t points = 0;
  for (const HolePatch& patch : filled.patches) {
    points += patch.new_points.size();
    for (const Point3& p : patch.new_points) {
      const double out = p.head<2>().norm();
      const double height = thickness * std::sqrt(std::max(0.0, 1 - out * out));
      off += std::min(std::abs(std::abs(p.z()) - height), std::hypot(std::max(0.0, out - 1), p.z()));
    }
  }
  return off / static_cast<double>(points);
}

// A boundary of 180 vertices: cut down to fewer it is spanned from one side to the other.
TEST(MeshFillTest, GoesAroundTheEdgeOfAThinBody) { EXPECT_LT(ErrorOnLens(300, 0.05, {1, 0, 0}, 0.3), 0.002); }

// Heights over a plane stand like a wall where the edge of a thin body is gone: triangles in space go on better.
TEST(MeshFillTest, TurnsLittleAtTheRim) { EXPECT_LT(ErrorOnLens(90, 0.1, {0.9, 0, 0.05}, 0.45), 0.018); }

TEST(MeshFillTest, FillsTheHolesOfAMeshThatIsThereTwice) {
  TriMesh sphere =
      WithoutHole(SphereBelt(0, 160), [](const Point3& p) { return (p - Point3(0, 0.6, 0.8)).norm() < 0.5; });
  const FilledMesh once = Fill(sphere);
  sphere.triangles.insert(sphere.triangles.end(), sphere.triangles.begin(), sphere.triangles.end());
  const FilledMesh twice = Fill(sphere);
  EXPECT_EQ(twice.originals, sphere.triangles.size());
  EXPECT_THAT(twice.plan.left, IsEmpty());
  EXPECT_EQ(OutcomesOf(twice), OutcomesOf(once));
  EXPECT_THAT(twice.failures, IsEmpty());
}

TEST(MeshFillTest, SaysThatFacesAreFrontAndBack) {
  TriMesh belt = SphereBelt(30, 150);
  for (const Triangle& t : std::vector<Triangle>(belt.triangles)) belt.triangles.push_back({t[1], t[0], t[2]});
  const FilledMesh filled = Fill(belt);
  ASSERT_EQ(filled.plan.left.size(), 1u);
  EXPECT_THAT(filled.plan.left[0].reason, testing::HasSubstr("more than once"));
  EXPECT_EQ(filled.plan.left[0].edges, 48);
  EXPECT_TRUE(filled.plan.left[0].is_hole);
}

TEST(MeshFillTest, AccountsForEveryBoundaryEdge) {
  // A fin on a box with a hole: its free edges form no loop.
  TriMesh mesh = WithoutHole(BoxMesh(5), [](const Point3& p) { return p.norm() < 1.6; });
  const auto at = [&](const Point3& p) {
    return static_cast<int32_t>(std::ranges::find(mesh.points, p) - mesh.points.begin());
  };
  mesh.triangles.push_back({at({5, 2, 2}), at({5, 3, 2}), static_cast<int32_t>(mesh.points.size())});
  mesh.points.emplace_back(7, 2.5, 2);
  const FilledMesh filled = Fill(mesh);
  EXPECT_THAT(filled.failures, IsEmpty());
  ASSERT_EQ(filled.plan.left.size(), 1u);
  EXPECT_EQ(filled.plan.left[0].edges, 2);
  EXPECT_TRUE(filled.plan.left[0].is_hole);
}

TEST(MeshFillTest, SaysThatTheBoundaryOfAMoebiusStripChangesItsDirection) {
  constexpr int32_t kSteps = 24;
  TriMesh strip;
  for (int32_t i = 0; i < kSteps; ++i) {
    const double turn = 2 * std::numbers::pi * i / kSteps;
    for (const double side : {-0.5, 0.5}) {
      const double out = 2 + side * std::cos(turn / 2);
      strip.points.emplace_back(out * std::cos(turn), out * std::sin(turn), side * std::sin(turn / 2));
    }
  }
  for (int32_t i = 0; i < kSteps; ++i) {
    const bool last = i + 1 == kSteps;
    const int32_t a = 2 * i, b = a + 1, c = last ? 1 : a + 2, d = last ? 0 : a + 3;
    strip.triangles.push_back({a, c, b});
    strip.triangles.push_back({b, c, d});
  }
  const FilledMesh filled = Fill(strip);
  int64_t edges = 0;
  for (const LeftOpen& left : filled.plan.left) {
    EXPECT_THAT(left.reason, testing::HasSubstr("opposite ways"));
    edges += left.edges;
  }
  EXPECT_EQ(edges, 2 * kSteps);
}

}  // namespace
}  // namespace tilemend
