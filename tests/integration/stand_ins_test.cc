// Stand-ins for three models of Zhang 2022, 5, with the same holes: a hat (8 cracks, 3 simple holes), an ornament (1
// annular, 2 simple, 1 island) and a backpack (2 continuous holes, of 1 and of 5 single ones).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <vector>

#include "tests/support/filled_mesh.h"
#include "tests/support/round_meshes.h"
#include "tests/support/space_meshes.h"

namespace tilemend {
namespace {

using ::testing::IsEmpty;
using ::testing::Pair;
using ::testing::UnorderedElementsAre;

std::map<SingleType, int> KindsOf(const Plan& plan) {
  std::map<SingleType, int> kinds;
  for (const PlannedHole& hole : plan.holes) ++kinds[hole.single];
  return kinds;
}

// Opens a mesh of squares along y from x = `from` to `to`, by a hundredth on each side.
void Slit(double from, double to, double y, TriMesh& mesh) {
  std::map<int32_t, int32_t> above;
  const auto at_y = [&](double of) { return std::abs(of - y) < 0.5; };
  for (Triangle& t : mesh.triangles) {
    double middle = 0;
    for (const int32_t v : t) middle += mesh.points[v].y() / 3;
    for (int32_t& v : t) {
      const Point3 p = mesh.points[v];
      if (middle < y || !at_y(p.y()) || p.x() <= from || p.x() >= to) continue;
      const auto [it, fresh] = above.try_emplace(v, static_cast<int32_t>(mesh.points.size()));
      if (fresh) mesh.points.push_back(p + Point3(0, 0.01, 0));
      v = it->second;
    }
  }
  for (const auto& [below, copy] : above) mesh.points[below].y() -= 0.01;
}

TEST(StandInsTest, Hat) {
  const auto in_hole = [](int32_t i, int32_t j) {
    return (i >= 18 && i < 22 && j >= 18 && j < 21) || (i >= 14 && i < 16 && j >= 20 && j < 22) || (i == 25 && j == 16);
  };
  TriMesh mesh = SquaresMesh(0, 40, 0, 40, [&](int32_t i, int32_t j) { return !in_hole(i, j); });
  for (int k = 0; k < 4; ++k) {
    Slit(4 + 9 * k, 9 + 9 * k, 4, mesh);
    Slit(4 + 9 * k, 8 + 9 * k, 36, mesh);
  }
  mesh = Moved(mesh, [](const Point3& p) {
    return Point3(p.x(), p.y(), 8 * std::exp(-(std::pow(p.x() - 20, 2) + std::pow(p.y() - 20, 2)) / 40));
  });
  for (const int way : {0, 3}) {
    const FilledMesh filled = Fill(Turned(mesh, way));
    EXPECT_THAT(KindsOf(filled.plan), UnorderedElementsAre(Pair(SingleType::kCrack, 8), Pair(SingleType::kSimple, 3)));
    EXPECT_EQ(filled.plan.continuous, 0);
    EXPECT_THAT(filled.failures, IsEmpty());
    EXPECT_EQ(filled.detached, 1);  // the brim
    ExpectSound(filled);
  }
}

TEST(StandInsTest, Ornament) {
  constexpr int32_t kAround = 24, kAlong = 90;
  TriMesh mesh = TorusPart(kAround, kAlong, 5, 1.3, 0.95);
  std::vector<Triangle> kept;
  for (size_t t = 0; t < mesh.triangles.size(); ++t) {
    const int32_t square = static_cast<int32_t>(t / 2), i = square % kAround, j = square / kAround;
    const bool simple = (j >= 10 && j < 15 && i >= 2 && i < 6) || (j >= 30 && j < 33 && i >= 12 && i < 15);
    const bool ring = j >= 50 && j < 59 && i >= 4 && i < 13 && !(j >= 53 && j < 56 && i >= 7 && i < 10);
    if (!simple && !ring) kept.push_back(mesh.triangles[t]);
  }
  mesh.triangles = kept;
  for (const int way : {0, 5}) {
    const FilledMesh filled = Fill(Turned(mesh, way));
    EXPECT_THAT(KindsOf(filled.plan), UnorderedElementsAre(Pair(SingleType::kAnnular, 1), Pair(SingleType::kSimple, 2),
                                                           Pair(SingleType::kIsland, 1)));
    EXPECT_THAT(filled.failures, IsEmpty());
    EXPECT_EQ(ExpectSound(filled), 0);
  }
}

TEST(StandInsTest, Backpack) {
  // Five squares in a row, each touching the next, and a hole with an island that touches its rim at one corner.
  const auto keep = [](int32_t i, int32_t j) {
    const bool in_row = i >= 5 && i < 10 && i - j == 2, in_hole = i >= 16 && i < 25 && j >= 10 && j < 19;
    return !in_row && !in_hole;
  };
  TriMesh mesh = SquaresMesh(0, 30, 0, 24, keep);
  AddMesh(Moved(SquaresMesh(0, 3, 0, 3, [](int32_t, int32_t) { return true; }),
                [](const Point3& p) { return Point3(16 + p.x() + p.y(), 14 + p.y() - p.x(), 0); }),
          mesh);
  mesh = Moved(Welded(mesh),
               [](const Point3& p) { return Point3(20 * std::sin(p.x() / 20), p.y(), 20 * std::cos(p.x() / 20)); });
  const FilledMesh filled = Fill(mesh);
  EXPECT_EQ(filled.plan.continuous, 2);
  EXPECT_EQ(filled.plan.holes.size(), 6u);
  for (const PlannedHole& hole : filled.plan.holes) EXPECT_TRUE(hole.continuous);
  EXPECT_THAT(filled.failures, IsEmpty());
  ExpectSound(filled);
}

}  // namespace
}  // namespace tilemend
