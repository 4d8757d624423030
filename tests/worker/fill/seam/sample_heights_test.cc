#include "worker/fill/seam/sample_heights.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <vector>

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Pair;

constexpr uint8_t kVertical = 1, kHorizontal = 2, kCorner = 3;

// A hole in a cell whose east side is at x = 10 and whose north side is at y = 10, put together vertex by vertex.
class HoleBuilder {
 public:
  explicit HoleBuilder(bool open = true) { work_.holes.push_back({0, open, {}}); }

  HoleBuilder& Original(double x, double y, double height, double centroid_height) {
    RimVertex v;
    v.index = static_cast<int32_t>(work_.vertices.size());
    v.position = Point3(x, y, height);
    v.centroid_height = centroid_height;
    return Add(v);
  }
  HoleBuilder& Unknown(double x, double y, uint8_t lines) {
    RimVertex v = Seam(x, y, lines);
    v.height_known = false;
    return Add(v);
  }
  HoleBuilder& Known(double x, double y, uint8_t lines, double height) {
    RimVertex v = Seam(x, y, lines);
    v.position.z() = height;
    return Add(v);
  }

  // Joins the vertices to a loop; a segment with a seam vertex at an end is a seam.
  CellHoles Work() const {
    CellHoles work = work_;
    const auto n = static_cast<int32_t>(work.vertices.size());
    for (int32_t v = 0; v < n; ++v) {
      const bool seam = work.vertices[v].index < 0 || work.vertices[(v + 1) % n].index < 0;
      work.holes[0].segments.push_back({v, (v + 1) % n, seam});
    }
    return work;
  }

 private:
  static RimVertex Seam(double x, double y, uint8_t lines) {
    RimVertex v;
    v.lines = lines;
    v.position = Point3(x, y, 0);
    return v;
  }
  HoleBuilder& Add(RimVertex v) {
    v.size = 1;
    if (v.index < 0) v.seam_vertex = 100 + static_cast<int32_t>(work_.vertices.size());
    work_.vertices.push_back(v);
    return *this;
  }

  CellHoles work_;
};

std::map<int32_t, double> Sample(const CellHoles& work) {
  std::map<int32_t, double> heights;
  for (const HeightSample& s : SampleHeights(work)) heights[s.seam_vertex] = s.height;
  return heights;
}

TEST(SampleHeightsTest, GivesThePlanesHeightOnAPlaneOfOneHeight) {
  const CellHoles work = HoleBuilder()
                             .Original(10, 2, 5, 5)
                             .Unknown(10, 4, kVertical)
                             .Unknown(10, 7, kVertical)
                             .Unknown(10, 10, kCorner)
                             .Unknown(6, 10, kHorizontal)
                             .Original(3, 10, 5, 5)
                             .Original(2, 2, 5, 5)
                             .Work();
  EXPECT_THAT(Sample(work), ElementsAre(Pair(101, 5), Pair(102, 5), Pair(103, 5), Pair(104, 5)));
}

TEST(SampleHeightsTest, TakesTheMeanCentroidHeightOfBoundaryPoints) {
  const CellHoles work =
      HoleBuilder().Original(10, 0, 0, 1).Unknown(10, 5, kVertical).Original(10, 10, 0, 1).Original(7, 5, 20, 4).Work();
  EXPECT_THAT(Sample(work), ElementsAre(Pair(101, 4)));
}

TEST(SampleHeightsTest, TakesTheProjectionNearestToTheGridLine) {
  const CellHoles work = HoleBuilder()
                             .Original(10, 0, 0, 0)
                             .Unknown(10, 5, kVertical)
                             .Original(10, 10, 0, 0)
                             .Original(1, 5, 20, 20)
                             .Original(4, 5, 10, 10)
                             .Original(2, 5, 30, 30)
                             .Work();
  EXPECT_THAT(Sample(work), ElementsAre(Pair(101, 10)));
}

// A roof beside the grid line tells nothing of the ground, unless there is nothing else.
TEST(SampleHeightsTest, LeavesOutVerticesOnObjects) {
  CellHoles work = HoleBuilder()
                       .Original(10, 0, 3, 3)
                       .Unknown(10, 5, kVertical)
                       .Original(10, 10, 3, 3)
                       .Original(9, 5, 20, 20)
                       .Work();
  work.vertices[3].on_object = true;
  EXPECT_THAT(Sample(work), ElementsAre(Pair(101, 3)));
  for (RimVertex& v : work.vertices) v.on_object = true;
  EXPECT_THAT(Sample(work), ElementsAre(Pair(101, 20)));
}

