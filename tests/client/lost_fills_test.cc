#include "client/lost_fills.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "client/left_holes.h"

namespace tilemend {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

const Grid kGrid{{0, 0}, {40, 40}};
const std::vector<Point2> kSquare = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}};

NewOpenEdge EdgeOf(const Point3& a, const Point3& b, int32_t after) { return {{a, b, 1, after}, 0}; }

// The edges around kSquare at this height, all but `closed` of them open.
void AddSquare(double height, size_t closed, LostFills& fills) {
  for (size_t k = 1; k < kSquare.size(); ++k) {
    const Point3 a(kSquare[k - 1].x(), kSquare[k - 1].y(), height), b(kSquare[k].x(), kSquare[k].y(), height);
    fills.Add(EdgeOf(a, b, k <= closed ? 2 : 1));
  }
}

TEST(LostFillsTest, ABoundaryThatIsOpenAgainLostItsFill) {
  LostFills fills({kSquare});
  AddSquare(1, 0, fills);
  EXPECT_THAT(fills.Lost(), SizeIs(4));
}

TEST(LostFillsTest, ABoundaryThatIsClosedDidNot) {
  LostFills fills({kSquare});
  AddSquare(1, 4, fills);
  EXPECT_THAT(fills.Lost(), IsEmpty());
  LostFills half({kSquare});
  AddSquare(1, 2, half);
  EXPECT_THAT(half.Lost(), IsEmpty());
}

// As where a polygon cleared surface up to the outline of a piece: the other edges were not open in the input.
TEST(LostFillsTest, AFewOpenEdgesOfABoundaryAreNoLoss) {
  LostFills fills({kSquare});
  fills.Add(EdgeOf({0, 0, 1}, {4, 0, 1}, 1));
  EXPECT_THAT(fills.Lost(), IsEmpty());
}

TEST(LostFillsTest, OpenSurfacesAboveAFillAreNoLoss) {
  LostFills fills({kSquare});
  AddSquare(1, 4, fills);
  AddSquare(5, 0, fills);
  AddSquare(9, 0, fills);
  EXPECT_THAT(fills.Lost(), IsEmpty());
}

TEST(LostFillsTest, BoundariesAreRoundedToMillimetres) {
  const LostFills fills({kSquare});
  EXPECT_TRUE(fills.IsAtRim({4.0004, 0.0005, 3}, {-0.0004, 0, 7}));
  EXPECT_FALSE(fills.IsAtRim({4.001, 0, 3}, {0, 0, 7}));
  EXPECT_FALSE(fills.IsAtRim({0, 0, 3}, {2, 0, 7})) << "a part of an edge";
  EXPECT_FALSE(LostFills({}).IsAtRim({0, 0, 3}, {2, 0, 7}));
}

ReportedOutput::Left LeftIn(CellId cell, bool reaches_border) {
  ReportedOutput::Left left;
  left.cell = cell;
  left.reaches_border = reaches_border;
  left.rim = {kSquare};
  for (const Point2& p : kSquare) left.box.extend(p);
  return left;
}

TEST(LeftHolesTest, EdgesNearABoundaryMayBeOpen) {
  const std::vector<ReportedOutput::Left> left = {LeftIn({0, 0}, false)};
  const LeftHoles holes(kGrid, left);
  EXPECT_TRUE(holes.AreAt({4.9, 2}, {}));
  EXPECT_FALSE(holes.AreAt({5.1, 2}, {}));
  EXPECT_FALSE(holes.AreAt({2, 2}, {})) << "inside, off the boundary";
}

TEST(LeftHolesTest, WithoutABoundaryThoseAroundTheMiddle) {
  std::vector<ReportedOutput::Left> left(1);
  left[0].at = {10, 10, 0};
  left[0].reach = 2;
  const LeftHoles holes(kGrid, left);
  EXPECT_TRUE(holes.AreAt({12.9, 10}, {}));
  EXPECT_FALSE(holes.AreAt({13.1, 10}, {}));
}

TEST(LeftHolesTest, BesideItsCellWhereItGoesOn) {
  const std::vector<ReportedOutput::Left> left = {LeftIn({1, 0}, true)};
  const LeftHoles holes(kGrid, left);
  const std::vector<CellId> beside = {{1, 0}}, others = {{0, 1}};
  EXPECT_TRUE(holes.AreAt({2, 2}, beside));
  EXPECT_FALSE(holes.AreAt({2, 2}, others));
  const std::vector<ReportedOutput::Left> closed = {LeftIn({1, 0}, false)};
  EXPECT_FALSE(LeftHoles(kGrid, closed).AreAt({2, 2}, beside));
}

// The hole has the lower part of its cell: its boundary is a straight line from the right side to the left one.
TEST(LeftHolesTest, AlongTheSidesThatAStraightBoundaryCutsOff) {
  ReportedOutput::Left hole;
  hole.cell = {1, 0};
  hole.reaches_border = true;
  hole.rim = {{{80, 15}, {60, 15}}, {{60, 15}, {40, 15}}};
  hole.box = Eigen::AlignedBox2d(Point2(40, 15), Point2(80, 15));
  const std::vector<ReportedOutput::Left> left = {hole};
  const LeftHoles holes(kGrid, left);
  const std::vector<CellId> beside = {{1, 0}};
  EXPECT_TRUE(holes.AreAt({40, 3}, beside));
  EXPECT_TRUE(holes.AreAt({80, 3}, beside));
  EXPECT_TRUE(holes.AreAt({60, 0}, beside));
  EXPECT_FALSE(holes.AreAt({40, 30}, beside)) << "there is surface";
  EXPECT_FALSE(holes.AreAt({60, 40}, beside));
  EXPECT_TRUE(holes.AreAt({39.9, 3}, {})) << "a seam over vertices beside the line";
  EXPECT_FALSE(holes.AreAt({38.9, 3}, {}));
}

// Two lines cut off two corners of the cell, each with a hole in it.
TEST(LeftHolesTest, AlongTheSidesUpToWhereTheNextLineBegins) {
  ReportedOutput::Left hole;
  hole.cell = {0, 0};
  hole.reaches_border = true;
  hole.rim = {{{10, 0}, {0, 10}}, {{30, 40}, {40, 30}}};
  hole.box.extend(Point2(20, 20));  // what it adds is tested above
  const std::vector<ReportedOutput::Left> left = {hole};
  const LeftHoles holes(kGrid, left);
  const std::vector<CellId> beside = {{0, 0}};
  EXPECT_TRUE(holes.AreAt({0, 3}, beside));
  EXPECT_TRUE(holes.AreAt({5, 0}, beside));
  EXPECT_TRUE(holes.AreAt({40, 36}, beside));
  EXPECT_FALSE(holes.AreAt({20, 0}, beside));
  EXPECT_FALSE(holes.AreAt({40, 20}, beside));
}

}  // namespace
}  // namespace tilemend
