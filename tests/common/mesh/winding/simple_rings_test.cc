#include "common/mesh/winding/simple_rings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ogr_geometry.h>

#include <algorithm>

#include "common/mesh/ring_polygons.h"

namespace tilemend {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

using Rings = std::vector<std::vector<Point2>>;

const Point2 kFar(501000, 2490000);  // NOLINT(cert-err58-cpp)

void AddRing(const std::vector<Point2>& points, OGRPolygon& polygon) {
  OGRLinearRing ring;
  for (const Point2& p : points) ring.addPoint(p.x(), p.y());
  ring.closeRings();
  polygon.addRing(&ring);
}

// As GEOS sees the polygons of rings.
OGRMultiPolygon PolygonsFrom(const Rings& rings) {
  OGRMultiPolygon all;
  for (const RingPolygon& found : PolygonsOf(rings)) {
    OGRPolygon polygon;
    AddRing(rings[found.outline], polygon);
    for (const int32_t island : found.islands) AddRing(rings[island], polygon);
    all.addGeometry(&polygon);
  }
  return all;
}

Rings Moved(Rings rings) {
  for (auto& ring : rings) {
    for (Point2& p : ring) p += kFar;
  }
  return rings;
}

std::vector<Point2> Square(double x, double y, double side) {
  return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
}
std::vector<Point2> Turned(std::vector<Point2> ring) { return {ring.rbegin(), ring.rend()}; }

struct Case {
  Rings rings;
  Wound wound;
  double area;
  int parts;
};

TEST(SimpleRingsTest, MakeValidPolygons) {
  const std::vector<Point2> bow_tie = {{0, 0}, {8, 8}, {8, 0}, {0, 8}};
  const Case cases[] = {{{Square(0, 0, 8)}, Wound::kLeft, 64, 1},
                        {{Square(0, 0, 8), Turned(Square(2, 2, 4))}, Wound::kLeft, 48, 1},
                        {{bow_tie}, Wound::kLeft, 16, 1},
                        {{bow_tie}, Wound::kEither, 32, 2},
                        {{Turned(Square(0, 0, 8))}, Wound::kEither, 64, 1},
                        {{Square(0, 0, 4), Square(2, 2, 4)}, Wound::kLeft, 28, 1},
                        {{Square(0, 0, 8), Square(2, 2, 4)}, Wound::kLeft, 64, 1},
                        // An island that touches its outline at one vertex, and one that parts it at two.
                        {{Square(0, 0, 8), {{0, 0}, {2, 4}, {4, 2}}}, Wound::kLeft, 58, 1},
                        {{Square(0, 0, 8), {{0, 0}, {2, 6}, {8, 8}, {6, 2}}}, Wound::kLeft, 32, 2},
                        // The outline itself comes back to a vertex, from within and from without.
                        {{{{0, 0}, {8, 0}, {8, 8}, {0, 8}, {0, 0}, {2, 4}, {4, 2}}}, Wound::kLeft, 58, 1},
                        {{{{0, 0}, {4, 0}, {4, 4}, {8, 4}, {8, 8}, {4, 8}, {4, 4}, {0, 4}}}, Wound::kLeft, 32, 2},
                        // A ring that touches its own side, and one with two vertices at one place.
                        {{{{0, 0}, {8, 0}, {8, 8}, {4, 0}, {0, 8}}}, Wound::kLeft, 32, 2},
                        {{{{0, 0}, {8, 0}, {8, 0}, {8, 8}, {0, 8}}}, Wound::kLeft, 64, 1},
                        {{Turned(Square(0, 0, 8))}, Wound::kLeft, 0, 0},
                        // A fold along an edge, there and back.
                        {{{{0, 0}, {8, 0}, {12, 0}, {8, 0}, {8, 8}, {0, 8}}}, Wound::kLeft, 64, 1}};
  for (const Case& c : cases) {
    const OGRMultiPolygon polygons = PolygonsFrom(SimpleRings(Moved(c.rings), c.wound));
    SCOPED_TRACE(polygons.exportToWkt());
    EXPECT_TRUE(polygons.IsValid());
    EXPECT_NEAR(polygons.get_Area(), c.area, 1e-6);
    EXPECT_EQ(polygons.getNumGeometries(), c.parts);
  }
}

TEST(SimpleRingsTest, KeepsTheVerticesOfARingThatIsSimple) {
  const std::vector<Point2> ring = {{0, 0}, {3.25, 0}, {8, 0}, {8, 8}, {0, 8.004}};
  const Rings simple = SimpleRings({ring}, Wound::kLeft);
  ASSERT_THAT(simple, SizeIs(1));
  ASSERT_THAT(simple[0], SizeIs(ring.size()));
  const auto first = std::find(simple[0].begin(), simple[0].end(), ring[0]);
  ASSERT_NE(first, simple[0].end());
  for (size_t i = 0; i < ring.size(); ++i) {
    const Point2& p = simple[0][(first - simple[0].begin() + i) % ring.size()];
    EXPECT_NEAR((p - ring[i]).norm(), 0, 1e-9) << i;
  }
}

TEST(SimpleRingsTest, OfWhatIsNarrowerThanAMillimetreNothingIsLeft) {
  EXPECT_THAT(SimpleRings({{{0, 0}, {8, 0}, {4, 0.0004}}}, Wound::kEither), IsEmpty());
  EXPECT_THAT(SimpleRings({{{0, 0}, {1, 1}, {2, 2}}}, Wound::kEither), IsEmpty());
  EXPECT_THAT(SimpleRings({}, Wound::kLeft), IsEmpty());
}

TEST(SimpleRingsTest, TakesRingsOfAnySize) {
  const Rings simple = SimpleRings({Square(0, 0, 1e9)}, Wound::kLeft);
  EXPECT_NEAR(PolygonsFrom(simple).get_Area(), 1e18, 1e11);
}

}  // namespace
}  // namespace tilemend
