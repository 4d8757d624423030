#include "coordinator/plan/overlap/line_runs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "absl/strings/str_cat.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

// As "0 outside: 2@5 4@-", a vertex without surface has no height.
std::vector<std::string> Printed(const std::vector<LineRun>& runs) {
  std::vector<std::string> printed;
  for (const LineRun& run : runs) {
    std::string text = absl::StrCat(run.tile, run.outside ? " outside:" : ":");
    for (const LineVertex& v : run.vertices) {
      absl::StrAppend(&text, " ", v.t, "@", v.on_surface ? absl::StrCat(v.height) : "-");
    }
    printed.push_back(text);
  }
  return printed;
}

// Surface from one place to another, its vertices ten metres up there.
LineCover Surface(double from, double to) {
  LineCover cover;
  cover.step = cover.of_tile = {{from, 1}, {to, -1}};
  cover.crossing = {{from, 10}, {to, 10}};
  return cover;
}

// Nothing but what is outside the area.
LineCover Outside(double from, double to) {
  LineCover cover;
  cover.step = {{from, 1}, {to, -1}};
  cover.outside = {from, to};
  return cover;
}

TEST(LineRunsTest, WhereOneTileHasSurfaceAlone) {
  EXPECT_THAT(Printed(FindLineRuns({Surface(0, 6), Surface(4, 8)}, {})), ElementsAre("0: 0@10 4@10", "1: 6@10 8@10"));
  EXPECT_THAT(FindLineRuns({Surface(0, 6), Surface(0, 6)}, {}), IsEmpty());
  EXPECT_THAT(FindLineRuns({}, {}), IsEmpty());
}

TEST(LineRunsTest, AVertexBeyondTheLineGivesItsHeight) {
  LineCover cover = Surface(0, 9);
  cover.height = {{3, 12}, {7, 14}};
  cover.crossing.clear();
  EXPECT_THAT(Printed(FindLineRuns({cover, LineCover()}, {})), ElementsAre("0: 0@12 3@12 7@14 9@14"));
}

TEST(LineRunsTest, AKnownPlaceGoesBeforeACrossing) {
  const std::map<double, LineVertex> fixed = {{0, {0, 3}}, {6, {6, 0, false}}};
  EXPECT_THAT(Printed(FindLineRuns({Surface(0, 6), LineCover()}, fixed)), ElementsAre("0: 0@3 6@-"));
}

// No surface is made up where there is none: its vertices would have a height.
TEST(LineRunsTest, WhatIsOutsideTheAreaHasNoHeight) {
  EXPECT_THAT(Printed(FindLineRuns({Outside(2, 6), LineCover()}, {})), ElementsAre("0 outside: 2@- 6@-"));
}

TEST(LineRunsTest, SurfaceThatEndsAtTheAreasEdgeKeepsItsHeightThere) {
  LineCover cover = Outside(0, 8);
  cover.of_tile = {{0, 1}, {3, -1}};
  cover.crossing = {{0, 10}, {3, 10}};
  cover.outside = {8};
  EXPECT_THAT(Printed(FindLineRuns({cover, LineCover()}, {})), ElementsAre("0: 0@10 3@10", "0 outside: 3@10 8@-"));
}

// The edge of the scene is no edge of the area.
TEST(LineRunsTest, WithoutACellBeyondWhatIsOutsideIsATilesOwn) {
  LineCover beyond;
  beyond.in_scene = false;
  EXPECT_THAT(Printed(FindLineRuns({Outside(2, 6), beyond}, {})), ElementsAre("0: 2@0 6@0"));
}

}  // namespace
}  // namespace tilemend
