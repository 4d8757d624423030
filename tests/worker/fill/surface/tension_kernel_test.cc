#include "worker/fill/surface/tension_kernel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tilemend {
namespace {

TEST(TensionKernelTest, SolvesTheEquationOfAPlateUnderTension) {
  const double tension = 3;
  // Laplacian^2 f = t Laplacian f away from 0, by differences of the Laplacian of a function of the distance.
  const auto f = [&](double r) { return TensionKernel(Eigen::ArrayXd::Constant(1, r), tension)[0]; };
  const auto laplacian = [](const auto& g, double r) {
    constexpr double kStep = 1e-2;
    return (g(r + kStep) - 2 * g(r) + g(r - kStep)) / (kStep * kStep) + (g(r + kStep) - g(r - kStep)) / (2 * kStep * r);
  };
  const auto once = [&](double r) { return laplacian(f, r); };
  for (const double r : {0.4, 1.0, 2.5}) EXPECT_NEAR(laplacian(once, r), tension * once(r), 2e-3);
}

TEST(TensionKernelTest, HasItsLimitAtZero) {
  for (const double tension : {0.0, 3.0, 500.0}) {
    EXPECT_NEAR(TensionKernel(Eigen::ArrayXd::Constant(1, 1e-7), tension)[0], TensionKernelAtZero(tension), 1e-12);
  }
}

TEST(TensionKernelTest, OfTheTableIsTheSame) {
  for (const double tension : {0.0, 1e-3, 3.0, 500.0, 1e4}) {
    const TensionKernelTable table(tension);
    const double scale = tension > 0 ? 1 / tension : 1;
    EXPECT_NEAR(table.At(0), TensionKernelAtZero(tension), 1e-10 * scale);
    for (double x = 1e-8; x < 100; x *= 1.01) {
      const double distance = x / std::sqrt(tension > 0 ? tension : 1);
      const double exact = TensionKernel(Eigen::ArrayXd::Constant(1, distance), tension)[0];
      EXPECT_NEAR(table.At(distance), exact, 1e-10 * std::max(scale, std::abs(exact))) << tension << " " << x;
    }
  }
}

}  // namespace
}  // namespace tilemend
