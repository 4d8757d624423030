#include "common/mesh/polygon_index.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tilemend {
namespace {

PlanePolygon RaggedRing(int points) {
  std::mt19937 random(7);
  PlanePolygon polygon;
  polygon.rings.emplace_back();
  for (int k = 0; k < points; ++k) {
    const double angle = 2 * M_PI * k / points, radius = 20 + static_cast<double>(random() % 1000) / 100;
    polygon.rings[0].emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  polygon.rings.push_back({{-4, -4}, {4, -4}, {4, 4}, {-4, 4}});  // an island
  return polygon;
}

TEST(PolygonIndexTest, AgreesWithContainsEverywhere) {
  for (const int points : {3, 40, 900}) {
    const PlanePolygon polygon = RaggedRing(points);
    const PolygonIndex index(polygon);
    std::mt19937 random(11);
    int inside = 0;
    for (int k = 0; k < 5000; ++k) {
      const Point2 p(static_cast<double>(random() % 8000) / 100 - 40, static_cast<double>(random() % 8000) / 100 - 40);
      EXPECT_EQ(index.Contains(p), Contains(polygon, p)) << p.transpose();
      inside += index.Contains(p) ? 1 : 0;
    }
    EXPECT_GT(inside, 400);
  }
}

TEST(PolygonIndexTest, NothingLiesInAnEmptyOne) {
  const PolygonIndex index{PlanePolygon()};
  EXPECT_FALSE(index.Contains({0, 0}));
  EXPECT_GT(index.lo().x(), index.hi().x());
}

TEST(PolygonIndexTest, AFlatRingHoldsNothing) {
  const PolygonIndex index(PlanePolygon{{{{0, 1}, {2, 1}, {4, 1}}}});
  EXPECT_FALSE(index.Contains({2, 1}));
}

}  // namespace
}  // namespace tilemend
