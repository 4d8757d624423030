#include "common/rpc/smoothed_payloads.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tilemend {
namespace {

TEST(SmoothedPayloadsTest, PointsComeBackAsTheyWere) {
  const auto back = FromProto(ToProto(std::vector<SmoothedPoint>{{3, 0.1}, {5, -2e3}}), 6);
  ASSERT_TRUE(back.ok()) << back.status();
  ASSERT_EQ(back->size(), 2U);
  EXPECT_EQ(back->at(0).point, 3);
  EXPECT_EQ(back->at(0).height, 0.1);
  EXPECT_EQ(back->at(1).point, 5);
  EXPECT_EQ(back->at(1).height, -2e3);
}

TEST(SmoothedPayloadsTest, RefusesWhatIsNoSuchList) {
  const v1::SmoothedPoints good = ToProto(std::vector<SmoothedPoint>{{3, 0.1}});
  v1::SmoothedPoints uneven = good, below = good, endless = good;
  uneven.add_height(1);
  below.set_point(0, -1);
  endless.set_height(0, std::nan(""));
  EXPECT_TRUE(absl::IsInvalidArgument(FromProto(good, 3).status()));
  for (const v1::SmoothedPoints& bad : {uneven, below, endless}) {
    EXPECT_TRUE(absl::IsInvalidArgument(FromProto(bad, 4).status()));
  }
}

}  // namespace
}  // namespace tilemend
