// Zhang 2022: at least twenty made meshes of each kind of hole, recognised and mended.
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

using ::testing::IsEmpty;

bool Everywhere(int32_t, int32_t) { return true; }

// A flat sheet of 14 x 10 squares with a slit along y = 5 from x = 3 to `to`.
TriMesh SlitSheet(int32_t to, double width) {
  TriMesh mesh = SquaresMesh(0, 14, 0, 10, Everywhere);
  const size_t count = mesh.points.size();
  std::vector<int32_t> above(count, -1);
  for (size_t v = 0; v < count; ++v) {
    if (mesh.points[v].y() != 5 || mesh.points[v].x() <= 3 || mesh.points[v].x() >= to) continue;
    above[v] = static_cast<int32_t>(mesh.points.size());
    const Point3 p = mesh.points[v];
    mesh.points.push_back(p + Point3(0, width / 2, 0));
    mesh.points[v] = p - Point3(0, width / 2, 0);
  }
  for (Triangle& t : mesh.triangles) {
    double y = 0;
    for (const int32_t v : t) y += above[v] >= 0 ? 5 : mesh.points[v].y();
    for (int32_t& v : t) v = y > 15 && above[v] >= 0 ? above[v] : v;
  }
  return mesh;
}

// Bent about a point below the sheet, in its plane.
TriMesh BentInPlane(const TriMesh& mesh, double radius) {
  return Moved(mesh, [&](const Point3& p) {
    const double angle = p.x() / (radius + 5), r = radius + p.y();
    return Point3(r * std::sin(angle), r * std::cos(angle), 0.02 * p.x() * p.x());
  });
}

// What is expected of a mesh with one hole of a kind.
void ExpectMended(const TriMesh& mesh, SingleType kind) {
  for (const int way : {0, 4}) {
    const FilledMesh filled = Fill(Turned(mesh, way));
    int64_t of_kind = 0;
    for (const PlannedHole& hole : filled.plan.holes) of_kind += hole.single == kind;
    EXPECT_EQ(of_kind, 1);
    EXPECT_THAT(filled.failures, IsEmpty());
    ExpectSound(filled);
    if (kind != SingleType::kCrack && kind != SingleType::kDislocation) continue;
    // Stitched: thin triangles between vertices that are there.
    for (const HolePatch& patch : filled.patches) EXPECT_THAT(patch.new_points, IsEmpty());
  }
}

TEST(HoleKindsTest, Cracks) {
  for (int32_t to = 6; to <= 10; ++to) {
    for (const double width : {0.01, 0.03, 0.05, 0.08}) {
      SCOPED_TRACE(testing::Message() << to << " " << width);
      ExpectMended(SlitSheet(to, width), SingleType::kCrack);
    }
  }
}

TEST(HoleKindsTest, Dislocations) {
  for (int32_t to = 8; to <= 12; ++to) {
    for (const double width : {0.03, 0.06, 0.1, 0.14}) {
      SCOPED_TRACE(testing::Message() << to << " " << width);
      ExpectMended(BentInPlane(SlitSheet(to, width), 4), SingleType::kDislocation);
    }
  }
}

TEST(HoleKindsTest, AnnularHoles) {
  for (const double share : {0.94, 0.95, 0.96, 0.97}) {
    for (int32_t around = 8; around <= 24; around += 4) {
      SCOPED_TRACE(testing::Message() << share << " " << around);
      ExpectMended(TorusPart(around, 40, 5, 1, share), SingleType::kAnnular);
    }
  }
}

TEST(HoleKindsTest, Islands) {
  for (int32_t size = 1; size <= 4; ++size) {
    for (int32_t at = 4; at <= 8; ++at) {
      SCOPED_TRACE(testing::Message() << size << " " << at);
      const auto keep = [&](int32_t i, int32_t j) {
        return i < 3 || i > 13 || j < 3 || j > 13 || (i >= at && i < at + size && j >= at && j < at + size);
      };
      ExpectMended(SquaresMesh(0, 17, 0, 17, keep, [](double x, double y) { return 0.02 * (x * x - x * y); }),
                   SingleType::kIsland);
    }
  }
}

TEST(HoleKindsTest, SimpleHoles) {
  for (int k = 0; k < 20; ++k) {
    SCOPED_TRACE(k);
    const double turn = 0.7 * k, radius = 1.2 + 0.1 * k;
    const Point3 middle(3 + 3 * std::cos(turn), 3 + 3 * std::sin(turn), k % 2 == 0 ? 0 : 6);
    ExpectMended(WithoutHole(BoxMesh(6), [&](const Point3& p) { return (p - middle).norm() < radius; }),
                 SingleType::kSimple);
  }
}

// Squares along a diagonal, each touching the next one: as many single holes.
TEST(HoleKindsTest, ContinuousHolesAreSegmented) {
  for (int32_t count = 2; count <= 6; ++count) {
    for (int32_t at = 1; at <= 4; ++at) {
      SCOPED_TRACE(testing::Message() << count << " " << at);
      const auto keep = [&](int32_t i, int32_t j) { return i - j != at || i < 5 || i >= 5 + count; };
      const FilledMesh filled = Fill(SquaresMesh(0, 14, 0, 14, keep));
      EXPECT_EQ(filled.plan.continuous, 1);
      EXPECT_EQ(std::ssize(filled.plan.holes), count);
      EXPECT_THAT(filled.failures, IsEmpty());
      ExpectSound(filled);
    }
  }
}

// An island that touches its rim at one vertex.
TEST(HoleKindsTest, AnIslandThatTouchesItsRimMakesAContinuousHole) {
  const auto keep = [](int32_t i, int32_t j) {
    return i < 3 || i > 9 || j < 3 || j > 9 || (i >= 3 && i < 5 && j >= 3 && j < 5 && (i + j) == 0);
  };
  TriMesh mesh = SquaresMesh(0, 13, 0, 13, keep);
  AddMesh(Moved(SquaresMesh(0, 2, 0, 2, Everywhere),
                [](const Point3& p) { return Point3(3 + p.x() + p.y(), 6 + p.y() - p.x(), 0); }),
          mesh);
  const FilledMesh filled = Fill(Welded(mesh));
  EXPECT_EQ(filled.plan.continuous, 1);
  ASSERT_EQ(filled.plan.holes.size(), 1u);
  EXPECT_TRUE(filled.plan.holes[0].continuous);
  EXPECT_THAT(filled.failures, IsEmpty());
  ExpectSound(filled);
}

}  // namespace
}  // namespace tilemend
