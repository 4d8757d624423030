#include "worker/fill/seam/smooth_seam.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

namespace tilemend {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr double kStep = 0x1p-10;

// A seam of three vertices along x = 0, two metres apart, and on each side a patch with points at some distances.
struct Side {
  std::vector<RimVertex> vertices;
  std::vector<HolePatch> patches;
  std::vector<int32_t> holes = {0};

  SeamSide View() const { return {vertices, patches, holes}; }
};

Side MakeSide(double sign, const std::vector<double>& distances, double height, double seam_height) {
  Side side;
  for (int32_t k = 0; k < 3; ++k) {
    RimVertex v;
    v.seam_vertex = 10 + k;
    v.position = Point3(0, 2 * k, seam_height);
    v.size = 2;
    side.vertices.push_back(v);
  }
  HolePatch patch;
  for (const double d : distances) patch.new_points.emplace_back(sign * d, 2, height);
  for (int32_t k = 0; k + 1 < 3; ++k) patch.triangles.push_back({k, k + 1, -1});
  side.patches.push_back(patch);
  return side;
}

const std::vector<int32_t> kSeam = {10, 11, 12};

SmoothedPatches Smooth(const Side& a, const Side& b, double gamma, double buffer = 2) {
  const std::vector<double> heights = {5, 5, 5};
  return SmoothSeam(a.View(), b.View(), {kSeam, heights}, {gamma, buffer, kStep});
}

TEST(SmoothSeamTest, MovesPointsByEquations5And6) {
  const Side a = MakeSide(-1, {1}, 4, 4), b = MakeSide(1, {1}, 8, 8);
  const SmoothedPatches smoothed = Smooth(a, b, 0.5);
  // The point of a: three vertices of the seam with 5, and the point of b with 8.
  ASSERT_THAT(smoothed.a, SizeIs(1));
  EXPECT_EQ(smoothed.a[0].point, 0);
  EXPECT_DOUBLE_EQ(smoothed.a[0].height, 4 + 0.5 * (1 + 1 + 1 + 4) / 4);
  ASSERT_THAT(smoothed.b, SizeIs(1));
  EXPECT_NEAR(smoothed.b[0].height, 8 + 0.5 * (-3 - 3 - 3 - 4) / 4, kStep);
  // The middle of the seam: two vertices with 5, and 4, and 8.
  ASSERT_THAT(smoothed.heights, SizeIs(3));
  EXPECT_NEAR(smoothed.heights[1], 5 + 0.5 * (-1 + 3) / 4, kStep);
}

TEST(SmoothSeamTest, TakesAllHeightsBeforeItChangesAny) {
  const Side a = MakeSide(-1, {1, 2}, 4, 4), b = MakeSide(1, {1}, 8, 8);
  const SmoothedPatches there = Smooth(a, b, 0.5), back = Smooth(b, a, 0.5);
  EXPECT_EQ(there.heights, back.heights);
  ASSERT_EQ(there.a.size(), back.b.size());
  for (size_t i = 0; i < there.a.size(); ++i) EXPECT_DOUBLE_EQ(there.a[i].height, back.b[i].height);
}

TEST(SmoothSeamTest, ReachesAsFarAsTheBuffer) {
  const Side a = MakeSide(-1, {1, 3.9, 4.1}, 4, 4), b = MakeSide(1, {1}, 8, 8);
  EXPECT_THAT(Smooth(a, b, 0.5).a, SizeIs(2)) << "two edges of two metres";
  EXPECT_THAT(Smooth(a, b, 0.5, 1).a, SizeIs(1));
}

TEST(SmoothSeamTest, LeavesOtherHolesAlone) {
  Side a = MakeSide(-1, {1}, 4, 4);
  const Side b = MakeSide(1, {1}, 8, 8);
  a.patches.insert(a.patches.begin(), a.patches[0]);
  a.patches[0].hole = 7;
  const SmoothedPatches smoothed = Smooth(a, b, 0.5);
  ASSERT_THAT(smoothed.a, SizeIs(1));
  EXPECT_EQ(smoothed.a[0].point, 1) << "points are numbered through all patches";
}

// Where tiles overlap, each has a vertex of its own beside that of the grid line.
TEST(SmoothSeamTest, VerticesThatFollowOneAreOne) {
  Side a = MakeSide(-1, {1}, 4, 4), b = MakeSide(1, {1}, 8, 8);
  const SmoothedPatches apart = Smooth(a, b, 0.5);
  for (RimVertex& v : b.vertices) {
    v.follows = v.seam_vertex;
    v.seam_vertex += 100;
    v.position.x() = 0.1;
  }
  const SmoothedPatches following = Smooth(a, b, 0.5);
  EXPECT_EQ(following.heights, apart.heights);
}

// An original vertex at which the seam ends bounds both patches.
TEST(SmoothSeamTest, TakesARimVertexOfBothPatchesOnce) {
  Side a = MakeSide(-1, {1}, 4, 4), b = MakeSide(1, {1}, 8, 8);
  for (Side* const side : {&a, &b}) {
    RimVertex end;
    end.index = side == &a ? 3 : 4;
    end.position = Point3(0, 3, 6);
    side->vertices.push_back(end);
    side->patches[0].triangles.push_back({3, 2, -1});
  }
  const SmoothedPatches smoothed = Smooth(a, b, 0.5);
  ASSERT_THAT(smoothed.a, SizeIs(1));
  EXPECT_NEAR(smoothed.a[0].height, 4 + 0.5 * (1 + 1 + 1 + 4 + 2) / 5, kStep);
}

TEST(SmoothSeamTest, ChangesNothingWithoutPatches) {
  const Side none;
  const std::vector<double> heights = {1, 2, 3};
  const SmoothedPatches smoothed = SmoothSeam(none.View(), none.View(), {kSeam, heights}, {0.5, 3, kStep});
  EXPECT_EQ(smoothed.heights, heights);
  EXPECT_THAT(smoothed.a, IsEmpty());
}

}  // namespace
}  // namespace tilemend
