#include "coordinator/report/hole_evidence.h"

#include <gtest/gtest.h>

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;
using Verdict = HoleEvidence::Verdict;

TEST(HoleEvidenceJsonTest, HasTheLevelWhereThereIsOne) {
  EXPECT_EQ(HoleEvidenceJson({Verdict::kRiver, true, 12.50004, 0.04, "it falls"}),
            Json::parse(R"({"taken_for": "river", "level_m": 12.5, "sigma_m": 0.04, "reason": "it falls"})"));
  EXPECT_EQ(HoleEvidenceJson({Verdict::kNoWater, false, 0, 0, "no rim"}),
            Json::parse(R"({"taken_for": "ground", "reason": "no rim"})"));
}

TEST(VerdictNameTest, NamesAll) {
  EXPECT_STREQ(VerdictName(Verdict::kLake), "lake");
  EXPECT_STREQ(VerdictName(Verdict::kLevelGround), "level ground");
}

}  // namespace
}  // namespace tilemend
