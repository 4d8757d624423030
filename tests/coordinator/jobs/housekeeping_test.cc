// What becomes due as time passes.
#include "coordinator/jobs/housekeeping.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <string>
#include <thread>

#include "common/util/heap.h"
#include "tests/coordinator/api/coordinator_fixture.h"
#include "tests/coordinator/jobs/restart_fixture.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace tilemend {
namespace {

TEST(HousekeepingTest, AJobThatIsOverIsForgottenAfterAWhile) {
  TestCluster cluster(Durable());
  cluster.AddWorker("w");
  const std::string old = cluster.Submit("toy://1x1").name(), young = cluster.Submit("toy://1x1").name();
  for (const std::string& name : {old, young}) EXPECT_EQ(cluster.WaitFor(name).state(), v1::DONE);
  cluster.Restart();  // with it go the runners
  cluster.clock().Advance(absl::Hours(29 * 24));
  cluster.coordinator().Tick();
  EXPECT_EQ(cluster.coordinator().calls().jobs.ListJobs({})->jobs_size(), 2);
  cluster.clock().Advance(absl::Hours(2 * 24));
  cluster.coordinator().Tick();
  const auto only_the_newest = [&] {
    const auto list = cluster.coordinator().calls().jobs.ListJobs({});
    return list->jobs_size() == 1 && list->jobs(0).name() == young;
  };
  EXPECT_TRUE(only_the_newest());
  cluster.Restart();
  EXPECT_TRUE(only_the_newest());
}

using MemoryOfJobsTest = CoordinatorTest;

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST_F(MemoryOfJobsTest, GivesMemoryBackWhenAJobIsOver) {
  KeepHeap(1);  // or what is at the heap's end goes back by itself
  const auto job = calls_.jobs.CreateJob(NewRequest());
  ASSERT_TRUE(job.ok()) << job.status();
  constexpr size_t kBytes = size_t{16} << 20;
  void* volatile block = std::malloc(kBytes);
  std::free(block);
  coordinator_.Tick();
  ASSERT_GE(mallinfo2().keepcost, kBytes / 2) << "while it runs, memory is kept for it";
  v1::CancelJobRequest request;
  request.set_name(job->name());
  ASSERT_TRUE(calls_.jobs.CancelJob(request).ok());
  for (int i = 0; i < 10'000 && mallinfo2().keepcost >= kBytes / 2; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));  // its thread ends
    coordinator_.Tick();
  }
  EXPECT_LT(mallinfo2().keepcost, kBytes / 2);
}
#endif

}  // namespace
}  // namespace tilemend
