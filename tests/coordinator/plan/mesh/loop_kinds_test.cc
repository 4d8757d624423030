#include "coordinator/plan/mesh/loop_kinds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace tilemend {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

LoopLine Line(const std::vector<Point3>& corners, const Eigen::Vector3d& normal = {0, 0, 1}) {
  return {corners, std::vector<Eigen::Vector3d>(corners.size(), normal)};
}

// A slit of `count` edges along one side, bent by `bend` degrees at each of them, `width` wide in the middle.
LoopLine Slit(int count, double width, double bend) {
  std::vector<Point3> there = {Point3::Zero()}, back;
  double direction = 0;
  for (int i = 0; i < count; ++i, direction += bend * kDegree) {
    there.push_back(there.back() + Point3(std::cos(direction), std::sin(direction), 0));
    if (i + 1 < count) back.push_back(there.back() + width * Point3(-std::sin(direction), std::cos(direction), 0));
  }
  there.insert(there.end(), back.rbegin(), back.rend());
  return Line(there);
}

LoopLine Ring(double radius, const Point3& middle, double sense, int count = 24) {
  LoopLine ring;
  for (int i = 0; i < count; ++i) {
    const double turn = sense * 2 * std::numbers::pi * i / count;
    ring.normals.emplace_back(std::cos(turn), std::sin(turn), 0);
    ring.corners.push_back(middle + radius * ring.normals.back());
  }
  return ring;
}

TEST(IsCrackTest, TakesWhatRunsOneWayThereAndBack) {
  EXPECT_TRUE(IsCrack(Slit(8, 0.05, 0)));
  EXPECT_TRUE(IsCrack(Slit(8, 0.05, 1)));
  EXPECT_FALSE(IsCrack(Slit(8, 1, 0))) << "its ends are blunt";
  EXPECT_FALSE(IsCrack(Slit(30, 0.02, 1))) << "it bends by 30 degrees in all";
}

TEST(IsCrackTest, AddsUpTurnsThatNoPairOfSidesShows) {
  // A helix about a line: every side is within 9 degrees of the line, but the turns about the normals, which wind round
  // with it, come to more.
  LoopLine line;
  const double pitch = 9 * kDegree;
  for (int i = 0; i < 12; ++i) {
    const double turn = 80 * kDegree * i;
    line.corners.emplace_back(i * std::cos(pitch), std::sin(pitch) * std::cos(turn), std::sin(pitch) * std::sin(turn));
    line.normals.emplace_back(0, std::cos(turn), std::sin(turn));
  }
  for (int i = 10; i > 0; --i) {
    line.corners.push_back(line.corners[static_cast<size_t>(i)] + 1e-3 * line.normals[static_cast<size_t>(i)]);
    line.normals.push_back(line.normals[static_cast<size_t>(i)]);
  }
  EXPECT_FALSE(IsCrack(line));
}

TEST(IsDislocationTest, MeasuresTheWidthInEdges) {
  EXPECT_TRUE(IsDislocation(Slit(30, 0.1, 3), {}));
  EXPECT_FALSE(IsDislocation(Slit(30, 0.4, 3), {}));
  EXPECT_FALSE(IsDislocation(Ring(3, Point3::Zero(), 1), {}));
  LoopLine small = Slit(30, 0.1, 3);
  for (Point3& p : small.corners) p *= 1e-6;
  EXPECT_TRUE(IsDislocation(small, {}));
  EXPECT_FALSE(IsDislocation(Slit(30, 0.1, 3), {0.2, 5e-4})) << "in the mesh's units, if that is asked for";
  EXPECT_TRUE(IsDislocation(Slit(30, 4e-4, 3), {0.2, 5e-4}));
}

