#include "worker/fill/space/clip_ears.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace tilemend {
namespace {

using Eigen::Vector3d;

bool AnyChord(int32_t, int32_t) { return true; }

// A round flat loop whose radius waves.
std::vector<Point3> WavyLoop(int count, double wave) {
  std::vector<Point3> loop;
  for (int i = 0; i < count; ++i) {
    const double turn = 2 * std::numbers::pi * i / count, radius = 1 + wave * std::sin(8 * turn);
    loop.emplace_back(radius * std::cos(turn), radius * std::sin(turn), 0);
  }
  return loop;
}

TEST(ClipEarsTest, CutsALoopDownAndKeepsItsArea) {
  for (const double wave : {0.0, 0.3}) {
    const std::vector<Point3> loop = WavyLoop(1000, wave);
    const std::vector<Vector3d> outside(loop.size(), Vector3d::UnitZ());
    CrossingIndex taken({});
    const ClippedLoop clipped = ClipEars(loop, outside, AnyChord, 50, taken);
    ASSERT_EQ(clipped.rest.size(), 50u);
    ASSERT_EQ(clipped.outside.size(), 50u);
    EXPECT_EQ(clipped.triangles.size(), 950u);
    EXPECT_EQ(taken.triangles().size(), 950u);
    const auto area = [&](int32_t a, int32_t b, int32_t c) {
      return (loop[b] - loop[a]).cross(loop[c] - loop[a]).z() / 2;
    };
    double sum = 0, whole = 0;
    for (const Triangle& t : clipped.triangles) {
      EXPECT_GT(area(t[0], t[1], t[2]), 0);
      sum += area(t[0], t[1], t[2]);
    }
    for (size_t i = 1; i + 1 < clipped.rest.size(); ++i)
      sum += area(clipped.rest[0], clipped.rest[i], clipped.rest[i + 1]);
    for (int32_t i = 1; i + 1 < 1000; ++i) whole += area(0, i, i + 1);
    EXPECT_NEAR(sum, whole, 1e-9);
  }
}

// So that the loop gets coarser evenly.
TEST(ClipEarsTest, LeavesPlacesAllAroundTheLoop) {
  const std::vector<Point3> loop = WavyLoop(1024, 0);
  const std::vector<Vector3d> outside(loop.size(), Vector3d::UnitZ());
  CrossingIndex taken({});
  const ClippedLoop clipped = ClipEars(loop, outside, AnyChord, 32, taken);
  for (size_t i = 0; i < clipped.rest.size(); ++i) {
    const Point3 &a = loop[clipped.rest[i]], &b = loop[clipped.rest[(i + 1) % clipped.rest.size()]];
    EXPECT_LT((b - a).norm(), 4 * 2 * std::numbers::pi / 32);
  }
}

TEST(ClipEarsTest, CrossesNothingThatIsTaken) {
  const std::vector<Point3> loop = WavyLoop(64, 0);
  const std::vector<Vector3d> outside(loop.size(), Vector3d::UnitZ());
  const std::vector<SpaceTriangle> needle = {{Point3(0.95, 0.1, -1), Point3(0.95, 0.1, 1), Point3(0.95, 0.11, 1)}};
  const CrossingIndex alone(needle);
  const auto crossed = [&](CrossingIndex taken) {
    const ClippedLoop clipped = ClipEars(loop, outside, AnyChord, 4, taken);
    return std::count_if(clipped.triangles.begin(), clipped.triangles.end(), [&](const Triangle& t) {
      return alone.IsCrossedBy({loop[t[0]], loop[t[1]], loop[t[2]]});
    });
  };
  EXPECT_GT(crossed(CrossingIndex({})), 0);
  EXPECT_EQ(crossed(alone), 0);
}

TEST(ClipEarsTest, MakesNoEdgeThatIsNotAllowed) {
  const std::vector<Point3> loop = WavyLoop(40, 0);
  const std::vector<Vector3d> outside(loop.size(), Vector3d::UnitZ());
  CrossingIndex taken({});
  const auto odd = [](int32_t i, int32_t k) { return i % 2 == 1 && k % 2 == 1; };
  const ClippedLoop clipped = ClipEars(loop, outside, odd, 3, taken);
  EXPECT_FALSE(clipped.triangles.empty());
  for (const Triangle& t : clipped.triangles) EXPECT_TRUE(odd(t[0], t[2]));
}

}  // namespace
}  // namespace tilemend
