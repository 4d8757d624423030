// Boundaries for advancing fronts, over known surfaces.
#ifndef TILEMEND_TESTS_SUPPORT_FRONT_RIMS_H_
#define TILEMEND_TESTS_SUPPORT_FRONT_RIMS_H_

#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <vector>

#include "worker/papers/front/advancing_front.h"

namespace tilemend {

// A round boundary of that many edges, each about 1 m, lifted to a surface over the plane with that normal. A second
// ring outside stands for the surface. Every other point is set off by the share `wave` of the radius.
inline FrontRim RoundRim(int32_t edges, double wave, const std::function<double(double, double)>& height,
                         const std::function<Eigen::Vector3d(double, double)>& normal) {
  FrontRim rim;
  const double radius = edges / (2 * std::numbers::pi);
  const auto at = [&](double angle, double r) {
    const double x = r * std::cos(angle), y = r * std::sin(angle);
    return Point3(x, y, height(x, y));
  };
  std::vector<int32_t> loop;
  for (int32_t i = 0; i < edges; ++i) {
    const double turn = 2 * std::numbers::pi / edges, angle = i * turn;
    const double r = radius * (1 + wave * std::sin(3 * angle));
    rim.points.push_back(at(angle, r));
    rim.areas.emplace_back(normal(rim.points.back().x(), rim.points.back().y()));
    rim.neighbours.push_back(
        {at(angle - turn, r), at(angle + turn, r), at(angle - turn / 2, r + 1), at(angle + turn / 2, r + 1)});
    rim.sizes.push_back(1);
    loop.push_back(i);
  }
  rim.loops = {loop};
  rim.may_join = [edges](int32_t a, int32_t b) { return std::abs(a - b) != 1 && std::abs(a - b) != edges - 1; };
  return rim;
}

inline FrontRim FlatRim(int32_t edges, double wave = 0) {
  return RoundRim(
      edges, wave, [](double, double) { return 0.0; }, [](double, double) { return Eigen::Vector3d(0, 0, 1); });
}

// On top of a sphere about the origin.
inline FrontRim SphereRim(int32_t edges, double radius) {
  const auto height = [=](double x, double y) { return std::sqrt(radius * radius - x * x - y * y); };
  return RoundRim(edges, 0, height, [=](double x, double y) { return Eigen::Vector3d(x, y, height(x, y)); });
}

inline FrontLimits EnoughFor(const FrontRim& rim) {
  FrontLimits limits;
  limits.most_new_points = 2 * std::ssize(rim.points) * std::ssize(rim.points);
  limits.longest_front = 2 * std::ssize(rim.points) + 100;
  limits.most_looks = 10'000'000;
  return limits;
}

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_FRONT_RIMS_H_
