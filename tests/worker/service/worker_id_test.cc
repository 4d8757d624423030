#include "worker/service/worker_id.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tilemend {
namespace {

using ::testing::MatchesRegex;

TEST(NewWorkerIdTest, NamesHostAndProcessAndIsNew) {
  EXPECT_THAT(NewWorkerId(), MatchesRegex(".+-[0-9]+-[0-9a-f]+"));
  EXPECT_NE(NewWorkerId(), NewWorkerId());
}

TEST(NewSecretTest, IsLongAndNew) {
  EXPECT_THAT(NewSecret(), MatchesRegex("[0-9a-f]+"));
  EXPECT_EQ(NewSecret().size(), 32u);
  EXPECT_NE(NewSecret(), NewSecret());
}

}  // namespace
}  // namespace tilemend
