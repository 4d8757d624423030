#include "worker/fill/surface/tension_kernel.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unsupported/Eigen/SpecialFunctions>

namespace tilemend {
namespace {

constexpr double kFar = 30;  // K0 is below 1e-13 from here on
constexpr int kSteps = 2048;
const double kStep = std::sqrt(kFar) / kSteps;

}  // namespace

// ln r + K0(x) tends to ln(2 / scale) - Euler's constant.
Eigen::ArrayXd TensionKernel(const Eigen::ArrayXd& distances, double tension) {
  if (tension == 0) return distances.square() * distances.log() / (8 * std::numbers::pi);
  const Eigen::ArrayXd x = (std::sqrt(tension) * distances).min(kFar);
  return (distances.log() + Eigen::bessel_k0(x)) / (-2 * std::numbers::pi * tension);
}

double TensionKernelAtZero(double tension) {
  if (tension == 0) return 0;
  return (std::log(2 / std::sqrt(tension)) - std::numbers::egamma) / (-2 * std::numbers::pi * tension);
}

TensionKernelTable::TensionKernelTable(double tension) : tension_(tension) {
  if (tension == 0) return;
  const Eigen::ArrayXd roots = kStep * Eigen::ArrayXd::LinSpaced(kSteps + 2, 1, kSteps + 2);
  const Eigen::ArrayXd values = TensionKernel(roots.square() / std::sqrt(tension), tension);
  values_ = {values[0], TensionKernelAtZero(tension)};
  values_.insert(values_.end(), values.begin(), values.end());
}

// Cubic through the two values on either side.
double TensionKernelTable::At(double distance) const {
  const double x = std::sqrt(tension_) * distance;
  if (tension_ == 0) return distance > 0 ? distance * distance * std::log(distance) / (8 * std::numbers::pi) : 0;
  if (x >= kFar) return std::log(distance) / (-2 * std::numbers::pi * tension_);
  const double place = std::sqrt(x) / kStep;
  const int below = std::min(static_cast<int>(place), kSteps - 1);
  const double b = place - below, a = 1 - b;
  const double* v = &values_[static_cast<size_t>(below)];
  return a * v[1] + b * v[2] - a * b / 6 * ((1 + a) * (v[0] - 2 * v[1] + v[2]) + (1 + b) * (v[1] - 2 * v[2] + v[3]));
}

}  // namespace tilemend
