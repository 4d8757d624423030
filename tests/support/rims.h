// Rims of made holes.
#ifndef TILEMEND_TESTS_SUPPORT_RIMS_H_
#define TILEMEND_TESTS_SUPPORT_RIMS_H_

#include <cmath>
#include <functional>
#include <random>
#include <utility>
#include <vector>

#include "coordinator/plan/water/level_evidence.h"

namespace tilemend {

struct MadeRim {
  std::vector<RimChain> chains;
  std::vector<PlaneSegment> outline;
};

using HeightAt = std::function<double(double x, double y)>;

// The rim of a box with an edge each metre, with noise (standard deviation).
inline MadeRim BoxRim(const Point2& lo, const Point2& hi, const HeightAt& height, double noise = 0.02) {
  std::mt19937 random(7);
  std::vector<Point2> ring;
  for (double x = lo.x(); x < hi.x(); ++x) ring.emplace_back(x, lo.y());
  for (double y = lo.y(); y < hi.y(); ++y) ring.emplace_back(hi.x(), y);
  for (double x = hi.x(); x > lo.x(); --x) ring.emplace_back(x, hi.y());
  for (double y = hi.y(); y > lo.y(); --y) ring.emplace_back(lo.x(), y);
  MadeRim rim;
  RimChain& chain = rim.chains.emplace_back();
  for (size_t i = 0; i < ring.size(); ++i) {
    const Point2 &a = ring[i], &b = ring[(i + 1) % ring.size()], middle = (a + b) / 2;
    double sum = 0;  // of twelve even ones: as good as normal
    for (int k = 0; k < 12; ++k) sum += static_cast<double>(random()) * 0x1p-32;
    const double z = height(middle.x(), middle.y()) + noise * (sum - 6);
    chain.push_back({Point3(middle.x(), middle.y(), z), (b - a).norm()});
    rim.outline.emplace_back(a, b);
  }
  return rim;
}

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_RIMS_H_
