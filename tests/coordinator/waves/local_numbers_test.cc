#include "coordinator/waves/local_numbers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tilemend {
namespace {

using ::testing::ElementsAre;

RimVertex SeamVertex(int32_t number) {
  RimVertex v;
  v.seam_vertex = number;
  return v;
}

CellHoles Holes(int32_t shift) {
  CellHoles holes;
  for (const int32_t id : {17, 9, 17}) holes.holes.push_back({.id = id + shift});
  for (const int32_t vertex : {30, 12, 30}) holes.vertices.push_back(SeamVertex(vertex + shift));
  holes.vertices.push_back(SeamVertex(-1));
  return holes;
}

TEST(LocaliseTest, NumbersFromZeroInTheSameOrder) {
  CellHoles holes = Holes(0);
  const LocalNumbers numbers = Localise(holes);
  EXPECT_THAT(numbers.holes, ElementsAre(9, 17));
  EXPECT_THAT(numbers.seam_vertices, ElementsAre(12, 30));
  std::vector<int32_t> ids, vertices;
  for (const CellHole& hole : holes.holes) ids.push_back(hole.id);
  for (const RimVertex& v : holes.vertices) vertices.push_back(v.seam_vertex);
  EXPECT_THAT(ids, ElementsAre(1, 0, 1)) << "one hole may lie there in several regions";
  EXPECT_THAT(vertices, ElementsAre(1, 0, 1, -1));
}

TEST(LocaliseTest, ForgetsAShiftOfThePlan) {
  CellHoles first = Holes(0), second = Holes(1000);
  Localise(first);
  Localise(second);
  for (size_t i = 0; i < 3; ++i) EXPECT_EQ(first.holes[i].id, second.holes[i].id);
  for (size_t i = 0; i < 4; ++i) EXPECT_EQ(first.vertices[i].seam_vertex, second.vertices[i].seam_vertex);
}

TEST(InPlanTest, IsTheOtherWay) {
  const std::vector<int32_t> numbers = {9, 17};
  EXPECT_EQ(InPlan(numbers, 1), 17);
  EXPECT_EQ(LocalNumber(numbers, 17), 1);
  EXPECT_EQ(InPlan(numbers, 2), std::nullopt);
  EXPECT_EQ(InPlan(numbers, -1), std::nullopt);
}

}  // namespace
}  // namespace tilemend
