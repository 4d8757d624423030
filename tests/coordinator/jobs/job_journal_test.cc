// What of tasks outlives the coordinator.
#include "coordinator/jobs/job_journal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "absl/time/clock.h"
#include "coordinator/journal/sqlite_journal.h"
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

// Puts notes, or tells the first text that it finds of each.
class NotingPipeline : public JobPipeline {
 public:
  using Texts = std::vector<std::optional<std::string>>;
  explicit NotingPipeline(Texts& found) : found_(found) {}
  void Prepare(const std::shared_ptr<JobNotes>& notes, std::optional<Resumption>) override {
    for (const char* name : {"fact", "key"}) found_.push_back(notes->Find(name));
    if (found_.size() > 2) return;
    notes->Put("fact", "w", "");
    notes->Put("key", "", "text");
  }
  absl::StatusOr<std::vector<NewTask>> Start() override { return std::vector<NewTask>{{{0, 0}, Stage::kSurvey, "in"}}; }
  absl::StatusOr<std::vector<NewTask>> OnTaskDone(TaskResult) override { return std::vector<NewTask>(); }
  bool Done() const override { return false; }
  Progress GetProgress() const override { return {}; }
  absl::StatusOr<JobOutcome> Finish() override { return JobOutcome(); }

 private:
  Texts& found_;
};

TEST(JobJournalTest, NotesOutliveTheCoordinatorButNotTheTrustInTheirWorker) {
  NotingPipeline::Texts found;
  ClusterOptions options = Durable();
  options.factory = [&](const JobSpec&, const std::stop_token&) { return std::make_unique<NotingPipeline>(found); };
  TestCluster cluster(options);
  const std::string name = cluster.Submit("toy://1x1").name();
  const auto await_task = [&] {
    while (cluster.Get(name).progress().tasks() == 0) absl::SleepFor(absl::Milliseconds(1));
  };
  await_task();
  cluster.Restart();
  await_task();
  cluster.Restart([](const std::string& path) {
    const auto journal = OpenSqliteJournal(path).value();
    journal->DropResults(1, "w");
    journal->Await();
  });
  await_task();
  const NotingPipeline::Texts expected = {std::nullopt, std::nullopt, "", "text", std::nullopt, "text"};
  EXPECT_EQ(found, expected);
}

}  // namespace
}  // namespace tilemend
