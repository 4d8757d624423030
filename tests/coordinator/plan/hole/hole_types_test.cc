#include "coordinator/plan/hole/hole_types.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/hole_scene.h"

namespace tilemend {
namespace {

SingleType TypeOf(const std::vector<Loop3>& loops) {
  const HoleScene scene(loops);
  const auto& closed = scene.boundary.closed_loops;
  return ClassifySingle(closed[0], {closed.begin() + 1, closed.end()}, scene.position);
}

TEST(ClassifySingleTest, FindsASimpleHole) { EXPECT_EQ(TypeOf({HoleLoop(1, 1, 4, 3)}), SingleType::kSimple); }

TEST(ClassifySingleTest, FindsACrackWhereAllEdgesRunOneWay) {
  const Loop3 crack = {{1, 1, 0}, {3, 1.1, 0}, {5, 1, 0}, {3, 0.9, 0}};
  EXPECT_EQ(TypeOf({crack}), SingleType::kCrack);
  Loop3 turned;
  for (const Point3& p : crack) turned.emplace_back(p.z(), p.x(), p.y());
  EXPECT_EQ(TypeOf({turned}), SingleType::kCrack) << "in whatever plane";
}

TEST(ClassifySingleTest, FindsADislocationWhereTheSidesAreAHairApart) {
  // Around a corner, so that it is no crack.
  const Loop3 slit = {{1, 1, 0}, {1, 4, 0}, {4, 4, 0}, {4, 3.9997, 0}, {1.0003, 3.9997, 0}, {1.0003, 1, 0}};
  EXPECT_EQ(TypeOf({slit}), SingleType::kDislocation);
  Loop3 wide = slit;
  for (Point3& p : wide) p *= 10;
  EXPECT_EQ(TypeOf({wide}), SingleType::kSimple);
}

TEST(ClassifySingleTest, FindsADislocationOfManyVertices) {
  Loop3 slit;
  constexpr int kVertices = 50'000;
  const auto at = [](int i, double radius) {
    const double angle = 5.0 * i / kVertices;
    return Point3(100 * radius * std::cos(angle), 100 * radius * std::sin(angle), 0);
  };
  for (int i = 0; i < kVertices; ++i) slit.push_back(at(i, 1));
  for (int i = kVertices; i > 0; --i) slit.push_back(at(i - 1, 1 + 3e-6));
  EXPECT_EQ(TypeOf({slit}), SingleType::kDislocation);
  slit[kVertices / 2].x() += 1;
  EXPECT_EQ(TypeOf({slit}), SingleType::kSimple);
}

TEST(ClassifySingleTest, FindsRingsAndIslands) {
  const Loop3 hole = HoleLoop(1, 1, 9, 9);
  EXPECT_EQ(TypeOf({hole, PieceLoop(2, 2, 8, 8)}), SingleType::kAnnular);
  EXPECT_EQ(TypeOf({hole, PieceLoop(3, 3, 7.3, 7.3)}), SingleType::kIsland) << "a little more than half of it";
  EXPECT_EQ(TypeOf({hole, PieceLoop(4, 4, 5, 5)}), SingleType::kIsland);
  EXPECT_EQ(TypeOf({hole, PieceLoop(2, 2, 4, 4), PieceLoop(6, 6, 8, 8)}), SingleType::kIsland);
}

TEST(ClassifySingleTest, AJaggedIslandMakesNoRingHoweverLongItsOutlineIs) {
  Loop3 star;
  for (int i = 0; i < 32; ++i) {
    const double angle = 2 * std::numbers::pi * i / 32, reach = i % 2 == 0 ? 1.8 : 0.6;
    star.emplace_back(5 + reach * std::cos(angle), 5 + reach * std::sin(angle), 0);
  }
  EXPECT_EQ(TypeOf({HoleLoop(1, 1, 9, 9), star}), SingleType::kIsland);
}

// What a hole takes up of the outline of a cell of 10 m: places in metres along it, counter-clockwise from the
// south-west corner.
HoleType TypeOfStretches(const std::vector<std::pair<double, double>>& stretches) {
  const GridLines lines = LinesOf({{0, 0}}, 10);
  const auto at = [](double place) {
    const int side = static_cast<int>(place / 10) % 4;
    const double t = place - 10 * std::floor(place / 10);
    return side == 0   ? Point3(t, 0, 0)
           : side == 1 ? Point3(10, t, 0)
           : side == 2 ? Point3(10 - t, 10, 0)
                       : Point3(0, 10 - t, 0);
  };
  constexpr Side kAround[4] = {kSouth, kEast, kNorth, kWest};
  std::vector<Point3> position;
  std::vector<BoundarySegment> segments;
  for (const auto& [begin, end] : stretches) {
    for (double t = begin; t < end - 1e-9; t += 1) {  // a metre each
      const auto v = static_cast<int32_t>(position.size());
      if (t == begin) position.push_back(at(t));
      position.push_back(at(t + 1));
      const int32_t from = t == begin ? v : v - 1;
      segments.push_back({{from, from + 1, true}, kAround[static_cast<int>(t / 10) % 4], {9, 9}});
    }
  }
  return ClassifyOpen(segments, {0, 0}, true, lines, position);
}

TEST(ClassifyOpenTest, FindsTypeAWithoutSurface) {
  EXPECT_EQ(ClassifyOpen({}, {0, 0}, false, LinesOf({{0, 0}}, 10), {}), HoleType::kA);
}

TEST(ClassifyOpenTest, FindsTypeBWhereOnePartIsLeft) {
  EXPECT_EQ(TypeOfStretches({{2, 6}}), HoleType::kB);
  EXPECT_EQ(TypeOfStretches({{2, 36}}), HoleType::kB);
}

TEST(ClassifyOpenTest, FindsTypeCWhereEachPartTouchesThreeSides) {
  EXPECT_EQ(TypeOfStretches({{3, 6}, {23, 26}}), HoleType::kC);
  EXPECT_EQ(TypeOfStretches({{13, 16}, {33, 36}}), HoleType::kC);
}

TEST(ClassifyOpenTest, FindsTypeDWhereAPartTouchesOneOrTwo) {
  EXPECT_EQ(TypeOfStretches({{3, 6}, {13, 16}}), HoleType::kD) << "the part at the corner touches two";
  EXPECT_EQ(TypeOfStretches({{1, 3}, {6, 8}}), HoleType::kD) << "the part between touches one";
}

TEST(ClassifyOpenTest, GivesTheSameTypeForAQuarterTurn) {
  for (const double turn : {10, 20, 30}) {
    EXPECT_EQ(TypeOfStretches({{3, 6 + 0}, {23, 26}}), TypeOfStretches({{3 + turn, 6 + turn}, {23 + turn, 26 + turn}}));
    EXPECT_EQ(TypeOfStretches({{3, 6}, {13, 16}}), TypeOfStretches({{3 + turn, 6 + turn}, {13 + turn, 16 + turn}}));
  }
}

}  // namespace
}  // namespace tilemend
