#include "coordinator/plan/colour/hole_colours.h"

#include <gtest/gtest.h>

#include "tests/support/plan_checks.h"

namespace tilemend {
namespace {

// Gives every boundary vertex of the scene the colour that `colour` says for its position.
template <class Colour>
void Paint(SurveyedScene& scene, Colour colour) {
  for (auto& [cell, record] : scene.records) {
    for (const BoundaryVertex& v : record.vertices) record.colours.push_back(colour(v.position));
  }
}

// A lake of 4 x 2 squares over the border of two cells; cells have 4 x 4 squares.
SurveyedScene Lake() {
  return PictureScene({"########", "########", "##....##", "##....##", "########", "########", "########", "########"},
                      4);
}

TEST(ColourHolesTest, AClusterHasOneColourOverAllItsCells) {
  SurveyedScene scene = Lake();
  // Most of the rim is grey; the rest are trees and broken texels.
  Paint(scene, [](const Point3& p) -> std::optional<Rgb> {
    if (p.x() > 5.5) return Rgb{0, 255, 0};
    return Rgb{100, 110, 120};
  });
  const Plan plan = PlanOf(scene);
  ASSERT_GE(plan.holes.size(), 2U);
  const std::vector<FillColour> colours = ColourHoles(plan, scene.Input(), {});
  ASSERT_EQ(colours.size(), plan.holes.size());
  for (const FillColour& c : colours) {
    EXPECT_EQ(c.colour, (Rgb{100, 110, 120}));
    EXPECT_EQ(c.group, 0);
    EXPECT_TRUE(c.known);
  }
}

TEST(ColourHolesTest, WhatStandsAtTheRimCountsOnlyIfThereIsNothingElse) {
  SurveyedScene scene = Lake();
  Paint(scene, [](const Point3& p) -> std::optional<Rgb> { return p.x() > 2.5 ? Rgb{0, 90, 0} : Rgb{100, 110, 120}; });
  Plan plan = PlanOf(scene);
  EXPECT_EQ(ColourHoles(plan, scene.Input(), {})[0].colour, (Rgb{0, 90, 0})) << "most of the rim";
  for (PlanVertex& v : plan.vertices) v.on_object = v.position.x() > 2.5;
  EXPECT_EQ(ColourHoles(plan, scene.Input(), {})[0].colour, (Rgb{100, 110, 120}));
  for (PlanVertex& v : plan.vertices) v.on_object = true;
  EXPECT_EQ(ColourHoles(plan, scene.Input(), {})[0].colour, (Rgb{0, 90, 0}));
}

TEST(ColourHolesTest, WithoutColoursThereIsOneForGroundAndOneForWater) {
  const SurveyedScene scene = Lake();
  Plan plan = PlanOf(scene);
  for (PlannedHole& hole : plan.holes) hole.water = -1;
  EXPECT_EQ(ColourHoles(plan, scene.Input(), {})[0].colour, kGroundColour);
  EXPECT_FALSE(ColourHoles(plan, scene.Input(), {})[0].known);
  plan.water.resize(1);
  for (PlannedHole& hole : plan.holes) hole.water = 0;
  EXPECT_EQ(ColourHoles(plan, scene.Input(), {})[0].colour, kWaterColour);
}

TEST(ColourHolesTest, TheChosenColourIsForWaterAlone) {
  SurveyedScene scene = Lake();
  Paint(scene, [](const Point3&) -> std::optional<Rgb> { return Rgb{9, 9, 9}; });
  Plan plan = PlanOf(scene);
  plan.water.resize(1);
  for (PlannedHole& hole : plan.holes) hole.water = 0;
  EXPECT_EQ(ColourHoles(plan, scene.Input(), Rgb{1, 2, 3})[0].colour, (Rgb{1, 2, 3}));
  for (PlannedHole& hole : plan.holes) hole.water = -1;
  EXPECT_EQ(ColourHoles(plan, scene.Input(), Rgb{1, 2, 3})[0].colour, (Rgb{9, 9, 9}));
}

TEST(ColourHolesTest, LevelGroundHasTheColourOfGround) {
  const SurveyedScene scene = Lake();
  Plan plan = PlanOf(scene);
  plan.water.resize(1);
  plan.water[0].kind = BodyKind::kLevelGround;
  for (PlannedHole& hole : plan.holes) hole.water = 0;
  EXPECT_EQ(ColourHoles(plan, scene.Input(), Rgb{1, 2, 3})[0].colour, kGroundColour);
}

TEST(ColourHolesTest, HolesOfOneBodyOfWaterShareTheirColour) {
  const SurveyedScene scene = Lake();
  Plan plan = PlanOf(scene);
  plan.water.resize(1);
  for (size_t h = 0; h < plan.holes.size(); ++h) {
    plan.holes[h].water = 0;
    plan.holes[h].cluster = static_cast<int32_t>(h);
  }
  for (const FillColour& c : ColourHoles(plan, scene.Input(), {})) EXPECT_EQ(c.group, 0);
  for (PlannedHole& hole : plan.holes) hole.water = hole.cluster = -1;
  const std::vector<FillColour> apart = ColourHoles(plan, scene.Input(), {});
  for (size_t h = 0; h < apart.size(); ++h) EXPECT_EQ(apart[h].group, static_cast<int32_t>(h));
}

TEST(ColourHolesTest, VerticesWithoutAColourDoNotCount) {
  SurveyedScene scene = Lake();
  bool first = true;
  Paint(scene, [&](const Point3& p) -> std::optional<Rgb> {
    const bool at_hole = p.x() > 1.5 && p.x() < 6.5 && p.y() > 3.5 && p.y() < 6.5;
    if (!at_hole || !first) return std::nullopt;
    first = false;
    return Rgb{50, 60, 70};
  });
  EXPECT_EQ(ColourHoles(PlanOf(scene), scene.Input(), {})[0].colour, (Rgb{50, 60, 70}));
}

}  // namespace
}  // namespace tilemend
