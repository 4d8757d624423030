#include "coordinator/waves/sample_checks.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace tilemend {
namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

class SampleChecksTest : public ::testing::Test {
 protected:
  SampleChecksTest() { plan_.vertices.resize(3); }

  bool Takes(const SeamSample& sample) { return CheckSamples(plan_, std::vector<SeamSample>{sample}).ok(); }
  bool Takes(const ClusterSample& sample) { return CheckSamples(plan_, std::vector<ClusterSample>{sample}).ok(); }

  Plan plan_;
};

TEST_F(SampleChecksTest, TakesNumbersAtVerticesOfThePlan) {
  EXPECT_TRUE(Takes(SeamSample{{0, 0}, 2, 1.5}));
  EXPECT_TRUE(Takes(ClusterSample{2, 1.5, 0.1, {0, 1}}));
}

TEST_F(SampleChecksTest, RefusesOtherVerticesAndWhatIsNoNumber) {
  EXPECT_FALSE(Takes(SeamSample{{0, 0}, 3, 1.5}));
  EXPECT_FALSE(Takes(SeamSample{{0, 0}, -1, 1.5}));
  EXPECT_FALSE(Takes(SeamSample{{0, 0}, 0, kNoNumber}));
  EXPECT_FALSE(Takes(ClusterSample{0, kNoNumber, 0, {0, 0}}));
  EXPECT_FALSE(Takes(ClusterSample{0, 0, kNoNumber, {0, 0}}));
  EXPECT_FALSE(Takes(ClusterSample{0, 0, 0, {0, kNoNumber}}));
}

}  // namespace
}  // namespace tilemend
