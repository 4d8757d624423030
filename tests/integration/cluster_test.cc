// Jobs through a whole cluster: coordinator, gRPC in process, workers.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "absl/strings/str_cat.h"
#include "tests/support/test_cluster.h"

namespace tilemend {
namespace {

TEST(ClusterTest, SameResultWithOneTwoAndFourWorkers) {
  std::string first;
  for (const int workers : {1, 2, 4}) {
    TestCluster cluster;
    for (int i = 0; i < workers; ++i) cluster.AddWorker(absl::StrCat("w", i), i % 2 + 1);
    const v1::Job job = cluster.WaitFor(cluster.Submit("toy://6x4").name());
    EXPECT_EQ(job.state(), v1::DONE) << job.DebugString();
    EXPECT_EQ(job.progress().tasks(), 3 * 24);
    EXPECT_EQ(job.progress().tasks_done(), 3 * 24);
    if (first.empty()) first = job.message();
    EXPECT_EQ(job.message(), first);
  }
}

}  // namespace
}  // namespace tilemend
