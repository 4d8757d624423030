#include "worker/fill/bessel_k0.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tilemend {
namespace {

TEST(BesselK0Test, HasTheTabulatedValues) {
  EXPECT_NEAR(BesselK0(0.1), 2.4270690247020166, 1e-14);
  EXPECT_NEAR(BesselK0(1), 0.42102443824070833, 1e-15);
  EXPECT_NEAR(BesselK0(5), 0.0036910983340425943, 1e-17);
}

TEST(BesselK0Test, AgreesWithTheStandardLibrary) {
  for (double x = 1e-9; x < 40; x *= 1.05) {
    const double expected = std::cyl_bessel_k(0.0, x);
    EXPECT_NEAR(BesselK0(x), expected, 2e-14 * expected) << x;
  }
}

TEST(BesselK0Test, IsSmoothWhereTheSeriesMeet) {
  const double below = BesselK0(2), above = BesselK0(std::nextafter(2.0, 3.0));
  EXPECT_NEAR(below, above, 1e-15);
}

}  // namespace
}  // namespace tilemend