// The point nearest to the line in the same stretch of it has another place.
TEST(SampleHeightsTest, TakesWhatProjectsToThePlaceItself) {
  CellHoles work = HoleBuilder()
                       .Original(10, 0, 0, 0)
                       .Unknown(10, 5.25, kVertical)
                       .Original(10, 10, 0, 0)
                       .Original(8, 5.5, 0, 20)
                       .Original(6, 5.25, 0, 30)
                       .Work();
  work.lattice_step = 0x1p-10;
  EXPECT_THAT(Sample(work), ElementsAre(Pair(101, 30)));
}

TEST(SampleHeightsTest, InterpolatesBetweenProjections) {
  const CellHoles work = HoleBuilder()
                             .Original(10, 0, 0, 0)
                             .Unknown(10, 5, kVertical)
                             .Original(10, 10, 0, 0)
                             .Original(5, 7, 0, 14)
                             .Original(5, 3, 0, 6)
                             .Work();
  EXPECT_THAT(Sample(work), ElementsAre(Pair(101, 10)));
}

// The west-east line has (4, 10) with 3 m at its end, the south-north line (10, 4) with 1 m: seen from either line the
// other point projects to the corner.
TEST(SampleHeightsTest, GivesACornerTheMeanOfBothSides) {
  const CellHoles work =
      HoleBuilder().Original(10, 4, 1, 7).Unknown(10, 10, kCorner).Original(8, 10, 5, 7).Original(4, 4, 9, 9).Work();
  EXPECT_THAT(Sample(work), ElementsAre(Pair(101, (5.0 + 1.0) / 2)));
}

TEST(SampleHeightsTest, GivesAVertexOnOneLineThatSideAlone) {
  const CellHoles work =
      HoleBuilder().Original(10, 4, 1, 7).Unknown(10, 10, kVertical).Original(8, 10, 5, 7).Original(4, 4, 9, 9).Work();
  EXPECT_THAT(Sample(work), ElementsAre(Pair(101, 5)));
}

TEST(SampleHeightsTest, TakesAJunctionsOwnHeight) {
  const CellHoles work = HoleBuilder().Original(10, 0, 2, 50).Unknown(10, 5, kVertical).Original(10, 10, 6, 50).Work();
  EXPECT_THAT(Sample(work), ElementsAre(Pair(101, 4)));
}

TEST(SampleHeightsTest, PassesOnTheHeightsOfSettledSeams) {
  const CellHoles work = HoleBuilder()
                             .Known(0, 0, kVertical, 1)
                             .Known(0, 5, kVertical, 3)
                             .Known(0, 10, kVertical, 5)
                             .Unknown(10, 10, kVertical)
                             .Unknown(10, 5, kVertical)
                             .Work();
  EXPECT_THAT(Sample(work), ElementsAre(Pair(103, 5), Pair(104, 3)));
}

TEST(SampleHeightsTest, GivesOneSampleForEachUnknownVertexInOrder) {
  const CellHoles work = HoleBuilder()
                             .Original(10, 0, 0, 0)
                             .Unknown(10, 3, kVertical)
                             .Known(10, 5, kVertical, 1)
                             .Unknown(10, 7, kVertical)
                             .Original(10, 10, 0, 0)
                             .Work();
  std::vector<int32_t> order;
  for (const HeightSample& s : SampleHeights(work)) order.push_back(s.seam_vertex);
  EXPECT_THAT(order, ElementsAre(101, 103));
}

TEST(SampleHeightsTest, SamplesNothingForClosedHoles) {
  const CellHoles work =
      HoleBuilder(false).Original(10, 0, 0, 0).Unknown(10, 3, kVertical).Original(10, 10, 0, 0).Work();
  EXPECT_THAT(SampleHeights(work), IsEmpty());
}

TEST(SampleHeightsTest, SamplesNothingWhereNoHeightIsKnown) {
  const CellHoles work = HoleBuilder().Unknown(10, 0, kVertical).Unknown(10, 10, kCorner).Unknown(0, 0, kCorner).Work();
  EXPECT_THAT(SampleHeights(work), IsEmpty());
}

}  // namespace
}  // namespace tilemend
