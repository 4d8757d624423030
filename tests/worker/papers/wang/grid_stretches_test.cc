#include "worker/papers/wang/grid_stretches.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace tilemend {
namespace {

using testing::ElementsAre;
using testing::SizeIs;

constexpr uint8_t kOriginal = 0, kVertical = 1, kHorizontal = 2, kCorner = 3;

struct Corner {
  double x, y;
  uint8_t lines;
};

// A hole in the north-eastern corner of a tile that ends at x = 10 and y = 10, counterclockwise. The neighbours'
// outlines are at x = 9 and y = 9.
class GridStretchesTest : public testing::Test {
 protected:
  GridStretchesTest() {
    const std::vector<Corner> corners = {{10, 2, kOriginal}, {10, 4, kVertical},   {10, 6, kVertical},
                                         {10, 10, kCorner},  {6, 10, kHorizontal}, {4, 10, kHorizontal},
                                         {2, 10, kOriginal}, {2, 9.5, kOriginal},  {2, 8, kOriginal},
                                         {3, 3, kOriginal},  {8, 2, kOriginal}};
    CellHole hole{0, true};
    for (const Corner& c : corners) AddVertex(c);
    const int32_t count = Count();
    for (int32_t k = 0; k < count; ++k) hole.segments.push_back({k, (k + 1) % count, k < 6});
    const auto add_edge = [&](const Corner& a, const Corner& b) {
      AddVertex(a);
      AddVertex(b);
      hole.inner_edges.push_back({Count() - 2, Count() - 1, true});
    };
    add_edge({9, 4, kVertical}, {9, 6, kVertical});
    add_edge({6, 9, kHorizontal}, {4, 9, kHorizontal});
    hole.inner_edges.push_back({11, 2, true});  // a diagonal
    work_.holes.push_back(hole);
    for (const RimVertex& v : work_.vertices) work_.band.points.push_back(v.position);
    band_.emplace(work_);
    hole_.emplace(MakeLocalHole(work_, *band_, work_.holes[0]));
  }

  void AddVertex(const Corner& c) {
    RimVertex v;
    v.position = Point3(c.x, c.y, 0);
    v.lines = c.lines;
    v.index = c.lines == kOriginal ? Count() : -1;
    work_.vertices.push_back(v);
  }
  int32_t Count() const { return static_cast<int32_t>(work_.vertices.size()); }

  CellHoles work_;
  std::optional<CellBand> band_;
  std::optional<LocalHole> hole_;
};

TEST_F(GridStretchesTest, RunFromTheBoundaryOrACornerToTheNext) {
  const std::vector<GridStretch> stretches = StretchesAround(*hole_);
  ASSERT_THAT(stretches, SizeIs(2));
  EXPECT_THAT(stretches[0].vertices, ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(stretches[0].before, ElementsAre(10, 9, 8, 7, 6));
  EXPECT_EQ(stretches[0].axis, 0);
  EXPECT_EQ(stretches[0].line, 10);
  EXPECT_EQ(stretches[0].way, 1);
  EXPECT_EQ(stretches[0].OffLine({8, 3}), 2);
  EXPECT_THAT(stretches[1].vertices, ElementsAre(3, 4, 5, 6));
  EXPECT_THAT(stretches[1].after, ElementsAre(7, 8, 9, 10, 0));
  EXPECT_EQ(stretches[1].axis, 1);
  EXPECT_EQ(stretches[1].way, -1);
  EXPECT_EQ(stretches[1].OffLine({8, 3}), 7);
}

TEST_F(GridStretchesTest, MoveToTheNeighboursOutline) {
  std::vector<GridStretch> stretches = StretchesAround(*hole_);
  MoveToNeighbours(*hole_, stretches);
  EXPECT_THAT(stretches[0].vertices, ElementsAre(0, 11, 12, 3));
  EXPECT_EQ(stretches[0].line, 9);
  EXPECT_EQ(stretches[0].before.front(), 10) << "the first beyond the line";
  EXPECT_THAT(stretches[1].vertices, ElementsAre(3, 13, 14, 6));
  EXPECT_EQ(stretches[1].after.front(), 8) << "the first beyond the line";
}

TEST_F(GridStretchesTest, StayWhereNoNeighbourIs) {
  hole_->inner_edges.clear();
  std::vector<GridStretch> stretches = StretchesAround(*hole_);
  MoveToNeighbours(*hole_, stretches);
  EXPECT_EQ(stretches[0].line, 10);
  EXPECT_THAT(StripsBeside(*hole_), testing::Each(0));
}

TEST_F(GridStretchesTest, VerticesOfBothOutlinesBoundAStrip) {
  const std::vector<uint8_t> strips = StripsBeside(*hole_);
  const uint8_t east = strips[1], north = strips[5];
  EXPECT_NE(east, 0);
  EXPECT_NE(north, 0);
  EXPECT_EQ(east & north, 0);
  EXPECT_THAT(strips,
              ElementsAre(east, east, east, east | north, north, north, north, 0, 0, 0, 0, east, east, north, north));
}

}  // namespace
}  // namespace tilemend
