#include "coordinator/plan/seam/projected_places.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/support/rim_builders.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr double kStep = 0x1p-10;
const Border kBorder{{0, 0}, {1, 0}};

// A hole over the line x = 100 between two cells, its boundary clockwise.
struct HoleOverLine {
  explicit HoleOverLine(const Loop3& loop) : area(AreaOf(2, 1)), lines(LinesOf(area, 100)), rim(RimOf({loop})) {}

  std::vector<double> Places(double from, double to) const {
    const RimIndex index(rim);
    const PlanOptions options;
    const SeamSite site{area, lines, rim, index, options, kStep};
    std::vector<double> places;
    for (const SeamPlace& place :
         ProjectedPlaces(site, kBorder, {100, from}, {100, to}, RimPlacesBeside(site, kBorder))) {
      EXPECT_EQ(place.position.x(), 100);
      EXPECT_EQ(std::fmod(place.position.y(), kStep), 0);
      places.push_back(place.position.y());
    }
    return places;
  }

  std::set<CellId> area;
  GridLines lines;
  Rim rim;
};

TEST(ProjectedPlacesTest, LieOppositeTheBoundaryPointsOfBothCells) {
  const HoleOverLine hole(
      {{70, 10, 0}, {70, 30, 0}, {70, 50, 0}, {70, 70, 0}, {130, 70, 0}, {130, 40, 0}, {130, 10, 0}});
  EXPECT_THAT(hole.Places(10, 70), ElementsAre(30, 50));  // 40 is too near to those of the other cell
}

TEST(ProjectedPlacesTest, LeaveOutWhatTheBoundaryHides) {
  // A tongue of surface from the west at 40 to 60 hides nothing to its east; the bay behind its hook is hidden.
  const HoleOverLine hole({{60, 10, 0},
                           {60, 40, 0},
                           {90, 40, 0},
                           {90, 60, 0},
                           {70, 60, 0},
                           {70, 52, 0},
                           {64, 52, 0},
                           {64, 90, 0},
                           {130, 90, 0},
                           {130, 10, 0}});
  const std::vector<double> places = hole.Places(10, 90);
  EXPECT_THAT(places, ::testing::Contains(60));
  EXPECT_THAT(places, ::testing::Not(::testing::Contains(52)));
}

TEST(ProjectedPlacesTest, AreNoneWhereTheBoundaryRunsUpToTheLine) {
  const HoleOverLine hole({{95, 10, 0}, {95, 10.2, 0}, {130, 10.2, 0}, {130, 10, 0}});
  EXPECT_THAT(hole.Places(10, 10.2), IsEmpty());
}

// The line goes on from the corner at y = 100; tiles reach 3 m over y = 100 there.
TEST(ProjectedPlacesTest, AreNoneInTheStripOfTheLineAcross) {
  const Loop3 loop = {{70, 86, 0}, {70, 90, 0}, {70, 94, 0}, {70, 98, 0}, {70, 102, 0}, {130, 102, 0}, {130, 86, 0}};
  HoleOverLine hole(loop);
  EXPECT_THAT(hole.Places(86, 100), ElementsAre(90, 94, 98));
  hole.lines.outline = hole.lines.coordinate;
  hole.lines.outline.at({1, 0})[kNorth] = 103;
  EXPECT_THAT(hole.Places(86, 100), ElementsAre(90, 94)) << "98 is in the strip, 94 far enough from it";
  hole.lines.outline.at({1, 0})[kNorth] = 105;
  EXPECT_THAT(hole.Places(86, 100), ElementsAre(90)) << "94 is too near to the strip";
}

TEST(ProjectedPlacesTest, AreNoneOppositeAnotherCellsBoundary) {
  const HoleOverLine hole({{-70, 10, 0}, {-70, 50, 0}, {-70, 90, 0}, {270, 90, 0}, {270, 50, 0}, {270, 10, 0}});
  EXPECT_THAT(hole.Places(10, 90), IsEmpty());
}

}  // namespace
}  // namespace tilemend
