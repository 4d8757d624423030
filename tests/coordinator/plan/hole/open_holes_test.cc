#include "coordinator/plan/hole/open_holes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "coordinator/plan/types/left_reasons.h"
#include "tests/support/hole_scene.h"

namespace tilemend {
namespace {

// Adds a loop of segments over the vertices; the first is a seam and lies along `side`, with `across` beyond.
void AddOpen(HoleScene& scene, const std::vector<int32_t>& vertices, Side side, CellId across) {
  for (size_t i = 0; i < vertices.size(); ++i) {
    BoundarySegment s;
    s.segment = {vertices[i], vertices[(i + 1) % vertices.size()]};
    if (i == 0) {
      s.segment.seam = true;
      s.side = side;
      s.across = across;
    }
    scene.boundary.open.push_back(s);
  }
}

TEST(FindOpenHolesTest, FindsARegionAndWhereItLies) {
  HoleScene scene({PieceLoop(2, 0, 6, 3)});
  AddOpen(scene, {0, 1, 2, 3}, kSouth, {0, -1});
  const OpenHoles found = FindOpenHoles(scene.Site(), scene.boundary);
  ASSERT_EQ(found.holes.size(), 1U);
  EXPECT_EQ(found.holes[0].kind, HoleKind::kOpenII);
  EXPECT_EQ(found.holes[0].type, HoleType::kB);
  EXPECT_EQ(found.holes[0].area, 12);
  EXPECT_EQ(found.holes[0].perimeter, 3 + 4 + 3);
  ASSERT_EQ(found.places.size(), 1U);
  EXPECT_EQ(found.places[0].hole, 0U);
}

TEST(FindOpenHolesTest, CallsAHoleInternalThatReachesCellsOfTheAreaAlone) {
  HoleScene scene({PieceLoop(2, 0, 6, 3)});
  scene.area.insert({0, -1});
  AddOpen(scene, {0, 1, 2, 3}, kSouth, {0, -1});
  EXPECT_EQ(FindOpenHoles(scene.Site(), scene.boundary).holes.at(0).kind, HoleKind::kOpenI);
}

TEST(FindOpenHolesTest, FindsEveryRegion) {
  HoleScene scene({PieceLoop(2, 0, 6, 3), PieceLoop(2, 7, 6, 10)});
  AddOpen(scene, {0, 1, 2, 3}, kSouth, {0, -1});
  AddOpen(scene, {6, 7, 4, 5}, kNorth, {0, 1});
  EXPECT_EQ(FindOpenHoles(scene.Site(), scene.boundary).places.size(), 2U);
}

TEST(FindOpenHolesTest, DropsSegmentsThatAreThereBothWays) {
  HoleScene scene({PieceLoop(2, 0, 6, 3)});
  AddOpen(scene, {0, 1, 2, 3}, kSouth, {0, -1});
  const OpenHoles before = FindOpenHoles(scene.Site(), scene.boundary);
  scene.boundary.open.push_back({{1, 3, true}, kWest, {-1, 0}});
  scene.boundary.open.push_back({{3, 1, true}, kWest, {-1, 0}});
  const OpenHoles after = FindOpenHoles(scene.Site(), scene.boundary);
  ASSERT_EQ(after.holes.size(), 1U);
  EXPECT_EQ(after.holes[0].area, before.holes[0].area);
  EXPECT_EQ(after.holes[0].segments.size(), 4U);
}

TEST(FindOpenHolesTest, LeavesAHoleThatFoldsToTheFiller) {
  HoleScene scene({PieceLoop(2, 0, 6, 3), PieceLoop(2, 7, 6, 10)});
  AddOpen(scene, {0, 1, 3, 2}, kSouth, {0, -1});  // crosses itself
  AddOpen(scene, {6, 7, 4, 5}, kNorth, {0, 1});
  const OpenHoles found = FindOpenHoles(scene.Site(), scene.boundary);
  ASSERT_EQ(found.holes.size(), 2U);
  EXPECT_FALSE(found.holes[0].projects);
  EXPECT_EQ(found.holes[0].failure, "");
  EXPECT_TRUE(found.holes[1].projects) << "a bad hole is alone";
  EXPECT_EQ(found.places.size(), 1U);
  EXPECT_EQ(found.places[0].hole, 1U);
}

TEST(FindOpenHolesTest, FailsWhereSegmentsBoundNothing) {
  HoleScene scene({PieceLoop(2, 0, 6, 3)});
  AddOpen(scene, {0, 1, 2, 3}, kSouth, {0, -1});
  scene.boundary.open.erase(scene.boundary.open.begin());  // as at the rim of an area that is not known
  const OpenHoles found = FindOpenHoles(scene.Site(), scene.boundary);
  ASSERT_EQ(found.holes.size(), 1U);
  EXPECT_THAT(found.holes[0].failure, testing::HasSubstr("does not close"));
  EXPECT_TRUE(found.places.empty());
  scene.lines.left_open.insert({{0, -1}, {0, 0}});
  EXPECT_EQ(FindOpenHoles(scene.Site(), scene.boundary).holes[0].failure, kReachesUnknownRim);
  scene.boundary.seam_failure = "no way along the line";
  EXPECT_EQ(FindOpenHoles(scene.Site(), scene.boundary).holes[0].failure, "no way along the line");
}

TEST(FindOpenHolesTest, FailsWhereACrossingBoundaryDoesNotClose) {
  HoleScene scene({PieceLoop(2, 0, 6, 3)});
  AddOpen(scene, {0, 1, 3, 2}, kSouth, {0, -1});
  scene.boundary.open.erase(scene.boundary.open.begin());
  const OpenHoles found = FindOpenHoles(scene.Site(), scene.boundary);
  ASSERT_EQ(found.holes.size(), 1U);
  EXPECT_NE(found.holes[0].failure.find("crosses itself"), std::string::npos);
}

TEST(FindOpenHolesTest, FindsNothingWithoutSegments) {
  const HoleScene scene({HoleLoop(2, 2, 4, 4)});
  EXPECT_TRUE(FindOpenHoles(scene.Site(), scene.boundary).holes.empty());
}

}  // namespace
}  // namespace tilemend
