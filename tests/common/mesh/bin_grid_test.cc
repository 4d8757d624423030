#include "common/mesh/bin_grid.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using Box = Eigen::AlignedBox2d;

Box BoxAt(double x, double y, double size) { return {Point2(x, y), Point2(x + size, y + size)}; }

BinGrid GridOf(const std::vector<Box>& boxes, const Box& extent, double step) {
  return {extent, step, static_cast<int32_t>(boxes.size()), [&](int32_t i) { return boxes[i]; }};
}

std::vector<Box> RandomBoxes(std::mt19937& random, size_t count) {
  std::uniform_real_distribution<double> place(0, 100), size(0, 12);
  std::vector<Box> boxes;
  for (size_t i = 0; i < count; ++i) {
    const double x = place(random), y = place(random);
    boxes.push_back(BoxAt(x, y, size(random)));
  }
  return boxes;
}

TEST(BinGridTest, CoversItsExtent) {
  const BinGrid grid = GridOf({}, {Point2(10, 20), Point2(15, 22)}, 2);
  EXPECT_EQ(grid.columns(), 3);
  EXPECT_EQ(grid.rows(), 2);
  EXPECT_EQ(grid.BinOf({10, 20}), 0);
  EXPECT_EQ(grid.BinOf({15, 22}), 5);
  EXPECT_THAT(grid.In({Point2(0, 0), Point2(100, 100)}), IsEmpty());
}

TEST(BinGridTest, OfAPointIsOneBin) {
  const BinGrid grid = GridOf({BoxAt(3, 3, 0)}, {Point2(3, 3), Point2(3, 3)}, 1);
  EXPECT_EQ(grid.columns() * grid.rows(), 1);
  EXPECT_THAT(grid.In(BoxAt(3, 3, 0)), ElementsAre(0));
}

TEST(BinGridTest, WhatLiesOutsideCountsToTheNearestBins) {
  const BinGrid grid = GridOf({BoxAt(-50, -50, 1), BoxAt(200, 5, 1)}, {Point2(0, 0), Point2(10, 10)}, 5);
  EXPECT_EQ(grid.BinOf({-1e300, 1e300}), grid.BinOf({0, 10}));
  EXPECT_THAT(grid.In(BoxAt(-9, -9, 1)), ElementsAre(0));
  EXPECT_THAT(grid.In(BoxAt(10, 5, 1)), ElementsAre(1));
}

TEST(BinGridTest, FindsAllThatMeetABoxEachOnceInOrder) {
  std::mt19937 random(1);
  const std::vector<Box> boxes = RandomBoxes(random, 300);
  for (const double step : {0.7, 5.0, 1000.0}) {
    const BinGrid grid = GridOf(boxes, {Point2(0, 0), Point2(112, 112)}, step);
    for (const Box& wanted : RandomBoxes(random, 100)) {
      const std::vector<int32_t> found = grid.In(wanted);
      EXPECT_TRUE(std::adjacent_find(found.begin(), found.end(), std::greater_equal<>()) == found.end());
      for (int32_t i = 0; i < 300; ++i) {
        EXPECT_TRUE(!boxes[i].intersects(wanted) || std::binary_search(found.begin(), found.end(), i));
      }
    }
  }
}

TEST(BinGridTest, FindsOnlyWhatIsNear) {
  std::mt19937 random(2);
  const std::vector<Box> boxes = RandomBoxes(random, 300);
  const double step = 4;
  const BinGrid grid = GridOf(boxes, {Point2(0, 0), Point2(112, 112)}, step);
  for (const Box& wanted : RandomBoxes(random, 100)) {
    const Box reach(wanted.min() - Point2(step, step), wanted.max() + Point2(step, step));
    for (const int32_t i : grid.In(wanted)) EXPECT_TRUE(boxes[i].intersects(reach));
  }
}

TEST(BinGridTest, MeetsEachThingOnceInTheBinOfTheLowerCornerOfWhatIsCommon) {
  std::mt19937 random(3);
  const std::vector<Box> boxes = RandomBoxes(random, 200);
  const BinGrid grid = GridOf(boxes, {Point2(0, 0), Point2(112, 112)}, 3);
  for (const Box& wanted : RandomBoxes(random, 50)) {
    std::vector<int32_t> once, meeting;
    grid.ForBins(wanted, [&](int64_t bin, std::span<const int32_t> things) {
      for (const int32_t i : things) {
        if (boxes[i].intersects(wanted) && grid.BinOf(boxes[i].intersection(wanted).min()) == bin) once.push_back(i);
      }
    });
    for (int32_t i = 0; i < 200; ++i) {
      if (boxes[i].intersects(wanted)) meeting.push_back(i);
    }
    std::sort(once.begin(), once.end());
    EXPECT_EQ(once, meeting);
  }
}

}  // namespace
}  // namespace tilemend
