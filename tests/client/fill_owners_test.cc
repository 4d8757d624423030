#include "client/fill_owners.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
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

// The vertex in the middle of the fill is moved beyond its rim: one of its triangles faces down.
TEST_F(FillOwnersTest, ATriangleOfAHeightFieldThatFacesDownIsFolded) {
  FillOwners sound(numbers_, {0, 0}, mesh_, added_);
  EXPECT_THAT(sound.FoldedTriangles({0}), IsEmpty());
  mesh_.points[4].y() = -5;
  FillOwners owners(numbers_, {0, 0}, mesh_, added_);
  EXPECT_THAT(owners.FoldedTriangles({0, 16}), ElementsAre(1));
  EXPECT_THAT(owners.FoldedTriangles({16}), IsEmpty()) << "its hole may be filled in any way";
  std::vector<bool> original(mesh_.triangles.size(), false);
  EXPECT_THAT(FillOwners(numbers_, {0, 0}, mesh_, original).FoldedTriangles({0}), IsEmpty());
}

// Hole 16 has an edge of the same rim, as fills of two holes may be connected.
TEST_F(FillOwnersTest, AFillOfSeveralHolesIsAHeightFieldIfAllAre) {
  mesh_.points[4].y() = -5;
  mesh_.triangles[5] = {1, 0, 5};
  const HoleNumbers numbers =
      NumbersOfHoles({Feature(0, {{0, 0}, {20, 0}, {20, 20}, {0, 20}, {0, 0}}), Feature(16, {{0, 0}, {8, 9}, {20, 0}})},
                     Json::array());
  FillOwners owners(numbers, {0, 0}, mesh_, added_);
  EXPECT_THAT(owners.FoldedTriangles({0}), IsEmpty());
  EXPECT_THAT(owners.FoldedTriangles({0, 16}), testing::Contains(1));
}

TEST(ReportedOutputTest, HeightFieldsAreFillsOverTheGroundWithoutFoldsAndWalls) {
  Json report = {{"per_hole",
                  {{{"id", 0}, {"outcome", "filled"}, {"kind", "I"}, {"method", "over the ground"}},
                   {{"id", 1}, {"outcome", "filled"}, {"kind", "I"}, {"method", "over the ground, folds cut off"}},
                   {{"id", 2}, {"outcome", "filled"}, {"kind", "closed"}, {"method", "water"}},
                   {{"id", 3}, {"outcome", "filled"}, {"kind", "I"}, {"method", "water"}, {"folds_cut", true}},
                   {{"id", 4}, {"outcome", "left"}, {"kind", "I"}},
                   {{"id", 5}, {"outcome", "filled"}, {"kind", "closed"}, {"method", "unrolled"}}}}};
  EXPECT_THAT(ReadReported(report).height_fields, ElementsAre(0, 2));
  report["borders"] = {{"inexact", {{{"margins_m", {0.1, 0.1}}}}}};
  EXPECT_THAT(ReadReported(report).height_fields, ElementsAre(2)) << "open holes have walls where tiles overlap";
}

TEST_F(FillOwnersTest, NamesTheOtherHoleOfACrossing) {
  FillOwners owners(numbers_, {0, 0}, mesh_, added_);
  EXPECT_EQ(owners.CrossedText({{11, 9.5, 5}, 1, {2, 5}}), "crosses the fill of hole 16");
  EXPECT_EQ(owners.CrossedText({{11, 9.5, 5}, 5, {1}}), "crosses the fill of hole 0");
  EXPECT_EQ(owners.CrossedText({{11, 9.5, 5}, 1, {2, 3}}), "") << "the fill crosses itself";
}

}  // namespace
}  // namespace tilemend
