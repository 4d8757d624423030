#include "coordinator/state/given_results.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(GivenResultsTest, RevokesAllThatOneWorkerGave) {
  GivenResults given;
  given.Put(2, "liar");
  given.Put(1, "good");
  given.Put(7, "liar");
  EXPECT_THAT(given.Revoke("nobody"), IsEmpty());
  EXPECT_THAT(given.Revoke("liar"), ElementsAre(2, 7));
  EXPECT_THAT(given.Revoke("liar"), IsEmpty()) << "once";
  EXPECT_THAT(given.Revoke("good"), ElementsAre(1));
}

TEST(GivenResultsTest, ATaskBelongsToWhoGaveItLast) {
  GivenResults given;
  given.Put(1, "liar");
  given.Put(1, "good");
  EXPECT_THAT(given.Revoke("liar"), IsEmpty());
  EXPECT_THAT(given.Revoke("good"), ElementsAre(1));
}

}  // namespace
}  // namespace tilemend
