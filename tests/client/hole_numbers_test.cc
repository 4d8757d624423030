#include "client/hole_numbers.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

Json Feature(int hole, const char* cell, const char* outcome, const char* type, const Json& coordinates) {
  return {{"properties", {{"hole", hole}, {"cell", cell}, {"outcome", outcome}}},
          {"geometry", {{"type", type}, {"coordinates", coordinates}}}};
}

// A square in a CRS with the origin (1000, 2000).
Json Square(double x, double y, double size) {
  x += 1000;
  y += 2000;
  return {{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}, {x, y}};
}

HoleNumbers NumbersOf(const Json& features, const Json& holes = Json::array()) {
  ReportedOutput reported = ReadReported({{"per_hole", holes}});
  AddRims({{"features", features}}, {1000, 2000}, reported);
  return HoleNumbers(reported);
}

TEST(HoleNumbersTest, TheHoleAroundAPlace) {
  // Hole 3 has an island, and there the hole 4.
  const HoleNumbers numbers =
      NumbersOf({Feature(3, "+000_+015", "filled", "Polygon", {Square(0, 0, 90), Square(40, 40, 10)}),
                 Feature(4, "+000_+015", "filled", "Polygon", Json::array({Square(42, 42, 2)})),
                 Feature(5, "+001_+015", "filled", "MultiPolygon", Json::array({Json::array({Square(100, 0, 5)})}))});
  EXPECT_EQ(numbers.At({0, 15}, {20, 44, 0}), 3);
  EXPECT_EQ(numbers.At({0, 15}, {39, 43, 0}), 3);
  EXPECT_EQ(numbers.At({0, 15}, {43, 43, 0}), 4);
  EXPECT_EQ(numbers.At({1, 15}, {103, 3, 0}), 5);
}

TEST(HoleNumbersTest, TheNearestBoundaryIfNoneIsAround) {
  const HoleNumbers numbers =
      NumbersOf({Feature(3, "+000_+000", "filled", "Polygon", Json::array({Square(0, 0, 9)})),
                 Feature(4, "+000_+000", "filled", "MultiLineString", {{{1020, 2000}, {1020, 2009}}}),
                 Feature(5, "+000_+000", "left", "Polygon", Json::array({Square(17, 0, 2)}))});
  EXPECT_EQ(numbers.At({0, 0}, {10, 5, 0}), 3);
  EXPECT_EQ(numbers.At({0, 0}, {18, 5, 0}), 4);
}

Json Row(int hole, const Json& rim_heights, const Json& level = Json()) {
  return {{"id", hole}, {"outcome", "filled"}, {"rim_heights_m", rim_heights}, {"level_m", level}};
}

// A hole in the ground, and one in the roof above it.
TEST(HoleNumbersTest, OfHolesOverEachOtherTheOneAtThatHeight) {
  const HoleNumbers numbers =
      NumbersOf({Feature(3, "+000_+000", "filled", "Polygon", Json::array({Square(0, 0, 90)})),
                 Feature(4, "+000_+000", "filled", "Polygon", Json::array({Square(40, 40, 10)}))},
                {Row(3, {-2, 1.5}), Row(4, {30, 32})});
  EXPECT_EQ(numbers.At({0, 0}, {42, 45, 1}), 3);
  EXPECT_EQ(numbers.At({0, 0}, {42, 45, 31}), 4);
  EXPECT_EQ(numbers.At({0, 0}, {42, 45, 28}), 4) << "below its rim, and nearer to it";
  EXPECT_EQ(numbers.At({0, 0}, {42, 45, 4}), 3) << "above its rim, and nearer to it";
  EXPECT_EQ(numbers.At({0, 0}, {20, 20, 5}), 3) << "only one is there";
  EXPECT_EQ(numbers.At({0, 0}, {50, 45, 1}), 3) << "on the boundary of the other from above";
  EXPECT_EQ(numbers.At({0, 0}, {50, 45, 31}), 4);
  EXPECT_EQ(numbers.At({0, 0}, {50.001, 45, 31}), 4);
}

// From above a wall is a line, and its holes lie over each other or beside the line.
TEST(HoleNumbersTest, OfHolesInAWallTheOneAtThatHeight) {
  const HoleNumbers numbers =
      NumbersOf({Feature(3, "+000_+000", "filled", "Polygon",
                         Json::array({{{1000, 2000}, {1009, 2000}, {1009, 2000.002}, {1000, 2000}}})),
                 Feature(4, "+000_+000", "filled", "MultiLineString", {{{1000, 2000.01}, {1009, 2000.01}}})},
                {Row(3, {2, 4}), Row(4, {6, 8})});
  EXPECT_EQ(numbers.At({0, 0}, {5, 0.001, 3}), 3);
  EXPECT_EQ(numbers.At({0, 0}, {5, 0.001, 7}), 4) << "the other one is around it";
  EXPECT_EQ(numbers.At({0, 0}, {5, 0.02, 3}), 3) << "the other one is nearer from above";
}

TEST(HoleNumbersTest, AFillMayLeaveTheHeightsOfItsRim) {
  const HoleNumbers numbers =
      NumbersOf({Feature(3, "+000_+000", "filled", "Polygon", Json::array({Square(0, 0, 20)})),
                 Feature(4, "+000_+000", "filled", "Polygon", Json::array({Square(21, 0, 20)}))},
                {Row(3, {1, 1}), Row(4, {3, 3})});
  EXPECT_EQ(numbers.At({0, 0}, {17, 10, 3}), 3);
  EXPECT_EQ(numbers.At({0, 0}, {24, 10, 1}), 4);
}

