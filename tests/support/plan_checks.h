// What every plan must satisfy, and plans of scenes in memory.
#ifndef TILEMEND_TESTS_SUPPORT_PLAN_CHECKS_H_
#define TILEMEND_TESTS_SUPPORT_PLAN_CHECKS_H_

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "coordinator/plan/plan.h"
#include "tests/support/surveyed_scene.h"

namespace tilemend {

using Picture = std::vector<std::string>;

inline Plan PlanOf(const SurveyedScene& scene) { return MakePlan(scene.Input(), {}); }
inline Plan PlanOf(const Picture& picture, int32_t squares = 4) { return PlanOf(PictureScene(picture, squares)); }

// No hole has a failure, nothing is left, and every hole's segments close.
inline void ExpectSound(const Plan& plan) {
  EXPECT_THAT(plan.left, testing::IsEmpty());
  for (size_t h = 0; h < plan.holes.size(); ++h) {
    EXPECT_EQ(plan.holes[h].failure, "");
    std::map<int32_t, int> balance;
    for (const RimSegment& s : plan.holes[h].segments) {
      ++balance[s.from];
      --balance[s.to];
    }
    for (const auto& [vertex, n] : balance) EXPECT_EQ(n, 0) << "hole " << h << ": as many segments in as out";
  }
}

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_PLAN_CHECKS_H_
