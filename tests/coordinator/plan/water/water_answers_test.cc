#include "coordinator/plan/water/water_answers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

std::vector<Point2> Box(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

// A plan of holes that are boxes.
class WaterAnswersTest : public ::testing::Test {
 protected:
  PlannedHole& AddHole(HoleKind kind, const std::vector<Point2>& ring, int32_t cluster = -1) {
    const auto base = static_cast<int32_t>(plan_.vertices.size());
    PlannedHole& hole = plan_.holes.emplace_back();
    hole.kind = kind;
    hole.cluster = cluster;
    hole.centre = (ring[0] + ring[2]) / 2;
    for (int32_t i = 0; i < 4; ++i) {
      plan_.vertices.push_back({{0, 0}, i, {ring[i].x(), ring[i].y(), 0}});
      hole.segments.push_back({base + i, base + (i + 1) % 4});
    }
    return hole;
  }
  const std::vector<WaterAnswer>& Answer(std::vector<WaterArea> areas) {
    WaterOptions options;
    options.areas = std::move(areas);
    for (const PlannedHole& hole : plan_.holes) {
      if (hole.water >= std::ssize(plan_.water)) plan_.water.resize(hole.water + 1);
    }
    AnswerWaterAreas(options, plan_);
    return plan_.water_answers;
  }

  Plan plan_;
};

TEST_F(WaterAnswersTest, WithoutAreasThereIsNothingToAnswer) {
  AddHole(HoleKind::kClosed, Box(0, 0, 10, 10)).water = 0;
  EXPECT_THAT(Answer({}), IsEmpty());
}

TEST_F(WaterAnswersTest, AnAreaIsTakenForAllHolesOfTheBody) {
  AddHole(HoleKind::kOpenI, Box(0, 0, 10, 10), 0).water = 0;
  AddHole(HoleKind::kClosed, Box(50, 0, 60, 10));
  AddHole(HoleKind::kOpenI, Box(10, 0, 20, 10), 0).water = 0;
  const auto& answers = Answer({{true, {{Box(-1, -1, 21, 11)}}, {}, {}, "lake"}});
  ASSERT_THAT(answers, SizeIs(1));
  EXPECT_TRUE(answers[0].taken);
  EXPECT_EQ(answers[0].label, "lake");
  EXPECT_THAT(answers[0].holes, ElementsAre(0, 2));
  EXPECT_EQ(answers[0].reason, "");
}

TEST_F(WaterAnswersTest, OnceItIsCancelledThereIsNoAnswer) {
  AddHole(HoleKind::kOpenI, Box(0, 0, 10, 10), 0).water = 0;
  plan_.water.resize(1);
  WaterOptions options;
  options.areas.assign(20, {true, {{Box(-1, -1, 4, 11)}}});
  int asked = 0;
  AnswerWaterAreas(options, plan_, std::nullopt, [&] { return ++asked > 10; });
  EXPECT_THAT(plan_.water_answers, IsEmpty());
  EXPECT_LT(asked, 20);
}

// A canal that is drawn in parts.
TEST_F(WaterAnswersTest, AreasThatSayTheSameAreTakenTogether) {
  PlannedHole& hole = AddHole(HoleKind::kOpenI, Box(0, 0, 30, 10), 0);
  hole.water = 0, hole.area = 300;
  const auto& answers = Answer({{true, {{Box(0, 0, 10, 10)}}, {}, {}, "west"},
                                {true, {{Box(10, 0, 19, 10)}}, {}, {}, "middle"},
                                {true, {{Box(19, 0, 23, 10)}}, {}, {}, "east"}});
  ASSERT_THAT(answers, SizeIs(3));
  for (const WaterAnswer& answer : answers) EXPECT_TRUE(answer.taken) << answer.label << ": " << answer.reason;
  EXPECT_THAT(answers[0].doubt, HasSubstr("m2 of that lie outside it"));
  EXPECT_EQ(answers[1].doubt, "");
}

TEST_F(WaterAnswersTest, AnAreaWithoutWaterIsTakenToo) {
  AddHole(HoleKind::kClosed, Box(0, 0, 10, 10));
  EXPECT_TRUE(Answer({{false, {{Box(-1, -1, 11, 11)}}}})[0].taken);
}

TEST_F(WaterAnswersTest, SaysOfWhatIsNotTakenThatItsSurfaceWent) {
  WaterArea area{true, {{Box(50, 50, 60, 60)}}};
  area.clear = true;
  EXPECT_THAT(Answer({area})[0].reason, Not(HasSubstr("taken out")));
  plan_.water_answers.clear();
  area.cleared_cells = {{0, 0}};
  EXPECT_THAT(Answer({area})[0].reason, HasSubstr("; surface was taken out under it all the same"));
}

TEST_F(WaterAnswersTest, SaysThatWaterFallsUnlessTheUserSaidSo) {
  AddHole(HoleKind::kOpenI, Box(0, 0, 200, 20), 0).water = 0;
  plan_.water.resize(1);
  plan_.water[0].river.stations = {{0, 10, 2}, {200, 10, 1}};
  WaterArea area{true, {{Box(-1, -1, 201, 21)}}};
  EXPECT_THAT(Answer({area})[0].doubt, HasSubstr("its water falls by 1.0"));
  plan_.water_answers.clear();
  area.kind = WaterKind::kRiver;
  EXPECT_EQ(Answer({area})[0].doubt, "");
  plan_.water_answers.clear();
  plan_.water[0].river.stations.clear();
  EXPECT_THAT(Answer({area})[0].doubt, HasSubstr("no fall"));
}

// A decision takes a level, and no "kind".
TEST_F(WaterAnswersTest, AdvisesForADecisionWhatADecisionTakes) {
  AddHole(HoleKind::kOpenI, Box(0, 0, 200, 20), 0).water = 0;
  plan_.water.resize(1);
  WaterArea area{true, {{Box(-1, -1, 201, 21)}}};
  const auto doubt = [&](ReviewDecision decision) {
    plan_.water_answers.clear();
    plan_.decisions.clear();
    if (decision != ReviewDecision::kNone) plan_.decisions[0] = 0;
    area.decision = decision;
    return Answer({area})[0].doubt;
  };
  plan_.water[0].sigma = 1.8;
  EXPECT_THAT(doubt(ReviewDecision::kNone), HasSubstr("level_m sets it, and \"kind\": \"river\" lets it fall"));
  EXPECT_EQ(doubt(ReviewDecision::kWater), "its shore tells the level to 1.8 m only; level_m sets it");
  plan_.water[0].river.stations = {{0, 10, 2}, {200, 10, 1}};
  EXPECT_THAT(doubt(ReviewDecision::kNone), HasSubstr("; \"kind\": \"lake\" makes it level"));
  EXPECT_EQ(doubt(ReviewDecision::kWater), "its water falls by 1.0 m; level_m makes it level");
}

TEST_F(WaterAnswersTest, DoubtsWaterThatWasClearedFromSurfaceThatIsNotLevel) {
  AddHole(HoleKind::kOpenI, Box(0, 0, 10, 10), 0).water = 0;
  plan_.water.resize(1);
  WaterArea area{true, {{Box(-1, -1, 11, 11)}}, 45};
  area.clear = true;
  for (const double sigma : {1.4, 21.5}) {
    area.level_sigma = sigma;
    plan_.water_answers.clear();
    EXPECT_EQ(Answer({area})[0].doubt.starts_with("the surface in it is not level: it lies 21.5 m off"), sigma > 1.5);
  }
}

TEST_F(WaterAnswersTest, DoubtsALevelOfNoWater) {
  AddHole(HoleKind::kClosed, Box(0, 0, 10, 10));
  EXPECT_THAT(Answer({{false, {{Box(-1, -1, 11, 11)}}, 3.5, {}, ""}})[0].doubt, HasSubstr("level_m has no effect"));
}

TEST_F(WaterAnswersTest, SaysWhatIsMissing) {
  AddHole(HoleKind::kClosed, Box(0, 0, 10, 10));  // of a wall: no water though an area says so
  AddHole(HoleKind::kClosed, Box(20, 0, 30, 10)).failure = "its boundary crosses itself";
  AddHole(HoleKind::kOpenI, Box(40, 0, 50, 10), 0);
  AddHole(HoleKind::kOpenI, Box(60, 0, 70, 10), 1).water = 0;
  const auto& answers = Answer({{true, {{Box(0, 0, 10, 10)}}},
                                {true, {{Box(20, 0, 30, 10)}}},
                                {true, {{Box(40, 0, 50, 10)}}},
                                {true, {{Box(60, 0, 63, 10)}}},
                                {true, {{Box(80, 0, 90, 10)}}}});
  const std::vector<std::string> reasons = {"no hole that faces up", "is left: its boundary crosses itself",
                                            "has no shore", "covers 30 % of hole 3 at (65, 5)",
                                            "no hole lies under it"};
  ASSERT_THAT(answers, SizeIs(reasons.size()));
  for (size_t i = 0; i < reasons.size(); ++i) {
    EXPECT_FALSE(answers[i].taken) << i;
    EXPECT_THAT(answers[i].holes, IsEmpty()) << i;
    EXPECT_THAT(answers[i].reason, HasSubstr(reasons[i])) << i;
  }
}

TEST_F(WaterAnswersTest, WhereThereIsNoHoleTheWaterMayBeThereAsSurface) {
  AddHole(HoleKind::kClosed, Box(0, 0, 10, 10));  // of a wall
  AddHole(HoleKind::kOpenI, Box(60, 0, 70, 10), 1).water = 0;
  std::vector<WaterArea> areas = {{true, {{Box(0, 0, 10, 10)}}},
                                  {true, {{Box(80, 0, 90, 10)}}},
                                  {true, {{Box(60, 0, 63, 10)}}},
                                  {false, {{Box(80, 0, 90, 10)}}},
                                  {true, {{Box(80, 0, 90, 10)}}}};
  areas[4].clear = true;
  const auto& answers = Answer(areas);
  for (size_t i = 0; i < areas.size(); ++i) {
    EXPECT_EQ(answers[i].reason.find("add \"clear\": true") != std::string::npos, i < 2) << i << answers[i].reason;
  }
}

TEST_F(WaterAnswersTest, SaysThatAnAreaLiesOutsideTheScene) {
  PlanInput input;
  input.grid.cell_size = Point2(50, 50);
  for (const CellId cell : {CellId{0, 0}, CellId{1, 0}}) input.cells[cell] = nullptr;
  WaterOptions options;
  options.areas = {{true, {{Box(140000, 0, 140010, 10)}}}, {true, {{Box(80, 0, 140000, 10)}}}};
  AnswerWaterAreas(options, plan_, BoundsOfCells(input));
  ASSERT_THAT(plan_.water_answers, SizeIs(2));
  EXPECT_EQ(plan_.water_answers[0].reason, "it lies outside the scene; are its coordinates those of this scene?");
  EXPECT_THAT(plan_.water_answers[1].reason, HasSubstr("no hole lies under it. If"));
  input.has_grid = false;
  EXPECT_FALSE(BoundsOfCells(input).has_value());
}

TEST_F(WaterAnswersTest, ADecisionOverNoHoleIsNoPolygonOfWater) {
  AddHole(HoleKind::kOpenI, Box(60, 0, 70, 10)).water = 0;
  std::vector<WaterArea> areas = {{true, {{Box(80, 0, 90, 10)}}}, {true, {{Box(60, 0, 63, 10)}}}};
  for (WaterArea& area : areas) area.decision = ReviewDecision::kWater;
  const auto& answers = Answer(areas);
  EXPECT_EQ(answers[0].reason, "no hole lies under it");
  EXPECT_FALSE(answers[0].is_over_hole);
  EXPECT_FALSE(answers[1].taken);
  EXPECT_TRUE(answers[1].is_over_hole);
}

// A decision that covers 5 % of one hole and 80 % of another, which it decides on.
TEST_F(WaterAnswersTest, ADecisionIsNotDoubtedForAHoleThatItHardlyCovers) {
  for (const int32_t decided : {0, 1}) {
    plan_ = {};
    for (const int32_t h : {0, 1}) {
      if (h == decided)
        AddHole(HoleKind::kClosed, Box(100, 0, 110, 10)).area = 100;
      else
        AddHole(HoleKind::kClosed, Box(0, 0, 100, 10)).area = 1000;
    }
    plan_.decisions[decided] = 0;
    WaterArea area{false, {{Box(95, -20, 108, 10)}}};  // most of it lies in neither
    area.decision = ReviewDecision::kAccept;
    const auto& answers = Answer({area});
    EXPECT_THAT(answers[0].holes, ElementsAre(decided));
    EXPECT_EQ(answers[0].reason, "");
    EXPECT_THAT(answers[0].doubt, Not(HasSubstr("it covers 5 %"))) << decided;
  }
}

// A decision that covers half of a small hole and 5 % of a large one is on neither.
TEST_F(WaterAnswersTest, ADecisionSaysOfEachHoleThatItCoversWhyItIsNotTaken) {
  for (const bool is_small_first : {false, true}) {
    plan_ = {};
    for (const bool is_small : {is_small_first, !is_small_first}) {
      if (is_small)
        AddHole(HoleKind::kClosed, Box(-20, 0, -10, 10)).area = 100;
      else
        AddHole(HoleKind::kClosed, Box(0, 0, 1000, 1000)).area = 1e6;
    }
    WaterArea area{false, {{Box(-15, 0, 50, 1000)}}};
    area.decision = ReviewDecision::kAccept;
    const auto& answers = Answer({area});
    EXPECT_FALSE(answers[0].taken);
    EXPECT_THAT(answers[0].reason,
                HasSubstr("it covers 5 % of hole " + std::to_string(is_small_first ? 1 : 0) + " at (500, 500)"));
    EXPECT_THAT(answers[0].doubt,
                HasSubstr("it covers 50 % of hole " + std::to_string(is_small_first ? 0 : 1) + " at (-15, 5)"));
  }
}

TEST_F(WaterAnswersTest, ASmallHoleDoesNotHideALargeOneThatIsNotTaken) {
  PlannedHole& pond = AddHole(HoleKind::kClosed, Box(0, 0, 1, 1));
  pond.water = 0;
  pond.area = 1;
  AddHole(HoleKind::kOpenI, Box(2, 0, 12, 10), 0).area = 100;
  const auto& answers = Answer({{true, {{Box(0, 0, 6, 10)}}}});
  EXPECT_TRUE(answers[0].taken);
  EXPECT_THAT(answers[0].holes, ElementsAre(0));
  EXPECT_THAT(answers[0].reason, HasSubstr("covers 40 % of hole 1 at"));
}

TEST_F(WaterAnswersTest, DoubtsWaterThatReachesFarBeyondTheArea) {
  for (const double width : {6.0, 9.5}) {
    plan_ = {};
    PlannedHole& lake = AddHole(HoleKind::kOpenI, Box(0, 0, 10, 10), 0);
    lake.water = 0;
    lake.area = 100;
    const std::string doubt = Answer({{true, {{Box(0, 0, width, 10)}}}})[0].doubt;
    EXPECT_EQ(doubt,
              width > 9 ? "" : "it makes 100 m2 water, and 40 m2 of that lie outside it, as the hole goes on there");
  }
}

TEST_F(WaterAnswersTest, TheLastAreaOverAHoleDecides) {
  AddHole(HoleKind::kOpenI, Box(0, 0, 10, 10), 0).water = 0;
  const auto& answers =
      Answer({{false, {{Box(0, 0, 10, 10)}}, {}, {}, "dry"}, {true, {{Box(0, 0, 10, 9)}}, {}, {}, "wet"}});
  EXPECT_FALSE(answers[0].taken);
  EXPECT_EQ(answers[0].reason, "another after it decides on the same hole: wet");
  EXPECT_TRUE(answers[1].taken);
}

TEST_F(WaterAnswersTest, DoubtsACentrelineThatDoesNotRunAlongTheWater) {
  AddHole(HoleKind::kOpenI, Box(0, 0, 200, 20), 0).water = 0;
  AddHole(HoleKind::kOpenI, Box(220, 0, 420, 20), 1).water = 0;
  AddHole(HoleKind::kClosed, Box(100, 21, 102, 22)).water = 1;
  plan_.water.resize(2);
  plan_.water[0].river.stations = {{0, 10, 2}, {420, 10, 1}};
  const std::pair<std::vector<Point2>, std::string> cases[] = {{{{5, 10}, {415, 10}}, ""},
                                                               {{{-300, 10}, {230, 10}}, ""},
                                                               {{{100, -400}, {100, 400}}, "runs along 25 m of 4"},
                                                               {{{20, 10}, {120, 10}}, "runs along 100 m of 4"}};
  for (const auto& [line, words] : cases) {
    plan_.water_answers.clear();
    const auto& answers = Answer({{true, {{Box(-2, -1, 422, 23)}}, {}, line}});
    EXPECT_THAT(answers[0].doubt, HasSubstr(words));
    EXPECT_EQ(answers[0].doubt.empty(), words.empty());
  }
}

TEST_F(WaterAnswersTest, DoubtsACentrelineThatTurnsBack) {
  AddHole(HoleKind::kOpenI, Box(0, 0, 200, 20), 0).water = 0;
  plan_.water.resize(1);
  plan_.water[0].river.stations = {{0, 10, 2}, {200, 10, 1}};
  const auto& answers = Answer({{true, {{Box(-2, -1, 202, 23)}}, {}, {{5, 10}, {195, 10}, {5, 10}}}});
  EXPECT_EQ(answers[0].doubt, "its centreline turns back at (195, 10)");
}

TEST_F(WaterAnswersTest, SaysWhatWaterACentrelineDoesNotRunThrough) {
  for (const double area : {3000.0, 400.0}) {
    plan_ = {};
    PlannedHole& river = AddHole(HoleKind::kOpenI, Box(0, 0, 200, 20), 0);
    river.water = 0;
    river.area = 4000;
    PlannedHole& lake = AddHole(HoleKind::kOpenI, Box(0, 40, 50, 100), 1);
    lake.water = 1;
    lake.area = area;
    plan_.water.resize(2);
    plan_.water[0].river.stations = {{0, 10, 2}, {200, 10, 1}};
    const auto& answers = Answer({{true, {{Box(-2, -1, 202, 102)}}, {}, {{5, 10}, {195, 10}}}});
    EXPECT_EQ(answers[0].doubt, area < 1000 ? ""
                                            : "its centreline does not run through 3000 m2 of its water, which have a "
                                              "level of their own, at (25, 70)");
  }
}

TEST_F(WaterAnswersTest, SaysWhereACentrelineMakesNoRiver) {
  AddHole(HoleKind::kOpenI, Box(0, 0, 200, 20), 0).water = 0;
  plan_.water.resize(1);
  EXPECT_THAT(Answer({{true, {{Box(-2, -1, 202, 23)}}, {}, {{5, 10}, {195, 10}}}})[0].doubt,
              HasSubstr("no level of the shore is known along its centreline"));
}

TEST_F(WaterAnswersTest, DoubtsALevelFarFromTheShore) {
  for (const auto& [level, word] :
       {std::pair(2.5, ""), {12.0, "9.5 m above its shore"}, {-3.0, "5.5 m below its shore"}, {3.0, ""}}) {
    plan_ = {};
    AddHole(HoleKind::kClosed, Box(0, 0, 10, 10)).water = 0;
    plan_.water.emplace_back();
    plan_.water[0].level = level;
    plan_.water[0].shore_level = 2.5;
    const auto& answers = Answer({{true, {{Box(-1, -1, 21, 11)}}, level, {}, "lake"}});
    EXPECT_TRUE(answers[0].taken);
    EXPECT_THAT(answers[0].doubt, HasSubstr(word));
    EXPECT_EQ(answers[0].doubt.empty(), std::string(word).empty());
  }
}

}  // namespace
}  // namespace tilemend