TEST(HoleNumbersTest, WaterLiesBelowItsRim) {
  const Json features = {Feature(3, "+000_+000", "filled", "Polygon", Json::array({Square(0, 0, 20)})),
                         Feature(4, "+000_+000", "filled", "Polygon", Json::array({Square(0, 0, 20)}))};
  for (const Json& level : {Json(-7), Json({-6, -8})}) {
    const HoleNumbers numbers = NumbersOf(features, {Row(3, {2, 4}, level), Row(4, {-9, -9})});
    EXPECT_EQ(numbers.At({0, 0}, {1, 10, -7}), 3) << level;
  }
}

// Reports of earlier releases have none, and a boundary of seams alone has none either.
TEST(HoleNumbersTest, WithoutHeightsTheHoleFromAbove) {
  const HoleNumbers numbers =
      NumbersOf({Feature(3, "+000_+000", "filled", "Polygon", Json::array({Square(0, 0, 90)})),
                 Feature(4, "+000_+000", "filled", "Polygon", Json::array({Square(40, 40, 10)}))},
                Json::array({Row(3, Json())}));
  EXPECT_EQ(numbers.At({0, 0}, {10, 10, 500}), 3);
  EXPECT_EQ(numbers.At({0, 0}, {41, 45, 500}), 4);
}

// A hole of which no height is known is at no height for sure.
TEST(HoleNumbersTest, TheHoleOfKnownHeightBeforeOneOfUnknownHeight) {
  for (const int known : {3, 4}) {
    const HoleNumbers numbers =
        NumbersOf({Feature(3, "+000_+000", "filled", "Polygon", Json::array({Square(0, 0, 20)})),
                   Feature(4, "+000_+000", "filled", "Polygon", Json::array({Square(0, 0, 20)}))},
                  Json::array({Row(known, {1, 2}), Row(7 - known, Json())}));
    EXPECT_EQ(numbers.At({0, 0}, {10, 10, 1.5}), known);
    EXPECT_EQ(numbers.At({0, 0}, {10, 10, 5}), known) << "a fill may rise so far";
    EXPECT_EQ(numbers.At({0, 0}, {10, 10, 50}), 7 - known);
  }
}

using Rim = std::vector<std::pair<Point3, Point3>>;

TEST(HoleNumbersTest, OfARimTheHoleWithMostOfItsEdges) {
  const HoleNumbers numbers = NumbersOf({Feature(3, "+000_+000", "filled", "Polygon", Json::array({Square(0, 0, 9)})),
                                         Feature(4, "+000_+000", "filled", "Polygon", Json::array({Square(9, 0, 9)}))});
  const Point3 a(0, 0, 1), b(9, 0.0004, 1), c(18, 0, 2), d(18, 9, 2), e(9, 9, 3);
  EXPECT_EQ(numbers.OfRim({0, 0}, {{a, b}, {d, c}, {e, d}}), 4) << "edges in any direction";
  EXPECT_EQ(numbers.OfRim({0, 0}, {{b, a}}), 3);
  EXPECT_EQ(numbers.OfRim({0, 0}, {{a, c}, {b, d}}), std::nullopt) << "vertices of boundaries, but no edges";
  EXPECT_EQ(numbers.OfRim({0, 0}, {{a, b}, {b, c}}), std::nullopt) << "one of each";
  EXPECT_EQ(numbers.OfRim({1, 0}, {{a, b}}), std::nullopt) << "of another cell";
  EXPECT_EQ(numbers.OfRim({0, 0}, {}), std::nullopt);
}

// From above the edges are the same.
TEST(HoleNumbersTest, OfARimTheHoleAtItsHeight) {
  const HoleNumbers numbers = NumbersOf({Feature(3, "+000_+000", "filled", "Polygon", Json::array({Square(0, 0, 9)})),
                                         Feature(4, "+000_+000", "filled", "Polygon", Json::array({Square(0, 0, 9)}))},
                                        {Row(3, {2, 4}), Row(4, {6, 8})});
  const auto rim = [](double z) { return Rim{{{0, 0, z}, {9, 0, z}}}; };
  EXPECT_EQ(numbers.OfRim({0, 0}, rim(2.5)), 3);
  EXPECT_EQ(numbers.OfRim({0, 0}, rim(8)), 4);
  EXPECT_EQ(numbers.OfRim({0, 0}, rim(5)), std::nullopt);
}

TEST(HoleNumbersTest, OfAsManyEdgesTheSmallerBoundary) {
  const Json three = {{1000, 2000}, {1009, 2000}, {1009, 2009}, {1000, 2000}};
  const HoleNumbers numbers = NumbersOf({Feature(3, "+000_+000", "filled", "Polygon", Json::array({Square(0, 0, 9)})),
                                         Feature(4, "+000_+000", "filled", "Polygon", Json::array({three}))});
  EXPECT_EQ(numbers.OfRim({0, 0}, {{{0, 0, 1}, {9, 0, 1}}, {{9, 0, 1}, {9, 9, 1}}}), 4);
}

TEST(HoleNumbersTest, NoneWithoutBoundaries) {
  EXPECT_EQ(NumbersOf(Json::array()).At({0, 0}, {0, 0, 0}), std::nullopt);
  EXPECT_EQ(NumbersOf(Json::array({Feature(3, "+000_+000", "filled", "Polygon", Json::array({Square(0, 0, 9)}))}))
                .At({1, 0}, {4, 4, 0}),
            std::nullopt);
}

}  // namespace
}  // namespace tilemend
