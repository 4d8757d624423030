#include "coordinator/plan/rim/area_proposal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace tilemend {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

Grid Cells() { return {{0, 0}, {100, 100}}; }

// The record of a surface with these boundaries, surface on the left.
StoredRecord RecordOf(const std::vector<std::vector<Point2>>& rings) {
  SurveyRecord record;
  for (const std::vector<Point2>& ring : rings) {
    const auto base = static_cast<int32_t>(record.vertices.size()), count = static_cast<int32_t>(ring.size());
    for (int32_t i = 0; i < count; ++i) {
      record.vertices.push_back({base + i, {ring[i].x(), ring[i].y(), 0}});
      record.edges.push_back({base + i, base + (i + 1) % count});
    }
  }
  return StoredRecord(std::make_shared<const SurveyRecord>(std::move(record)));
}

std::vector<Point2> Box(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }
std::vector<Point2> Turned(const std::vector<Point2>& ring) { return {ring.rbegin(), ring.rend()}; }

TEST(ProposeAreaTest, IsTheOutlineOfAllTilesALittleInside) {
  const PlanePolygon area = ProposeArea(
      Cells(), {{{0, 0}, RecordOf({Box(10, 10, 100.2, 100)})}, {{1, 0}, RecordOf({Box(99.8, 10, 200, 100)})}});
  ASSERT_THAT(area.rings, SizeIs(1));
  EXPECT_THAT(area.rings[0], SizeIs(4));
  for (const Point2& p : area.rings[0]) {
    EXPECT_GT(p.x(), 10);
    EXPECT_LT(p.x(), 200);
    EXPECT_NEAR(std::min(p.x() - 10, 200 - p.x()), 2, 1);
    EXPECT_NEAR(std::min(p.y() - 10, 100 - p.y()), 2, 1);
  }
  EXPECT_TRUE(Contains(area, {100, 50}));
}

TEST(ProposeAreaTest, CoversHolesAndMouthsButNoBays) {
  // A hole, a river mouth 30 m wide, and a bay of 80 m.
  const std::vector<Point2> outline = {{0, 0},    {40, 0},   {40, 60}, {70, 60}, {70, 0},    {110, 0},
                                       {110, 70}, {190, 70}, {190, 0}, {200, 0}, {200, 100}, {0, 100}};
  const PlanePolygon area = ProposeArea(Cells(), {{{0, 0}, RecordOf({outline, Turned(Box(10, 70, 30, 90))})}});
  ASSERT_THAT(area.rings, SizeIs(1));
  EXPECT_TRUE(Contains(area, {20, 80}));
  EXPECT_TRUE(Contains(area, {55, 10}));
  EXPECT_FALSE(Contains(area, {150, 10}));
}

TEST(ProposeAreaTest, APartThatOverlapsAnotherIsNotCancelled) {
  const PlanePolygon area = ProposeArea(Cells(), {{{0, 0}, RecordOf({Box(0, 0, 100, 100), Box(20, 20, 120, 80)})}});
  EXPECT_TRUE(Contains(area, {50, 50}));
  EXPECT_TRUE(Contains(area, {110, 50}));
}

TEST(ProposeAreaTest, WithoutSurfaceThereIsNone) {
  EXPECT_THAT(ProposeArea(Cells(), {}).rings, IsEmpty());
  EXPECT_THAT(ProposeArea(Cells(), {{{0, 0}, RecordOf({Box(5, 5, 5.5, 5.5)})}}).rings, IsEmpty());
}

TEST(OutlineInsideCellsTest, IsThereWhereTheSurfaceEndsInsideItsCells) {
  for (const double off : {0.0, 1.0, 10.0}) {
    const std::map<CellId, StoredRecord> records = {{{0, 0}, RecordOf({Box(off, off, 100, 100)})},
                                                    {{1, 0}, RecordOf({Box(100, off, 200 - off, 100)})}};
    EXPECT_EQ(OutlineInsideCells(Cells(), records).empty(), off < 5) << off;
  }
}

TEST(OutlineInsideCellsTest, AHoleInTheMiddleDoesNotCount) {
  EXPECT_TRUE(
      OutlineInsideCells(Cells(), {{{0, 0}, RecordOf({Box(0, 0, 100, 100), Turned(Box(20, 20, 80, 80))})}}).empty());
}

}  // namespace
}  // namespace tilemend
