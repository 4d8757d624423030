#include "common/mesh/rounding.h"

#include <gtest/gtest.h>

namespace tilemend {
namespace {

TEST(RoundedToLatticeTest, IsTheNearestMultiple) {
  EXPECT_EQ(RoundedToLattice(0.3, 0.25), 0.25);
  EXPECT_EQ(RoundedToLattice(-0.4, 0.25), -0.5);
  EXPECT_EQ(RoundedToLattice(Point2(0.3, -7.9), 0.5), Point2(0.5, -8));
  EXPECT_EQ(RoundedToLattice(Point3(1.1, 1.9, -0.2), 1), Point3(1, 2, 0));
}

TEST(RoundedToLatticeTest, OfTwoIsTheOneFurtherFromZero) {
  EXPECT_EQ(RoundedToLattice(0.125, 0.25), 0.25);
  EXPECT_EQ(RoundedToLattice(-0.125, 0.25), -0.25);
}

TEST(RoundedToLatticeTest, LeavesWhatIsThereAlready) {
  for (double x = -1e6; x < 1e6; x += 12345.678) {
    const double once = RoundedToLattice(x, 0x1p-10);
    EXPECT_NEAR(once, x, 0x1p-11);
    EXPECT_EQ(RoundedToLattice(once, 0x1p-10), once);
  }
}

// g++ 12 leaves out neighbouring conversions to float and back.
TEST(RoundedToTest, RoundsEveryCoordinate) {
  EXPECT_EQ(RoundedTo(NumberType::kFloat32, Point3(0.1, 0.1, 0.1)), Point3(0.1f, 0.1f, 0.1f));
  EXPECT_EQ(RoundedTo(NumberType::kFloat32, Point2(0.1, 0.3)), Point2(0.1f, 0.3f));
  EXPECT_EQ(RoundedTo(NumberType::kFloat64, Point3(0.1, 0.2, 0.3)), Point3(0.1, 0.2, 0.3));
  EXPECT_EQ(RoundedTo(NumberType::kFloat64, Point2(0.1, 0.2)), Point2(0.1, 0.2));
}

}  // namespace
}  // namespace tilemend
