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

HoleNumbers NumbersOf(const Json& features) {
  ReportedOutput reported;
  AddRims({{"features", features}}, {1000, 2000}, reported);
  return HoleNumbers(reported);
}

TEST(HoleNumbersTest, TheHoleAroundAPlace) {
  // Hole 3 has an island, and there the hole 4.
  const HoleNumbers numbers =
      NumbersOf({Feature(3, "+000_+015", "filled", "Polygon", {Square(0, 0, 90), Square(40, 40, 10)}),
                 Feature(4, "+000_+015", "filled", "Polygon", Json::array({Square(42, 42, 2)})),
                 Feature(5, "+001_+015", "filled", "MultiPolygon", Json::array({Json::array({Square(100, 0, 5)})}))});
  EXPECT_EQ(numbers.At({0, 15}, {20, 44}), 3);
  EXPECT_EQ(numbers.At({0, 15}, {39, 43}), 3);
  EXPECT_EQ(numbers.At({0, 15}, {43, 43}), 4);
  EXPECT_EQ(numbers.At({1, 15}, {103, 3}), 5);
}

TEST(HoleNumbersTest, TheNearestBoundaryIfNoneIsAround) {
  const HoleNumbers numbers =
      NumbersOf({Feature(3, "+000_+000", "filled", "Polygon", Json::array({Square(0, 0, 9)})),
                 Feature(4, "+000_+000", "filled", "MultiLineString", {{{1020, 2000}, {1020, 2009}}}),
                 Feature(5, "+000_+000", "left", "Polygon", Json::array({Square(17, 0, 2)}))});
  EXPECT_EQ(numbers.At({0, 0}, {10, 5}), 3);
  EXPECT_EQ(numbers.At({0, 0}, {18, 5}), 4);
}

TEST(HoleNumbersTest, NoneWithoutBoundaries) {
  EXPECT_EQ(NumbersOf(Json::array()).At({0, 0}, {0, 0}), std::nullopt);
  EXPECT_EQ(NumbersOf(Json::array({Feature(3, "+000_+000", "filled", "Polygon", Json::array({Square(0, 0, 9)}))}))
                .At({1, 0}, {4, 4}),
            std::nullopt);
}

}  // namespace
}  // namespace tilemend
