// Holes that lie over no plane, from the survey to the patch: whatever is filled is sound, and nearly all are filled.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "tests/support/filled_mesh.h"
#include "tests/support/round_meshes.h"
#include "tests/support/space_meshes.h"

namespace tilemend {
namespace {

using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// An island at the corner of a box, in the hole around it: on one face, on the edge, over the corner.
TEST(SpaceFillTest, FillsAroundAnIslandAtTheCornerOfABox) {
  const Point3 places[] = {{0, 1.7, 1.3}, {0, 0, 1.5}, {0, 0, 0}, {0, 0.3, 0.3}};
  for (int way = 0; way < 7; ++way) {
    for (const Point3& place : places) {
      for (const double noise : {0.0, 0.08}) {
        SCOPED_TRACE(testing::Message() << "turned " << way << " island at " << place.transpose() << " noise "
                                        << noise);
        const TriMesh holed =
            WithoutHole(BoxMesh(7), [&](const Point3& p) { return p.norm() < 3.3 && (p - place).norm() > 0.9; });
        const FilledMesh filled = Fill(Turned(Shaken(holed, noise, 1), way));
        EXPECT_THAT(filled.failures, IsEmpty());
        EXPECT_EQ(filled.detached, 0);
        EXPECT_EQ(ExpectSound(filled), 0);
      }
    }
  }
}

// Holes about the corners and edges of noisy boxes. Where the noise makes the rim touch the surface none can be filled.
TEST(SpaceFillTest, FillsHolesInNoisyBoxesSoundly) {
  for (const Surface surface : {Surface::kThinPlate, Surface::kWang}) {
    int holes = 0, closed = 0;
    for (uint32_t seed = 0; seed < 48; ++seed) {
      SCOPED_TRACE(testing::Message() << "seed " << seed);
      const double radius = 1.5 + 0.4 * (seed % 6), noise = 0.05 + 0.06 * (seed % 5);
      const Point3 middle(0, seed % 4 < 2 ? 0 : 2.5, seed % 4 == 0 ? 0 : 2.5);
      const TriMesh holed = WithoutHole(BoxMesh(6), [&](const Point3& p) { return (p - middle).norm() < radius; });
      const FilledMesh filled = Fill(Turned(Shaken(holed, noise, seed), static_cast<int>(seed % 7)), surface);
      const int open = ExpectSound(filled);
      EXPECT_EQ(open == 0, filled.failures.empty());
      EXPECT_THAT(filled.failures, Each(HasSubstr("passes through")));
      ++holes;
      closed += open == 0;
    }
    EXPECT_GE(closed, holes * 0.95);
  }
}

// A band wound several times round a torus: over no plane, with hundreds of edges.
TEST(SpaceFillTest, FillsALongHoleThatProjectsOnNoPlane) {
  for (const int32_t around : {24, 48}) {
    SCOPED_TRACE(around);
    const int32_t along = 5 * around;
    const auto at = [&](double turn, double share) {
      const double way = share < 1 ? 2 * std::numbers::pi * share : 0, off = 5 + 2 * std::cos(turn);
      return Point3(off * std::cos(way), off * std::sin(way), -2 * std::sin(turn));
    };
    TriMesh mesh = Welded(TubeMesh(around, along, at));
    std::vector<Triangle> kept;
    for (size_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto square = static_cast<int32_t>(t / 2);
      const double share = (square / around + 0.5) / along, turn = (square % around + 0.5) / around;
      const double wound = 6 * share - turn;
      if (share < 0.1 || share > 0.9 || wound - std::floor(wound) > 0.5) kept.push_back(mesh.triangles[t]);
    }
    mesh.triangles = kept;
    const FilledMesh filled = Fill(mesh);
    ASSERT_EQ(filled.plan.holes.size(), 1u);
    EXPECT_GT(filled.plan.holes[0].segments.size(), around * 12u);
    EXPECT_THAT(filled.failures, IsEmpty());
    EXPECT_EQ(ExpectSound(filled), 0);
    ASSERT_FALSE(filled.patches[0].new_points.empty());
    for (const Point3& p : filled.patches[0].new_points) {
      EXPECT_NEAR(std::hypot(std::hypot(p.x(), p.y()) - 5, p.z()), 2, 0.5);
    }
  }
}

// Of a closed body in the hole there is nothing on the rim: it is known from the surface alone.
TEST(SpaceFillTest, FillsAroundABodyInTheHole) {
  int closed = 0;
  for (int way = 0; way < 7; ++way) {
    SCOPED_TRACE(testing::Message() << "turned " << way);
    TriMesh mesh = WithoutHole(BoxMesh(6), [](const Point3& p) { return p.norm() < 2.5; });
    AddMesh(Tetrahedron(Point3(0.4, 0.4, 0.4), 0.15), mesh);
    const FilledMesh filled = Fill(Turned(mesh, way));
    const int open = ExpectSound(filled);
    EXPECT_EQ(open == 0, filled.failures.empty());
    closed += open == 0;
  }
  EXPECT_EQ(closed, 7);
}

TEST(SpaceFillTest, LeavesAHoleOpenThatEveryPatchOfCrossesTheSurface) {
  TriMesh mesh = WithoutHole(BoxMesh(6), [](const Point3& p) { return p.norm() < 2.5; });
  AddMesh(Needle(Point3(0.5, 0.5, 0.5)), mesh);
  const FilledMesh filled = Fill(mesh);
  EXPECT_THAT(filled.failures, testing::ElementsAre(HasSubstr("passes through itself or the surface around it")));
  EXPECT_EQ(filled.mesh.triangles.size(), filled.originals);
}

// Where the mesh crosses itself already, a patch may do so too.
TEST(SpaceFillTest, FillsAHoleThatTheSurfacePassesThroughTheRimOf) {
  TriMesh mesh = WithoutHole(BoxMesh(6), [](const Point3& p) { return p.norm() < 2.5; });
  AddMesh(Tetrahedron(Point3(2.5, 0.5, 0), 0.7), mesh);
  const FilledMesh filled = Fill(mesh);
  EXPECT_THAT(filled.failures, testing::IsEmpty());
  EXPECT_GT(filled.mesh.triangles.size(), filled.originals);
}

// Two holes on both sides of a thin plate, and between them nothing: the second patch may not meet the first.
TEST(SpaceFillTest, KeepsPatchesOfTwoHolesApart) {
  TriMesh plate = BoxMesh(10);
  for (Point3& p : plate.points) p.z() *= 0.03;
  const TriMesh mesh = WithoutHole(
      plate, [](const Point3& p) { return (p - Point3(5, 5, p.z())).norm() < 3.2 && std::abs(p.z() - 0.15) > 0.1; });
  for (int way = 0; way < 7; ++way) {
    SCOPED_TRACE(testing::Message() << "turned " << way);
    const FilledMesh filled = Fill(Turned(Shaken(mesh, 0.05, 3), way));
    EXPECT_EQ(ExpectSound(filled) == 0, filled.failures.empty());
  }
}

}  // namespace
}  // namespace tilemend
