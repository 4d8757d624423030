#include "worker/papers/wang/closure_buffers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "tests/support/folded_meshes.h"
#include "worker/papers/wang/wang_fill.h"

namespace tilemend {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

constexpr double kStep = 0x1p-10;
constexpr uint8_t kOriginal = 0, kOnEasternSide = 1, kCorner = 3;

struct Corner {
  double x, y;
  uint8_t lines;
};

// A hole west of the grid line x = 10, with these vertices around it counterclockwise. Heights tell them apart.
class ClosureBuffersTest : public testing::Test {
 protected:
  // inner: the neighbour's outline within the hole.
  const LocalHole& Hole(const std::vector<Corner>& corners, const std::vector<Point2>& inner = {}) {
    work_.lattice_step = kStep;
    CellHole hole{0, true};
    const auto count = static_cast<int32_t>(corners.size());
    for (int32_t k = 0; k < count; ++k) {
      RimVertex v;
      v.position = Point3(corners[k].x, corners[k].y, k);
      v.lines = corners[k].lines;
      v.index = v.lines == kOriginal ? k : -1;
      v.size = 1;
      work_.vertices.push_back(v);
      const int32_t next = (k + 1) % count;
      hole.segments.push_back({k, next, corners[k].lines != kOriginal || corners[next].lines != kOriginal});
    }
    for (const Point2& p : inner) {
      RimVertex v;
      v.position = Point3(p.x(), p.y(), 50);
      v.lines = kOnEasternSide;
      v.size = 1;
      work_.vertices.push_back(v);
      if (work_.vertices.size() == corners.size() + 1) continue;
      const auto last = static_cast<int32_t>(work_.vertices.size()) - 1;
      hole.inner_edges.push_back({last - 1, last, true});
    }
    work_.holes.push_back(std::move(hole));
    std::vector<Point3> points;  // the band's other points come after these
    for (const RimVertex& v : work_.vertices) points.push_back(v.position);
    work_.band.points.insert(work_.band.points.begin(), points.begin(), points.end());
    band_.emplace(work_);
    return hole_.emplace(MakeLocalHole(work_, *band_, work_.holes[0]));
  }

  static std::vector<std::pair<int32_t, int32_t>> Edges(const ClosureBuffers& buffers) {
    std::vector<std::pair<int32_t, int32_t>> edges;
    for (const RegionSegment& e : buffers.edges) edges.push_back(Undirected(e.from, e.to));
    std::sort(edges.begin(), edges.end());
    return edges;
  }

