#include "client/fill_area.h"

#include <gtest/gtest.h>

namespace tilemend {
namespace {

const Grid kGrid{{0, 0}, {20, 20}};

// A fill of cell (1, 0), whose hole goes on over the left side of the cell up to x = 15.
class FillAreaTest : public ::testing::Test {
 protected:
  FillAreaTest() {
    mesh_.points = {{10, 0, 3}, {40, 0, 3}, {40, 20, 4}, {10, 20, 4}};
    mesh_.triangles = {{0, 1, 2}, {0, 2, 3}};
  }
  bool IsFault(double holes, bool tiles_overlap) {
    return FillAreaFault(kGrid, {1, 0}, holes, tiles_overlap, mesh_, added_).has_value();
  }

  TriMesh mesh_;
  std::vector<bool> added_ = {true, true};
};

TEST_F(FillAreaTest, AFillIsAsLargeAsItsHoleAlsoBeyondTheCell) {
  EXPECT_FALSE(IsFault(600, false));
  EXPECT_TRUE(IsFault(300, false));
  EXPECT_EQ(FillAreaFault(kGrid, {1, 0}, 300, false, mesh_, added_), "cell 1,0: fills of 600.0 m2, holes of 300.0 m2");
  EXPECT_TRUE(IsFault(900, false));
}

TEST_F(FillAreaTest, WhereTilesOverlapTheCellCounts) {
  // The middle of the second triangle is in the cell to the left.
  mesh_.points[0].x() = mesh_.points[3].x() = 5;
  EXPECT_FALSE(IsFault(350, true));
  EXPECT_TRUE(IsFault(700, true));
}

TEST_F(FillAreaTest, ATileWithoutFillsHasNoHoles) {
  added_ = {false, false};
  EXPECT_FALSE(IsFault(0, false));
  EXPECT_TRUE(IsFault(0.01, false));
}

}  // namespace
}  // namespace tilemend
