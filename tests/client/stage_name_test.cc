#include "client/stage_name.h"

#include <gtest/gtest.h>

namespace tilemend {
namespace {

TEST(StageNameTest, PhasesAreInWordsOfTheUser) {
  EXPECT_EQ(StageName("survey"), "look at the tiles");
  EXPECT_EQ(StageName("sample clusters and fill"), "fit the surface");
  EXPECT_EQ(StageName("fill layer 1 of 2"), "fill the holes");
}

TEST(StageNameTest, APhaseOfAnotherReleaseIsShownAsItIs) { EXPECT_EQ(StageName("a new phase"), "a new phase"); }

}  // namespace
}  // namespace tilemend