TEST(FaceEachOtherTest, TakesTheEndsOfATubeThatLacksASegment) {
  // The lower end opens upwards, the upper one downwards.
  const LoopLine lower = Ring(2, {0, 0, 0}, 1);
  EXPECT_TRUE(FaceEachOther(lower, Ring(2, {0, 0, 1.5}, -1), false));
  EXPECT_TRUE(FaceEachOther(lower, Ring(1.5, {0.3, 0, 1.5}, -1), false));
  EXPECT_FALSE(FaceEachOther(lower, Ring(1, {0, 0, 1.5}, -1), false)) << "unlike";
  EXPECT_TRUE(FaceEachOther(lower, Ring(2, {0, 0, 7.5}, -1), false));
  EXPECT_FALSE(FaceEachOther(lower, Ring(2, {0, 0, 9}, -1), false)) << "far away";
  EXPECT_FALSE(FaceEachOther(lower, Ring(2, {1.5, 0, 1}, -1), false)) << "beside it";
  EXPECT_FALSE(FaceEachOther(lower, Ring(2, {0, 0, -1.5}, -1), false)) << "the other end of a short tube";
  EXPECT_FALSE(FaceEachOther(lower, Ring(2, {0, 0, 1.5}, 1), false)) << "opens the same way";
}

TEST(FaceEachOtherTest, TakesNoPieceOfADomeForTheEndOfATube) {
  // Normals as on a sphere about the axis, by their height over the radius.
  const auto domed = [](LoopLine ring, double height) {
    for (Eigen::Vector3d& n : ring.normals) n = Eigen::Vector3d(n.x(), n.y(), height).normalized();
    return ring;
  };
  const LoopLine outer = Ring(2, {0, 0, 0}, 1), inner = Ring(1.3, {0, 0, 0.6}, -1);
  EXPECT_FALSE(FaceEachOther(domed(outer, 1), domed(inner, 2), false));
  EXPECT_TRUE(FaceEachOther(domed(outer, 0.3), domed(inner, 0.5), false)) << "a tube that narrows";
}

TEST(FaceEachOtherTest, TakesRimsThatNearlyCoincideWhateverTheirVertices) {
  const LoopLine lower = Ring(2, {0, 0, 0}, 1, 36);
  for (const double gap : {1e-6, 1e-3, -1e-3, 0.02}) {
    EXPECT_TRUE(FaceEachOther(lower, Ring(2, {0, 0, gap}, -1, 31), false)) << gap;
  }
}

TEST(FaceEachOtherTest, TakesTheRimsOfAThinWall) {
  // Of a bowl: the inner side faces the axis.
  const auto inside = [](LoopLine ring) {
    for (Eigen::Vector3d& n : ring.normals) n = -n;
    return ring;
  };
  const LoopLine outer = Ring(2, {0, 0, 0}, 1);
  EXPECT_TRUE(FaceEachOther(outer, inside(Ring(1.8, {0, 0, 0}, -1)), false));
  EXPECT_TRUE(FaceEachOther(outer, inside(Ring(1.5, {0, 0, 0.1}, -1)), false));
  EXPECT_FALSE(FaceEachOther(outer, inside(Ring(1.8, {0, 0, 0}, -1)), true)) << "a tunnel";
  EXPECT_FALSE(FaceEachOther(outer, inside(Ring(1.3, {0, 0, -1.5}, -1)), false)) << "too thick";
  EXPECT_FALSE(FaceEachOther(Ring(1.8, {0, 0, 0}, -1), inside(outer), false)) << "they face each other";
}

TEST(FaceEachOtherTest, TakesNoTwoEndsOfOneShortTube) {
  // The inside of a ring: its ends open towards each other, along its own surface.
  const auto inside = [](LoopLine ring) {
    for (Eigen::Vector3d& n : ring.normals) n = -n;
    return ring;
  };
  EXPECT_FALSE(FaceEachOther(inside(Ring(2, {0, 0, 0}, 1)), inside(Ring(2, {0, 0, 1}, -1)), false));
}

}  // namespace
}  // namespace tilemend
