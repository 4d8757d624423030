#include "coordinator/plan/rim.h"

#include <gtest/gtest.h>

#include <vector>

namespace tilemend {
namespace {

Rim RimOfSizes(const std::vector<double>& sizes) {
  Rim rim;
  for (const double size : sizes) {
    rim.points.emplace_back();
    rim.points.back().size = size;
  }
  return rim;
}

TEST(RaiseSmallSizesTest, RaisesWhatTheLatticeCannotFollow) {
  Rim rim = RimOfSizes({1, 1, 1e-4, 0.1});
  RaiseSmallSizes(0x1p-10, rim);
  EXPECT_EQ(rim.points[0].size, 1);
  EXPECT_EQ(rim.points[2].size, 0x1p-4);
  EXPECT_EQ(rim.points[3].size, 0.1);
}

TEST(RaiseSmallSizesTest, KeepsTheSizesOfASurfaceThatIsFineThroughout) {
  Rim rim = RimOfSizes({0.001, 0.002, 0.003});
  RaiseSmallSizes(0x1p-10, rim);
  EXPECT_EQ(rim.points[0].size, 0.001);
  EXPECT_EQ(rim.points[1].size, 0.002);
}

TEST(RaiseSmallSizesTest, DoesNothingWithoutPoints) {
  Rim rim;
  RaiseSmallSizes(0x1p-10, rim);
  EXPECT_TRUE(rim.points.empty());
}

}  // namespace
}  // namespace tilemend
