// Coordinators that end and start again from their journals.
#ifndef TILEMEND_TESTS_COORDINATOR_JOBS_RESTART_FIXTURE_H_
#define TILEMEND_TESTS_COORDINATOR_JOBS_RESTART_FIXTURE_H_

#include <atomic>
#include <filesystem>
#include <string>

#include "absl/time/clock.h"
#include "tests/support/test_cluster.h"

namespace tilemend {

inline ClusterOptions Durable() {
  ClusterOptions options;
  options.durable = true;
  options.fake_clock = true;
  return options;
}

// Runs `tasks` tasks, then none.
class Budget {
 public:
  explicit Budget(int tasks) : left_(tasks) {}
  StageRunner Runner() {
    return [this](Stage stage, const std::string& input, const CancelToken& cancel) -> absl::StatusOr<std::string> {
      if (--left_ < 0) {
        exhausted_ = true;
        exhausted_.notify_all();
        while (!cancel.cancelled()) absl::SleepFor(absl::Milliseconds(1));
        return absl::CancelledError("no more");
      }
      return ToyStageRunner()(stage, input, cancel);
    };
  }
  void AwaitEnd() { exhausted_.wait(false); }

 private:
  std::atomic<int> left_;
  std::atomic<bool> exhausted_{false};
};

inline StageRunner Counting(std::atomic<int>& count) {
  return [&count](Stage stage, const std::string& input, const CancelToken& cancel) {
    ++count;
    return ToyStageRunner()(stage, input, cancel);
  };
}

inline v1::Job Undisturbed(const std::string& scene) {
  TestCluster cluster;
  cluster.AddWorker("w", 2);
  return cluster.WaitFor(cluster.Submit(scene).name());
}

inline int FilesBelow(const std::string& folder) {
  int files = 0;
  if (!std::filesystem::exists(folder)) return 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) files += entry.is_regular_file();
  return files;
}

}  // namespace tilemend

#endif  // TILEMEND_TESTS_COORDINATOR_JOBS_RESTART_FIXTURE_H_
