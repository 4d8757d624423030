#include "worker/fill/hole/fill_failure.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>

namespace tilemend {
namespace {

TEST(FillFailureTest, EveryReasonHasATextOfItsOwn) {
  std::set<std::string> texts;
  for (auto f = static_cast<int>(FillFailure::kNoArea); f <= static_cast<int>(FillFailure::kTooLarge); ++f) {
    const std::string text = TextOf(static_cast<FillFailure>(f), {12});
    EXPECT_FALSE(text.empty()) << f;
    EXPECT_TRUE(texts.insert(text).second) << text;
  }
}

TEST(FillFailureTest, SuccessNeedsNoText) { EXPECT_EQ(TextOf(FillFailure::kNone, {12}), ""); }

TEST(FillFailureTest, TellsHowLongABoundaryIs) {
  EXPECT_THAT(TextOf(FillFailure::kTooLongForSpace, {401}), ::testing::HasSubstr("has 401 boundary"));
}

TEST(FillFailureTest, TellsTheLimitThatAppliesAndOfCellsInScenesAlone) {
  const std::string scene = TextOf(FillFailure::kTooLarge, {12}),
                    mesh = TextOf(FillFailure::kTooLarge, {12, kMaxSingleMeshPoints, false});
  EXPECT_THAT(scene, ::testing::HasSubstr("its cell would have 4 million vertices or more; smaller cells"));
  EXPECT_THAT(mesh, ::testing::HasSubstr("the mesh would have 20 million vertices or more"));
  EXPECT_THAT(mesh, ::testing::Not(::testing::HasSubstr("cell")));
  EXPECT_THAT(TextOf(FillFailure::kTooLarge, {12, 1'500'000}), ::testing::HasSubstr("1500000 vertices or more"));
}

}  // namespace
}  // namespace tilemend
