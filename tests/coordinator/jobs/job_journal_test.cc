// What of tasks outlives the coordinator.
#include "coordinator/jobs/job_journal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <string>

#include "tests/coordinator/jobs/restart_fixture.h"

namespace tilemend {
namespace {

TEST(JobJournalTest, ABlobThatWasLostOrDamagedIsMadeAgain) {
  const auto lose = [](const std::filesystem::path& path) { std::filesystem::remove(path); };
  const auto cut = [](const std::filesystem::path& path) { std::filesystem::resize_file(path, 50'000); };
  for (const std::function<void(const std::filesystem::path&)>& spoil : {std::function(lose), std::function(cut)}) {
    TestCluster cluster(Durable());
    Budget budget(5);
    cluster.AddWorker("w", 1, budget.Runner());
    const std::string name = cluster.Submit("toy://3x3?bytes=100000").name();
    budget.AwaitEnd();
    for (const auto& entry : std::filesystem::recursive_directory_iterator(cluster.folder() / "work/" + name)) {
      if (entry.is_regular_file() && entry.file_size() > 50'000) spoil(entry.path());
    }
    cluster.Restart();
    cluster.AddWorker("w");
    EXPECT_EQ(cluster.WaitFor(name).message(), Undisturbed("toy://3x3?bytes=100000").message());
  }
}

TEST(JobJournalTest, LostWorkersAreRemembered) {
  ClusterOptions options = Durable();
  options.state.quarantine_after = 2;
  TestCluster cluster(options);
  Budget none(0);
  cluster.AddWorker("first", 1, none.Runner());
  const std::string name = cluster.Submit("toy://1x1").name();
  none.AwaitEnd();
  cluster.KillWorker("first");
  cluster.ExpireLeases();
  cluster.Restart();
  Budget none_again(0);
  cluster.AddWorker("second", 1, none_again.Runner());
  none_again.AwaitEnd();
  cluster.KillWorker("second");
  cluster.ExpireLeases();
  cluster.Restart();
  cluster.AddWorker("third");
  const v1::Job job = cluster.WaitFor(name);
  EXPECT_EQ(job.state(), v1::PARTIAL) << job.DebugString();
  EXPECT_EQ(job.progress().tasks_quarantined(), 1);
}

}  // namespace
}  // namespace tilemend
