#include "client/fill_owners.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

Json Feature(int hole, const Json& ring) {
  return {{"properties", {{"hole", hole}, {"cell", "+000_+000"}, {"outcome", "filled"}}},
          {"geometry", {{"type", "Polygon"}, {"coordinates", Json::array({ring})}}}};
}

HoleNumbers NumbersOfHoles(const Json& features, const Json& holes) {
  ReportedOutput reported = ReadReported({{"per_hole", holes}});
  AddRims({{"features", features}}, {0, 0}, reported);
  return HoleNumbers(reported);
}

// Hole 0 lies in the ground and reaches up a wall to 18 m. Hole 16 is a small one in the wall. A triangle of the fill
// of hole 0 lies inside hole 16 from above, and at its height.
class FillOwnersTest : public ::testing::Test {
 protected:
  FillOwnersTest()
      : numbers_(
            NumbersOfHoles({Feature(0, {{0, 0}, {20, 0}, {20, 20}, {0, 20}, {0, 0}}),
                            Feature(16, {{8, 9}, {12, 9}, {12, 11}, {8, 9}})},
                           {{{"id", 0}, {"outcome", "filled"}, {"rim_heights_m", {3, 18}}, {"level_m", Json()}},
                            {{"id", 16}, {"outcome", "filled"}, {"rim_heights_m", {4, 6}}, {"level_m", Json()}}})) {
    mesh_.points = {{0, 0, 3},      {20, 0, 3}, {20, 20, 18}, {0, 20, 3.0004}, {11, 9.5, 5},
                    {8, 9.0004, 4}, {12, 9, 5}, {12, 11, 6},  {30, 0, 3},      {30, 20, 3}};
    mesh_.triangles = {{8, 9, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {5, 6, 7}};
    added_ = {false, true, true, true, true, true};
  }

  HoleNumbers numbers_;
  TriMesh mesh_;
  std::vector<bool> added_;
};

TEST_F(FillOwnersTest, TheHoleOfATriangleIsThatOfItsFillsRim) {
  FillOwners owners(numbers_, {0, 0}, mesh_, added_);
  EXPECT_EQ(numbers_.At({0, 0}, {11, 9.8, 5}), 16) << "the place alone tells nothing of the fill";
  for (const int32_t t : {1, 2, 3, 4}) EXPECT_EQ(owners.Of(t), 0) << t;
  EXPECT_EQ(owners.Of(5), 16);
}

TEST_F(FillOwnersTest, NoneForAnOriginalTriangleOrAnUnknownBoundary) {
  FillOwners owners(numbers_, {0, 0}, mesh_, added_);
  EXPECT_EQ(owners.Of(-1), std::nullopt);
  EXPECT_EQ(owners.Of(0), std::nullopt);
  FillOwners elsewhere(numbers_, {1, 0}, mesh_, added_);
  EXPECT_EQ(elsewhere.Of(1), std::nullopt);
  EXPECT_EQ(elsewhere.CrossedText({{11, 9.5, 5}, 1, {5}}), "");
}

TEST_F(FillOwnersTest, NamesTheOtherHoleOfACrossing) {
  FillOwners owners(numbers_, {0, 0}, mesh_, added_);
  EXPECT_EQ(owners.CrossedText({{11, 9.5, 5}, 1, {2, 5}}), "crosses the fill of hole 16");
  EXPECT_EQ(owners.CrossedText({{11, 9.5, 5}, 5, {1}}), "crosses the fill of hole 0");
  EXPECT_EQ(owners.CrossedText({{11, 9.5, 5}, 1, {2, 3}}), "") << "the fill crosses itself";
}

}  // namespace
}  // namespace tilemend
