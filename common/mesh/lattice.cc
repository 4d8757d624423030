#include "common/mesh/lattice.h"

#include <algorithm>
#include <cmath>

#include "common/mesh/predicates.h"

namespace tilemend {
namespace {

constexpr int kPointExponent = -26;                    // of the window of a single point
constexpr int kMostDigits = 28;                        // of a coordinate
constexpr double kMostSteps = 268435456.0;             // 2^28
constexpr double kExactIntegers = 4503599627370496.0;  // 2^52: a sum of two such multiples of a step is still exact

}  // namespace

int Orientation(LatticePoint a, LatticePoint b, LatticePoint c) {
  const int64_t turn = internal::Turn(internal::Narrow(a), internal::Narrow(b), internal::Narrow(c));
  return (turn > 0) - (turn < 0);
}

int InCircle(LatticePoint a, LatticePoint b, LatticePoint c, LatticePoint d) {
  const __int128 determinant =
      internal::InCircleDeterminant(internal::Narrow(a), internal::Narrow(b), internal::Narrow(c), internal::Narrow(d));
  return (determinant > 0) - (determinant < 0);
}

LatticeWindow::LatticeWindow(const Point2& lo, const Point2& hi) {
  const double margin = (hi - lo).maxCoeff() / 16;
  const double side = (hi - lo).maxCoeff() + 2 * margin;
  const double far = std::max(lo.cwiseAbs().maxCoeff(), hi.cwiseAbs().maxCoeff()) + side;
  int exponent = side > 0 ? std::ilogb(side) - kMostDigits : kPointExponent;
  // Two steps are kept free: rounding the origin down and a point up may each take one.
  while (std::ldexp(kMostSteps - 2, exponent) < side || std::ldexp(kExactIntegers, exponent) < far) ++exponent;
  step_ = std::ldexp(1.0, exponent);
  for (int k = 0; k < 2; ++k) origin_[k] = std::floor((lo[k] - margin) / step_) * step_;
}

LatticePoint LatticeWindow::Round(const Point2& p) const {
  // The subtraction may round in its last bit; that is far below half a step.
  return {std::llround((p.x() - origin_.x()) / step_), std::llround((p.y() - origin_.y()) / step_)};
}

Point2 LatticeWindow::ToMetres(LatticePoint p) const {
  return {origin_.x() + static_cast<double>(p.x) * step_, origin_.y() + static_cast<double>(p.y) * step_};
}

}  // namespace tilemend
