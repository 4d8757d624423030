#include "coordinator/check/ground_check.h"

#include <gtest/gtest.h>

#include <functional>
#include <iterator>
#include <utility>
#include <vector>

namespace tilemend {
namespace {

const std::vector<Point3> kVertices = {{100, 200, 5}, {130, 240, 5}};

RimGround Rim() { return {{false, false}, {5, 5}, 3, {{33, 66, 5}, {34, 66, 5}, {30, 67, 4.5F}}}; }

TEST(CheckRimGroundTest, TakesSquaresNearTheTile) {
  EXPECT_TRUE(CheckRimGround(Rim(), kVertices).ok());
  EXPECT_TRUE(CheckRimGround({{false, false}, {5, 5}}, kVertices).ok()) << "no hole";
}

TEST(CheckRimGroundTest, RefusesOthers) {
  const std::function<void(RimGround&)> faults[] = {[](RimGround& r) { r.side = 0; },
                                                    [](RimGround& r) { r.side = -3; },
                                                    [](RimGround& r) { r.side = 0.01; },
                                                    [](RimGround& r) { r.around.push_back(r.around.back()); },
                                                    [](RimGround& r) { std::swap(r.around[0], r.around[1]); },
                                                    [](RimGround& r) {
                                                      r.around.push_back({33, 200, 5});
                                                    },
                                                    [](RimGround& r) { r.around[0].col = -2'000'000'000; }};
  for (size_t i = 0; i < std::size(faults); ++i) {
    RimGround rim = Rim();
    faults[i](rim);
    EXPECT_TRUE(absl::IsInvalidArgument(CheckRimGround(rim, kVertices))) << i;
  }
}

}  // namespace
}  // namespace tilemend
