#include "common/records/asked_places.h"

#include <gtest/gtest.h>

namespace tilemend {
namespace {

TEST(VerticesWithoutSegmentTest, AreThoseThatNoHoleHas) {
  CellHoles holes;
  holes.vertices.resize(6);
  holes.holes = {{0, true, {{0, 2, false}, {2, 0, true}}}, {1, true, {{5, 2, false}}}};
  EXPECT_EQ(VerticesWithoutSegment(holes), (std::vector<int32_t>{1, 3, 4}));
  EXPECT_TRUE(VerticesWithoutSegment({}).empty());
}

}  // namespace
}  // namespace tilemend
