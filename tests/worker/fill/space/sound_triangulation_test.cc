#include "worker/fill/space/sound_triangulation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "worker/fill/space/minimum_weight.h"
#include "worker/fill/space/patch_crossings.h"

namespace tilemend {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

const auto kAnyChord = [](int32_t, int32_t) { return true; };

std::vector<SpaceTriangle> InSpace(const std::vector<Point3>& loop, const std::vector<Triangle>& triangles) {
  std::vector<SpaceTriangle> in_space;
  for (const Triangle& t : triangles) in_space.push_back({loop[t[0]], loop[t[1]], loop[t[2]]});
  return in_space;
}

// A square whose corners are up and down in turns: one diagonal runs above, the other below.
const std::vector<Point3> kSaddle = {{-1, -1, 0}, {1, -1, 1}, {1, 1, 0}, {-1, 1, 1}};

SpaceTriangle Blade(double z) {
  return {Point3(-0.1, 0.05, z - 0.2), Point3(0.2, 0.1, z - 0.2), Point3(0, 0, z + 0.2)};
}

TEST(SoundTriangulationTest, TakesTheDiagonalThatTheSurfaceLeavesFree) {
  const std::vector<Eigen::Vector3d> outside(4, Eigen::Vector3d::Zero());
  for (const double z : {0.0, 1.0}) {
    const std::vector<SpaceTriangle> blade = {Blade(z)};
    const std::vector<Triangle> triangles = TriangulateSoundly(kSaddle, outside, kAnyChord, CrossingIndex(blade));
    ASSERT_THAT(triangles, SizeIs(2));
    EXPECT_FALSE(PatchCrosses(InSpace(kSaddle, triangles), blade));
  }
  EXPECT_THAT(TriangulateSoundly(kSaddle, outside, kAnyChord, CrossingIndex(std::vector{Blade(0), Blade(1)})),
              IsEmpty());
}

TEST(SoundTriangulationTest, CrossesLittleWhereItMustIfThatIsWanted) {
  // A strip of three squares; the middle one is crossed whichever diagonal it gets.
  const std::vector<Point3> loop = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0},
                                    {3, 1, 0}, {2, 1, 0}, {1, 1, 0}, {0, 1, 0}};
  const std::vector<Eigen::Vector3d> outside(loop.size(), Eigen::Vector3d::Zero());
  const std::vector<SpaceTriangle> needle = {{Point3(1.4, 0.45, -1), Point3(1.41, 0.45, -1), Point3(1.4, 0.45, 1)}};
  const CrossingIndex taken(needle);
  EXPECT_THAT(TriangulateSoundly(loop, outside, kAnyChord, taken), IsEmpty());
  const std::vector<Triangle> triangles = TriangulateSoundly(loop, outside, kAnyChord, taken, Misfits::kFew);
  ASSERT_THAT(triangles, SizeIs(loop.size() - 2));
  EXPECT_THAT(CrossedTriangles(InSpace(loop, triangles), needle), SizeIs(1));
}

// A loop whose triangulation with the least bend passes through itself, as noisy rims have.
TEST(SoundTriangulationTest, DoesNotPassThroughItself) {
  int crossed = 0;
  for (int seed = 0; seed < 60; ++seed) {
    std::vector<Point3> loop;
    std::vector<Eigen::Vector3d> outside;
    for (int k = 0; k < 18; ++k) {
      const double angle = k * 0.35, wild = std::sin(12.9 * (k + 1) * (seed + 1)),
                   more = std::sin(7.7 * (k + 3) * (seed + 2));
      const double radius = 3 + 1.2 * more;
      loop.emplace_back(radius * std::cos(angle + 0.4 * wild), radius * std::sin(angle + 0.4 * wild), 2 * wild * more);
      outside.emplace_back(Eigen::Vector3d(wild, more, 1.5).normalized());
    }
    crossed += !SelfCrossings(InSpace(loop, TriangulateLoop(loop, outside, kAnyChord))).empty();
    const std::vector<Triangle> triangles = TriangulateSoundly(loop, outside, kAnyChord, CrossingIndex({}));
    EXPECT_THAT(triangles, SizeIs(16)) << seed;
    EXPECT_THAT(SelfCrossings(InSpace(loop, triangles)), IsEmpty()) << seed;
  }
  EXPECT_GT(crossed, 0) << "the loops put nothing to the test";
}

// Up to 400 vertices no triangle is cut off before all triangulations are looked at.
TEST(SoundTriangulationTest, TakesTheBestOfALongLoop) {
  std::vector<Point3> loop;
  std::vector<Eigen::Vector3d> outside;
  for (int k = 0; k < 200; ++k) {
    const double angle = 2 * std::numbers::pi * k / 200;
    loop.emplace_back(9 * std::cos(angle), 6 * std::sin(angle), std::sin(2 * angle));
    outside.emplace_back(0, 0, 1);
  }
  EXPECT_EQ(TriangulateSoundly(loop, outside, kAnyChord, CrossingIndex({})), TriangulateLoop(loop, outside, kAnyChord));
}

}  // namespace
}  // namespace tilemend
