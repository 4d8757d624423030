#include "common/mesh/polygon_index.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tilemend {

PolygonIndex::PolygonIndex(const PlanePolygon& polygon)
    : lo_(Point2::Constant(std::numeric_limits<double>::infinity())), hi_(-lo_) {
  size_t points = 0;
  for (const std::vector<Point2>& ring : polygon.rings) {
    points += ring.size();
    for (const Point2& p : ring) {
      lo_ = lo_.cwiseMin(p);
      hi_ = hi_.cwiseMax(p);
    }
  }
  const auto bands = static_cast<size_t>(std::sqrt(static_cast<double>(points))) + 1;
  bands_.resize(bands);
  if (points > 0 && hi_.y() > lo_.y()) band_height_ = (hi_.y() - lo_.y()) / static_cast<double>(bands);
  for (const std::vector<Point2>& ring : polygon.rings) {
    for (size_t i = 0; i < ring.size(); ++i) {
      const Point2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
      const auto [low, high] = std::minmax(a.y(), b.y());
      for (size_t k = BandOf(low); k <= BandOf(high); ++k) bands_[k].emplace_back(a, b);
    }
  }
}

size_t PolygonIndex::BandOf(double y) const {
  const double band = std::floor((y - lo_.y()) / band_height_);
  return static_cast<size_t>(std::clamp(band, 0.0, static_cast<double>(bands_.size() - 1)));
}

bool PolygonIndex::Contains(const Point2& p) const {
  if ((p.array() < lo_.array()).any() || (p.array() > hi_.array()).any()) return false;
  bool inside = false;
  for (const auto& [a, b] : bands_[BandOf(p.y())]) {
    if ((a.y() <= p.y()) == (b.y() <= p.y())) continue;
    inside ^= p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
  }
  return inside;
}

}  // namespace tilemend