  CellHoles work_;
  std::optional<CellBand> band_;
  std::optional<LocalHole> hole_;
};

// Vertices 0 and 3 lie on the line; 1 and 2 are new; 8 and 4 are their neighbours on this side.
const std::vector<Corner> kOnTheLine = {{10, 2, kOriginal}, {10, 4, kOnEasternSide}, {10, 6, kOnEasternSide},
                                        {10, 8, kOriginal}, {8.5, 8, kOriginal},     {6, 8, kOriginal},
                                        {6, 5, kOriginal},  {6, 2, kOriginal},       {8, 2, kOriginal}};

TEST_F(ClosureBuffersTest, AVertexOnTheLineGivesTheDistanceOfItsNeighbour) {
  const ClosureBuffers buffers = LayClosureBuffers(Hole(kOnTheLine));
  EXPECT_THAT(buffers.joints, ElementsAre(ClosureCase::kOnLine, ClosureCase::kOnLine));
  ASSERT_THAT(buffers.points, SizeIs(2));
  EXPECT_NEAR(buffers.points[0].x(), 10 - (2 - 0.5 / 3), kStep) << "a third of the way from 2 to 1.5";
  EXPECT_NEAR(buffers.points[1].x(), 10 - (2 - 1.0 / 3), kStep);
  EXPECT_EQ(buffers.points[0].tail<2>(), Point2(4, 1)) << "opposite the first new vertex, with its height";
  EXPECT_EQ(buffers.points[1].tail<2>(), Point2(6, 2));
  EXPECT_THAT(Edges(buffers), ElementsAre(std::pair(4, 10), std::pair(8, 9), std::pair(9, 10)));
}

TEST_F(ClosureBuffersTest, AnEdgeAcrossTheLineGivesTheDistanceOfItsEndOnThisSide) {
  std::vector<Corner> corners = kOnTheLine;
  corners[0] = {10.5, 2, kOriginal};  // its other end is vertex 8
  corners[8] = {9, 2, kOriginal};
  corners[3] = {9.2, 8, kOriginal};  // its other end is the other cell's
  corners[4] = {8, 8, kOriginal};
  const ClosureBuffers buffers = LayClosureBuffers(Hole(corners));
  EXPECT_THAT(buffers.joints, ElementsAre(ClosureCase::kAcross, ClosureCase::kAcross));
  ASSERT_THAT(buffers.points, SizeIs(2));
  EXPECT_NEAR(buffers.points[0].x(), 10 - (1 - 0.2 / 3), kStep);
  EXPECT_NEAR(buffers.points[1].x(), 10 - (1 - 0.4 / 3), kStep);
  EXPECT_THAT(Edges(buffers), ElementsAre(std::pair(3, 10), std::pair(8, 9), std::pair(9, 10)));
}

TEST_F(ClosureBuffersTest, APointOfTheOtherCellThatTouchesTheLineGivesTheMeanDistanceOfItsNeighbours) {
  work_.band.points = {{11, 4.5, 0}, {12, 5.5, 0}};
  work_.band.triangles = {{3, 9, 10}};
  const LocalHole& hole = Hole({{10, 0, kCorner},
                                {10, 2.5, kOnEasternSide},
                                {10, 4, kOnEasternSide},
                                {10, 5, kOriginal},
                                {10, 6, kOnEasternSide},
                                {10, 7.5, kOnEasternSide},
                                {10, 10, kCorner},
                                {2, 9, kOriginal},
                                {2, 1, kOriginal}});
  const ClosureBuffers buffers = LayClosureBuffers(hole);
  EXPECT_THAT(buffers.joints, ElementsAre(ClosureCase::kTouching));
  ASSERT_THAT(buffers.points, SizeIs(5));
  for (const Point3& p : buffers.points) EXPECT_EQ(p.x(), 8.5);
  EXPECT_THAT(buffers.edges, SizeIs(4)) << "none to the corners: no joint is there";
}

// The tile ends at x = 10; its neighbour's outline is at x = 9.6.
TEST_F(ClosureBuffersTest, WhereTilesOverlapTheyBeginAtTheNeighboursOutline) {
  std::vector<Corner> corners = kOnTheLine;
  corners[4].x = 9.8;  // between the outlines, and the next is a vertex beyond both
  corners[5].x = 8;
  const LocalHole& hole = Hole(corners, {{9.6, 4}, {9.6, 6}});
  const ClosureBuffers buffers = LayClosureBuffers(hole);
  EXPECT_THAT(buffers.joints, ElementsAre(ClosureCase::kAcross, ClosureCase::kAcross));
  ASSERT_THAT(buffers.points, SizeIs(2));
  EXPECT_NEAR(buffers.points[0].x(), 9.6 - 1.6, kStep) << "as far off as vertices 5 and 8";
  EXPECT_NEAR(buffers.points[1].x(), 9.6 - 1.6, kStep);
  EXPECT_EQ(buffers.points[0].y(), 4);
  EXPECT_THAT(Edges(buffers), ElementsAre(std::pair(5, 12), std::pair(8, 11), std::pair(11, 12)));
}

TEST_F(ClosureBuffersTest, AStretchBetweenGridCornersHasNone) {
  std::vector<Corner> corners = kOnTheLine;
  corners[0].lines = corners[3].lines = kCorner;
  const ClosureBuffers buffers = LayClosureBuffers(Hole(corners));
  EXPECT_THAT(buffers.joints, IsEmpty());
  EXPECT_THAT(buffers.points, IsEmpty());
}

TEST_F(ClosureBuffersTest, PointsWhoseTrianglesWouldBeLongAreNotSelected) {
  std::vector<Corner> corners = kOnTheLine;
  for (Corner& c : corners) c.y *= 10;  // 20 m apart, 2 m off the line
  EXPECT_THAT(LayClosureBuffers(Hole(corners)).points, IsEmpty());
}

TEST_F(ClosureBuffersTest, NoPointIsNearTheBoundaryOrBeyondIt) {
  std::vector<Corner> corners = kOnTheLine;
  corners.insert(corners.begin() + 6,
                 {{8.4, 6.2, kOriginal}, {7.5, 4.2, kOriginal}, {8.6, 4, kOriginal}, {6, 3.8, kOriginal}});
  corners.erase(corners.begin() + 10);
  const ClosureBuffers buffers = LayClosureBuffers(Hole(corners));
  EXPECT_THAT(buffers.joints, SizeIs(2));
  EXPECT_THAT(buffers.points, IsEmpty());
}

TEST_F(ClosureBuffersTest, ThePatchHasThemUnlessHolesAreClosedAlongTheLine) {
  const LocalHole& hole = Hole(kOnTheLine);
  FillOptions options = With(Surface::kWang);
  options.wang.adjust = false;
  options.wang.fairing_steps = 0;
  const LocalPatch with = FillAsWang(hole, ProjectionFrame::Upright(), options, true);
  ASSERT_TRUE(with.ok());
  ASSERT_GE(with.new_points.size(), 2U);
  EXPECT_THAT(std::span(with.new_points).first(2), testing::ElementsAreArray(LayClosureBuffers(hole).points));
  ExpectClosesHole(work_, work_.holes[0], ToHolePatch(hole, with));
  options.wang.closure = Closure::kLine;
  const LocalPatch without = FillAsWang(hole, ProjectionFrame::Upright(), options, true);
  EXPECT_NE(without.new_points, with.new_points);
}

}  // namespace
}  // namespace tilemend
