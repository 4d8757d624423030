#include "tests/support/scene_layout.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "coordinator/plan/plan.h"
#include "tests/support/surveyed_scene.h"

namespace tilemend {
namespace {

// A lake over a corner, a disc at the rim of the area, a river that ends at the sides of its cell, and closed holes.
constexpr char kLayout[] = R"({"cols": 3, "rows": 2, "closed": 4, "relief": 6, "holes": [
  {"kind": "box", "at": [0.6, 0.6, 1.4, 1.4]},
  {"kind": "disc", "at": [3.0, 1.5, 0.2, 0.17]},
  {"kind": "strip", "only_cell": [2, 0], "through": [[1.9, 0.5], [3.1, 0.5]], "half_width": 0.1}]})";

SceneMakerOptions OptionsOf(const std::string& layout, uint64_t seed) {
  SceneMakerOptions options;
  options.spacing = 1.25;
  options.seed = seed;
  EXPECT_TRUE(ApplyLayout(layout, "layout", &options).ok());
  return options;
}

void ExpectCounts(const SceneMakerOptions& options) {
  const SurveyedScene scene = SurveyScene(MakeScene(options));
  EXPECT_EQ(CountsOf(MakePlan(scene.Input(), {})), "4 closed, 4 IB, 1 IIB, 1 IIC")
      << "seed " << options.seed << ", margin " << options.margin << ", pieces " << options.pieces;
}

TEST(ApplyLayoutTest, GivesTheSameCountsOnEveryCutForAnySeed) {
  for (const uint64_t seed : {1, 2, 3}) {
    SceneMakerOptions options = OptionsOf(kLayout, seed);
    for (const Cut cut : {Cut::kClipped, Cut::kRagged, Cut::kOverlap}) {
      options.cut = cut;
      ExpectCounts(options);
    }
  }
}

TEST(ApplyLayoutTest, GivesTheSameCountsWithAnyMarginAndInPieces) {
  SceneMakerOptions options = OptionsOf(kLayout, 4);
  options.cut = Cut::kOverlap;
  options.noise = 0.1;
  for (const int32_t pieces : {1, 2, 3}) {
    for (const double margin : {0.02, 0.25}) {
      options.pieces = pieces;
      options.margin = margin;
      ExpectCounts(options);
    }
  }
}

TEST(ApplyLayoutTest, LeavesCellsOutOfTheArea) {
  const auto options = OptionsOf(R"({"cols": 2, "rows": 1, "holes": [], "out_of_area": [[1, 0]]})", 1);
  EXPECT_EQ(MakeScene(options).tiles.size(), 1u);
}

TEST(ApplyLayoutTest, RefusesWhatIsNoLayout) {
  for (const char* text :
       {"{", "[]", R"({"cols": 1, "rows": 1})", R"({"cols": 1, "rows": 1, "holes": [{"kind": "star"}]})",
        R"({"cols": 1, "rows": 1, "holes": [{"kind": "cone", "at": [0, 0, 1, 1]}]})",
        R"({"cols": 1, "rows": 1, "holes": [{"kind": "box", "at": [0, 0]}]})",
        R"({"cols": 1, "rows": 1, "holes": [{"kind": "strip", "through": [], "half_width": 1}]})"}) {
    SceneMakerOptions options;
    EXPECT_FALSE(ApplyLayout(text, "x.json", &options).ok()) << text;
  }
}

}  // namespace
}  // namespace tilemend
