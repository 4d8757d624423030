#include "common/records/moved_outline.h"

#include <gtest/gtest.h>

#include <vector>

namespace tilemend {
namespace {

// An outline from vertex 0 at the origin over vertex 1 to vertex 2.
std::vector<PlacedEdge> Outline() {
  return {{0, 1, Point3(0, 0, 0), Point3(2, 0, 0)}, {1, 2, Point3(2, 0, 0), Point3(4, 0, 0)}};
}

// The same over a new vertex 9.
std::vector<PlacedEdge> Over(const Point3& p) { return {{0, 9, Point3(0, 0, 0), p}, {9, 2, p, Point3(4, 0, 0)}}; }

TEST(MovedOutlineTest, MayMoveALittle) {
  EXPECT_TRUE(MayMoveOutline(Outline(), Over({2, 0.1, 0.2})));
  EXPECT_TRUE(MayMoveOutline(Outline(), Over({1, 0, 0}))) << "along itself";
  EXPECT_FALSE(MayMoveOutline(Outline(), Over({2, 0.3, 0})));
  EXPECT_FALSE(MayMoveOutline(Outline(), Over({2, 0, 0.6})));
}

TEST(MovedOutlineTest, LeadsFromAndToTheSameVertices) {
  EXPECT_TRUE(MayMoveOutline({}, {}));
  EXPECT_TRUE(MayMoveOutline(Outline(), std::vector<PlacedEdge>{{0, 2, Point3(0, 0, 0), Point3(4, 0, 0)}}));
  EXPECT_FALSE(MayMoveOutline(Outline(), {}));
  EXPECT_FALSE(MayMoveOutline({}, Outline()));
  EXPECT_FALSE(MayMoveOutline(Outline(), std::vector<PlacedEdge>{{2, 0, Point3(4, 0, 0), Point3(0, 0, 0)}}));
  EXPECT_FALSE(MayMoveOutline(Outline(), std::vector<PlacedEdge>{{0, 9, Point3(0, 0, 0), Point3(4, 0, 0)}}));
}

TEST(MovedOutlineTest, EdgesMayHaveNoLength) {
  const std::vector<PlacedEdge> lost = {{0, 1, Point3(0, 0, 0), Point3(0, 0, 0)}};
  EXPECT_TRUE(MayMoveOutline(lost, lost));
}

}  // namespace
}  // namespace tilemend
