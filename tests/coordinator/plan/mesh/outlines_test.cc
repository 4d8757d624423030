#include "coordinator/plan/mesh/outlines.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/mesh_reading.h"
#include "tests/support/round_meshes.h"
#include "tests/support/space_meshes.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;

TEST(FindOutlinesTest, MeasuresHowOpenAPieceIs) {
  EXPECT_THAT(MeshReading(SquaresMesh(0, 3, 0, 3, Everywhere)).outlines, ElementsAre(true));
  EXPECT_THAT(MeshReading(Tube(16, 4, 1, 0, 2)).outlines, ElementsAre(false, false));
  EXPECT_THAT(MeshReading(SphereBelt(0, 60)).outlines, ElementsAre(true));
  EXPECT_THAT(MeshReading(SphereBelt(0, 90)).outlines, ElementsAre(false));
  EXPECT_THAT(MeshReading(SphereBelt(0, 120)).outlines, ElementsAre(false));
}

TEST(FindOutlinesTest, AddsLobesThatTouchTheOutline) {
  const auto keep = [](int32_t i, int32_t j) { return (i < 4) == (j < 4); };  // two squares that touch at a corner
  const MeshReading read(SquaresMesh(0, 8, 0, 8, keep));
  for (const bool outline : read.outlines) EXPECT_TRUE(outline);
}

}  // namespace
}  // namespace tilemend
