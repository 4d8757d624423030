#include "worker/fill/space/minimum_weight.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace tilemend {
namespace {

using ::testing::Contains;
using ::testing::IsEmpty;
using ::testing::SizeIs;

using Loop = std::vector<Point3>;

bool AllAllowed(int32_t, int32_t) { return true; }

std::vector<Triangle> Triangulate(const Loop& loop, const std::function<bool(int32_t, int32_t)>& allowed = AllAllowed) {
  return TriangulateLoop(loop, std::vector<Eigen::Vector3d>(loop.size(), Eigen::Vector3d::Zero()), allowed);
}

std::set<std::pair<int32_t, int32_t>> ChordsOf(const Loop& loop, const std::vector<Triangle>& triangles) {
  const auto n = static_cast<int32_t>(loop.size());
  std::set<std::pair<int32_t, int32_t>> chords;
  for (const Triangle& t : triangles) {
    for (int k = 0; k < 3; ++k) {
      const auto [a, b] = std::minmax(t[k], t[(k + 1) % 3]);
      if (b - a != 1 && b - a != n - 1) chords.emplace(a, b);
    }
  }
  return chords;
}

// Every edge of the loop once in its direction, n - 2 triangles.
void ExpectClosesLoop(const Loop& loop, const std::vector<Triangle>& triangles) {
  const auto n = static_cast<int32_t>(loop.size());
  ASSERT_THAT(triangles, SizeIs(loop.size() - 2));
  std::multiset<std::pair<int32_t, int32_t>> edges;
  for (const Triangle& t : triangles) {
    for (int k = 0; k < 3; ++k) edges.emplace(t[k], t[(k + 1) % 3]);
  }
  for (int32_t i = 0; i < n; ++i) EXPECT_EQ(edges.count({i, (i + 1) % n}), 1u) << "edge " << i;
}

const Loop kSquare = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

TEST(TriangulateLoopTest, ClosesASquareWithTwoTrianglesTurnedLikeIt) {
  const auto triangles = Triangulate(kSquare);
  ExpectClosesLoop(kSquare, triangles);
  for (const Triangle& t : triangles) {
    EXPECT_GT((kSquare[t[1]] - kSquare[t[0]]).cross(kSquare[t[2]] - kSquare[t[0]]).z(), 0);
  }
}

TEST(TriangulateLoopTest, ReturnsATriangleAsItIs) {
  EXPECT_THAT(Triangulate({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), SizeIs(1));
}

TEST(TriangulateLoopTest, ReturnsNothingForTwoPoints) { EXPECT_THAT(Triangulate({{0, 0, 0}, {1, 0, 0}}), IsEmpty()); }

TEST(TriangulateLoopTest, ReturnsNothingForALoopOnALine) {
  EXPECT_THAT(Triangulate({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}), IsEmpty());
}

TEST(TriangulateLoopTest, TakesTheOtherDiagonalWhenOneIsRefused) {
  for (const auto& refused : {std::pair(0, 2), std::pair(1, 3)}) {
    const auto triangles = Triangulate(
        kSquare, [&](int32_t a, int32_t b) { return std::pair(std::min(a, b), std::max(a, b)) != refused; });
    ExpectClosesLoop(kSquare, triangles);
    EXPECT_FALSE(ChordsOf(kSquare, triangles).contains(refused));
  }
}

TEST(TriangulateLoopTest, ReturnsNothingWhenEveryChordIsRefused) {
  EXPECT_THAT(Triangulate(kSquare, [](int32_t, int32_t) { return false; }), IsEmpty());
}

// The gap between the two slopes of a roof of breadth 4; edges 1-2 and 2-3 are one gable end, 4-5 and 5-0 the other.
Loop Roof(double height) { return {{0, 0, 0}, {6, 0, 0}, {6, 2, height}, {6, 4, 0}, {0, 4, 0}, {0, 2, height}}; }

// At the height of 1.9 the ridge takes more area than gable walls on a floor would: the angles must count first.
TEST(TriangulateLoopTest, KeepsTheRidgeOfARoof) {
  for (const double height : {0.5, 1.0, 1.9}) {
    const Loop loop = Roof(height);
    const Eigen::Vector3d south = Eigen::Vector3d(0, -height, 2).normalized();
    const Eigen::Vector3d north = Eigen::Vector3d(0, height, 2).normalized();
    const std::vector<Eigen::Vector3d> outside = {south, south, north, north, north, south};
    const auto triangles = TriangulateLoop(loop, outside, AllAllowed);
    ExpectClosesLoop(loop, triangles);
    EXPECT_TRUE(ChordsOf(loop, triangles).contains({2, 5})) << "height " << height;
  }
}

TEST(TriangulateLoopTest, KeepsTheValleyOfAFoldToo) {
  Loop loop = Roof(-1);
  const Eigen::Vector3d south = Eigen::Vector3d(0, 1, 2).normalized(), north = Eigen::Vector3d(0, -1, 2).normalized();
  const auto triangles = TriangulateLoop(loop, std::vector{south, south, north, north, north, south}, AllAllowed);
  EXPECT_TRUE(ChordsOf(loop, triangles).contains({2, 5}));
}

TEST(TriangulateLoopTest, TakesTheLeastAreaWhereNothingElseDecides) {
  // A square whose two corners are raised: the diagonal between them gives more area than the one below.
  const Loop loop = {{0, 0, 0}, {1, 0, 0.01}, {1, 1, 0}, {0, 1, -0.02}};
  const auto area = [&](int32_t a, int32_t b, int32_t c) {
    return (loop[b] - loop[a]).cross(loop[c] - loop[a]).norm();
  };
  const double even = area(0, 1, 2) + area(0, 2, 3), odd = area(0, 1, 3) + area(1, 2, 3);
  const std::pair<int32_t, int32_t> expected = even < odd ? std::pair(0, 2) : std::pair(1, 3);
  EXPECT_TRUE(ChordsOf(loop, Triangulate(loop)).contains(expected));
}

TEST(TriangulateLoopTest, ClosesALongLoopInSpace) {
  Loop loop;
  for (int i = 0; i < 60; ++i) {
    const double angle = 2 * std::numbers::pi * i / 60;
    loop.emplace_back(10 * std::cos(angle), 10 * std::sin(angle), 3 * std::sin(2 * angle));
  }
  ExpectClosesLoop(loop, Triangulate(loop));
}

TEST(TriangulateLoopTest, GivesTheSameAreaWhereverTheLoopStarts) {
  Loop loop;
  for (int i = 0; i < 20; ++i) {
    const double angle = 2 * std::numbers::pi * i / 20, r = 4 + i % 3;
    loop.emplace_back(r * std::cos(angle), r * std::sin(angle), std::sin(2 * angle));
  }
  const auto area = [](const Loop& l) {
    double sum = 0;
    for (const Triangle& t : Triangulate(l)) sum += (l[t[1]] - l[t[0]]).cross(l[t[2]] - l[t[0]]).norm() / 2;
    return sum;
  };
  const double expected = area(loop);
  std::rotate(loop.begin(), loop.begin() + 7, loop.end());
  EXPECT_NEAR(area(loop), expected, 0.05 * expected);
}

// Triangle 0, 2, 4 fits. What it leaves can be closed with two misfits alone, another one would need but itself.
TEST(LoopTriangulationTest, TakesAMisfitOnlyWhereNoneFits) {
  const Loop loop = {{0, 0, 0}, {2, -1, 0}, {4, 0, 0}, {3, 3, 0}, {1, 3, 0}};
  const std::vector<Eigen::Vector3d> outside(loop.size(), Eigen::Vector3d::Zero());
  const std::function<bool(int32_t, int32_t)> allowed = AllAllowed;
  const std::function<bool(int32_t, int32_t, int32_t)> fits = [](int32_t i, int32_t j, int32_t k) {
    return i == 0 && k == 4 ? j == 2 : k - i > 2 || i == 1;
  };
  const auto triangles = LoopTriangulation(loop, outside, allowed, fits, Misfits::kFew).Run();
  ExpectClosesLoop(loop, triangles);
  EXPECT_THAT(triangles, Contains(Triangle{0, 2, 4}));
  EXPECT_THAT(LoopTriangulation(loop, outside, allowed, fits).Run(), IsEmpty());
}

TEST(LoopTriangulationTest, IsAfterEachForbiddenTriangleWhatItWouldBeFromTheStart) {
  for (uint32_t seed = 0; seed < 20; ++seed) {
    std::mt19937 random(seed);
    const auto off = [&] { return static_cast<double>(random()) / 0x1p32; };
    Loop loop;
    for (int i = 0; i < 24; ++i) {
      const double turn = 2 * std::numbers::pi * i / 24, x = off(), y = off();
      loop.emplace_back(3 * std::cos(turn) + x, 3 * std::sin(turn) + y, 2 * off());
    }
    const std::vector<Eigen::Vector3d> outside(loop.size(), Eigen::Vector3d(0.6, 0, 0.8));
    const std::function<bool(int32_t, int32_t)> allowed = AllAllowed;
    std::set<Triangle> forbidden;
    const std::function<bool(int32_t, int32_t, int32_t)> fits = [&](int32_t i, int32_t j, int32_t k) {
      return !forbidden.contains({i, j, k});
    };
    LoopTriangulation triangulation(loop, outside, allowed, fits);
    for (int round = 0; round < 12; ++round) {
      const std::vector<Triangle> triangles = triangulation.Run();
      ASSERT_EQ(triangles, TriangulateLoop(loop, outside, allowed, fits)) << seed << ", " << round;
      const Triangle& next = triangles[random() % triangles.size()];
      forbidden.insert(next);
      triangulation.Forbid(next);
    }
  }
}

}  // namespace
}  // namespace tilemend
