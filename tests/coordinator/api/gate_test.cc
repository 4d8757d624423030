#include "coordinator/api/gate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/metrics/prometheus_registry.h"
#include "common/util/error_info.h"
#include "tests/support/list_log.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr char kCreate[] = "tilemend.v1.Jobs/CreateJob";

class GateTest : public ::testing::Test {
 protected:
  PrometheusRegistry registry_;
  ListLog log_;
  Gate gate_{*Access::Closed("", *Log::Null()), registry_, log_};
};

TEST_F(GateTest, PutsDownWhoWasRefused) {
  const Claims claims{"bob", {}, ""};
  EXPECT_FALSE(gate_.Admit(kCreate, claims, "ipv4:10.0.0.7:1").ok());
  EXPECT_THAT(log_.lines(), ElementsAre("warning refused rpc=tilemend.v1.Jobs/CreateJob certificate=bob "
                                        "address=ipv4:10.0.0.7:1 reason=ROLE_NEEDED message=\"bob may not do that; it "
                                        "needs the role submit\"\n"));
}

// A caller that tries tokens must not fill a disk.
TEST_F(GateTest, WritesAFewOfVeryManyRefusals) {
  constexpr int kCalls = 10'000;
  for (int i = 0; i < kCalls; ++i) EXPECT_FALSE(gate_.Admit(kCreate, {"", {}, "guess"}, "a").ok());
  EXPECT_GE(log_.lines().size(), size_t{kRefusalsAtOnce});
  EXPECT_LT(log_.lines().size(), size_t{kCalls / 10});
}

TEST_F(GateTest, NeverWritesATokenDown) {
  EXPECT_FALSE(gate_.Admit(kCreate, {"", {}, "my-secret"}, "a").ok());
  EXPECT_THAT(log_.lines(), ElementsAre(Not(HasSubstr("my-secret"))));
}

TEST_F(GateTest, PutsDownWhoDidWhat) {
  gate_.Audit(kCreate, {"ann", {}}, "a", {{"what", "jobs/1"}}, absl::OkStatus());
  gate_.Audit(kCreate, {"ann", {}}, "a", {{"what", "jobs/2"}, {"priority", 7}, {"overwrite", ""}},
              WithErrorInfo(absl::AbortedError("x"), {"OUTPUT_IN_USE", {}}));
  EXPECT_THAT(
      log_.lines(),
      ElementsAre("info audit rpc=tilemend.v1.Jobs/CreateJob who=ann address=a what=jobs/1 code=OK\n",
                  "info audit rpc=tilemend.v1.Jobs/CreateJob who=ann address=a what=jobs/2 priority=7 code=ABORTED "
                  "reason=OUTPUT_IN_USE\n"));
}

TEST_F(GateTest, CountsCallsByHowTheyEnded) {
  gate_.Ended(kCreate, absl::OkStatus(), absl::Seconds(2));
  gate_.Ended(kCreate, absl::AbortedError(""), absl::Seconds(1));
  gate_.Ended("no.such/Rpc", absl::OkStatus(), absl::Seconds(1));
  const std::string text = registry_.Text();
  EXPECT_THAT(text, HasSubstr("rpcs_total{code=\"OK\",rpc=\"tilemend.v1.Jobs/CreateJob\"} 1\n"));
  EXPECT_THAT(text, HasSubstr("rpcs_total{code=\"ABORTED\",rpc=\"tilemend.v1.Jobs/CreateJob\"} 1\n"));
  EXPECT_THAT(text, HasSubstr("rpc_seconds_sum{rpc=\"tilemend.v1.Jobs/CreateJob\"} 3\n"));
}

}  // namespace
}  // namespace tilemend
