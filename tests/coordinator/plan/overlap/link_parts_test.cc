#include "coordinator/plan/overlap/link_parts.h"

#include <gtest/gtest.h>

namespace tilemend {
namespace {

TEST(LinkPartsTest, AreAsLongAsEdgesOfTheRim) {
  LinkParts parts(20, 10);
  EXPECT_EQ(parts.Take(0.5), 1);
  EXPECT_EQ(parts.Take(2), 1);
  EXPECT_EQ(parts.Take(7), 4);
}

TEST(LinkPartsTest, AreNoMoreThanManyTimesTheRimHas) {
  LinkParts parts(1e-3, 10);
  EXPECT_EQ(parts.Take(1000), 161);
  EXPECT_EQ(parts.Take(1000), 1);
}

TEST(LinkPartsTest, AreWantedThoughNoneAreLeft) {
  LinkParts parts(1e-3, 10);
  EXPECT_FALSE(parts.Wants(1e-4));
  EXPECT_TRUE(parts.Wants(1000));
  EXPECT_EQ(parts.Take(1000), 161) << "asking takes none";
  EXPECT_TRUE(parts.Wants(1000));
}

TEST(LinkPartsTest, ARimWithoutLengthOrEdgesAsksForNone) {
  EXPECT_EQ(LinkParts(0, 10).Take(1000), 1);
  EXPECT_EQ(LinkParts(0, 0).Take(1000), 1);
}

}  // namespace
}  // namespace tilemend
