#include "common/gis/given_centrelines.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stop_token>
#include <string>
#include <utility>
#include <vector>

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

WaterArea Box(double x0, double x1, bool water = true) {
  WaterArea area{water, {{{{x0, 0}, {x1, 0}, {x1, 2}, {x0, 2}}}}};
  area.label = "box";
  return area;
}

VectorFeature Line(std::vector<Point2> points) {
  VectorFeature feature;
  feature.line = std::move(points);
  feature.label = "line";
  return feature;
}

TEST(GiveCentrelinesTest, TheFirstWaterThatMostPointsAreInHasTheLine) {
  WaterFile file;
  file.areas = {Box(0, 9, false), Box(50, 60), Box(2, 9), Box(0, 9), Box(0, 9)};
  ASSERT_TRUE(GiveCentrelines({Line({{1, 1}, {4, 1}, {8, 1}}), VectorFeature()}, "f", {}, file).ok());
  for (const size_t a : {0, 1, 2, 4}) EXPECT_THAT(file.areas[a].centreline, IsEmpty()) << a;
  EXPECT_THAT(file.areas[3].centreline, ElementsAre(Point2(1, 1), Point2(4, 1), Point2(8, 1)));
  EXPECT_THAT(file.warnings, IsEmpty());
}

TEST(GiveCentrelinesTest, StrayLinesAreOneWarning) {
  WaterFile file;
  file.areas = {Box(0, 9)};
  ASSERT_TRUE(GiveCentrelines({Line({{8, 1}, {20, 1}}), Line({{30, 1}, {40, 1}})}, "f", {}, file).ok());
  EXPECT_THAT(file.areas[0].centreline, IsEmpty());
  EXPECT_THAT(file.warnings, ElementsAre(HasSubstr("f: line and 1 more: a line that lies in no polygon of water")));
}

TEST(GiveCentrelinesTest, ASecondLineIsAnError) {
  WaterFile file;
  file.areas = {Box(0, 9)};
  const auto status = GiveCentrelines({Line({{1, 1}, {2, 1}}), Line({{3, 1}, {4, 1}})}, "f", {}, file);
  EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument);
  EXPECT_THAT(std::string(status.message()), HasSubstr("f: line: a second centreline of box"));
}

TEST(GiveCentrelinesTest, EndsOnceItIsStopped) {
  std::stop_source stop;
  stop.request_stop();
  WaterFile file;
  file.areas = {Box(0, 9)};
  const auto status = GiveCentrelines({Line({{1, 1}, {2, 1}})}, "f", stop.get_token(), file);
  EXPECT_EQ(status.code(), absl::StatusCode::kCancelled);
}

TEST(MostLiesInTest, HalfIsNotMost) {
  const PolygonIndex box(Box(0, 9).polygon);
  EXPECT_FALSE(MostLiesIn(box, {{1, 1}, {20, 1}}));
  EXPECT_TRUE(MostLiesIn(box, {{1, 1}, {20, 1}, {2, 1}}));
}

}  // namespace
}  // namespace tilemend
