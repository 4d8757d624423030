#include "common/mesh/segment_distance.h"

#include <gtest/gtest.h>

#include "common/mesh/edge_key.h"
#include "common/mesh/tri_mesh.h"

namespace tilemend {
namespace {

TEST(DistanceToSegmentTest, IsThatToTheLineBesideItAndToAnEndBeyond) {
  const Point3 a(1, 1, 1), b(5, 1, 1);
  EXPECT_DOUBLE_EQ(DistanceToSegment(Point3(2, 4, 5), a, b), 5);
  EXPECT_DOUBLE_EQ(DistanceToSegment(Point3(-2, 5, 1), a, b), 5);
  EXPECT_DOUBLE_EQ(DistanceToSegment(Point3(8, 5, 1), a, b), 5);
  EXPECT_DOUBLE_EQ(DistanceToSegment(Point2(3, 7), Point2(1, 1), Point2(5, 1)), 6);
}

TEST(DistanceToSegmentTest, IsThatToThePointWhereBothEndsAreOne) {
  const Point3 a(1, 2, 3);
  EXPECT_DOUBLE_EQ(DistanceToSegment(Point3(1, 2, 10), a, a), 7);
}

TEST(EdgeKeyTest, TellsAnEdgeFromTheWayBackAndHasItInItsHalves) {
  const uint64_t key = EdgeKey(3, 70'000);
  EXPECT_NE(key, EdgeKey(70'000, 3));
  EXPECT_EQ(key << 32 | key >> 32, EdgeKey(70'000, 3));
  EXPECT_NE(EdgeKey(-1, 0), EdgeKey(0, -1));
}

}  // namespace
}  // namespace tilemend
