#include "worker/papers/published_ways.h"

#include <gtest/gtest.h>

namespace tilemend {
namespace {

TEST(PublishedWaysTest, HasAllWays) {
  const PublishedWays& ways = *AllPublishedWays();
  EXPECT_NE(ways.over_plane, nullptr);
  EXPECT_NE(ways.in_space, nullptr);
  EXPECT_NE(ways.by_name, nullptr);
}

}  // namespace
}  // namespace tilemend
