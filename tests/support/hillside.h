// Steep ground of a known shape.
#ifndef TILEMEND_TESTS_SUPPORT_HILLSIDE_H_
#define TILEMEND_TESTS_SUPPORT_HILLSIDE_H_

#include <cmath>

namespace tilemend {

// The height at (x, y) of hills that stand on a plane rising by 1 m a metre along x, along its normal. Their sides are
// less steep than 1 over it: height < length.
inline double HillsOnASlope(double x, double y, double height, double length) {
  const auto over_plane = [&](double u) { return height * std::sin(u / length + 0.4) * std::cos(y / length); };
  double u = std::sqrt(2.0) * x;
  for (int k = 0; k < 60; ++k) u = std::sqrt(2.0) * x + over_plane(u);
  return (u + over_plane(u)) / std::sqrt(2.0);
}

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_HILLSIDE_H_
