#include "common/util/failpoint.h"

#include <gtest/gtest.h>

#include <csignal>

namespace tilemend {
namespace {

class FailPointTest : public ::testing::Test {
 protected:
  ~FailPointTest() override { EXPECT_TRUE(ArmFailPoint("").ok()); }
};

TEST_F(FailPointTest, DoesNothingUntilItIsArmed) { EXPECT_FALSE(FailPoint("a.place")); }

TEST_F(FailPointTest, FailsFromTheGivenTimeOn) {
  ASSERT_TRUE(ArmFailPoint("a.place:2:error").ok());
  EXPECT_FALSE(FailPoint("another"));
  EXPECT_FALSE(FailPoint("a.place"));
  EXPECT_FALSE(FailPoint("another"));
  EXPECT_TRUE(FailPoint("a.place"));
  EXPECT_TRUE(FailPoint("a.place"));
}

TEST_F(FailPointTest, KillsTheProcessTheGivenTime) {
  const auto pass = [] {
    if (!ArmFailPoint("a.place:3").ok()) return;
    for (int i = 0; i < 3; ++i) FailPoint("a.place");
  };
  EXPECT_EXIT(pass(), ::testing::KilledBySignal(SIGKILL), "");
}

TEST_F(FailPointTest, RefusesWhatItDoesNotUnderstand) {
  for (const char* spec :
       {"a.place", "a.place:", "a.place:0", "a.place:x", ":1", "a.place:1:", "a.place:1:end", "a:1:error:"})
    EXPECT_TRUE(absl::IsInvalidArgument(ArmFailPoint(spec))) << spec;
  EXPECT_FALSE(FailPoint("a.place"));
}

}  // namespace
}  // namespace tilemend
