#include "coordinator/api/coordinator.h"

#include <gtest/gtest.h>

#include "tests/coordinator/api/coordinator_fixture.h"
#include "tests/support/waiting_sync.h"

namespace tilemend {
namespace {

TEST(CoordinatorOptionsTest, RefusesALeaseShorterThanTwoCalls) {
  TempFolder folder;
  CoordinatorOptions options;
  options.work_folder = folder / "work";
  options.lease = absl::Seconds(2);
  EXPECT_TRUE(
      absl::IsInvalidArgument(Coordinator::Create(options, ToyPipelineFactory(), *MetricsRegistry::Null()).status()));
}

TEST_F(CoordinatorTest, NobodyWaitsOnceItEnds) {
  coordinator_.StopWaiting();
  EXPECT_TRUE(absl::IsUnavailable(SyncAndWait(calls_.work, NewSync()).status()));
}

}  // namespace
}  // namespace tilemend
