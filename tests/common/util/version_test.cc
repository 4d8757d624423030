#include "common/util/version.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tilemend {
namespace {

TEST(VersionTest, HasThreeNumbers) { EXPECT_THAT(Version(), ::testing::MatchesRegex("[0-9]+\\.[0-9]+\\.[0-9]+")); }

TEST(BuildIdTest, IsTheLinkersIdOfThisProgram) {
  EXPECT_THAT(BuildId(), ::testing::MatchesRegex("[0-9a-f]+"));
  EXPECT_GE(BuildId().size(), 16U);
  EXPECT_EQ(BuildId(), BuildId());
}

}  // namespace
}  // namespace tilemend
