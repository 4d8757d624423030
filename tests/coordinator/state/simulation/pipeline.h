// A job without geometry: waves of tasks, each made of all results of the wave before. A function of its name.
#ifndef TILEMEND_TESTS_COORDINATOR_STATE_SIMULATION_PIPELINE_H_
#define TILEMEND_TESTS_COORDINATOR_STATE_SIMULATION_PIPELINE_H_

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "absl/strings/match.h"
#include "absl/strings/str_cat.h"
#include "coordinator/state/event.h"
#include "tests/coordinator/state/simulation/world.h"

namespace tilemend::simulation {

// The task that takes its worker down, if the history has one.
inline bool IsKiller(CellId cell, Stage stage) { return cell == CellId{0, 0} && stage == Stage::kFill; }

// The tasks of which every result is wrong, if the history has them.
inline bool IsPoison(const std::string& job, Stage stage) {
  return absl::StartsWith(job, "j0") && stage == Stage::kFill;
}

class Pipeline {
 public:
  explicit Pipeline(std::string name) : name_(std::move(name)) {}

  std::vector<TaskSpec> Start() { return Wave("start"); }

  // The tasks that the result makes possible. `output` is "-" for a task without one.
  std::vector<TaskSpec> Take(CellId cell, const std::string& output) {
    results_[cell] = output;
    if (results_.size() < static_cast<size_t>(SizeOf(wave_))) return {};
    std::string all = name_;
    for (const auto& [of, result] : results_) absl::StrAppend(&all, " ", result);
    results_.clear();
    if (++wave_ < WavesOf()) return Wave(Mix(all));
    outcome_ = Mix(all);
    return {};
  }

  // Empty until all is done.
  const std::string& outcome() const { return outcome_; }

  // That of a job to which nothing happens.
  static std::string Undisturbed(const std::string& name) {
    Pipeline pipeline(name);
    std::vector<TaskSpec> tasks = pipeline.Start();
    while (!tasks.empty()) {
      std::vector<TaskSpec> next;
      for (const TaskSpec& task : tasks) {
        for (TaskSpec& made : pipeline.Take(task.cell, Mix(task.input))) {
          next.push_back(std::move(made));
        }
      }
      tasks = std::move(next);
    }
    return pipeline.outcome();
  }

 private:
  int WavesOf() const { return 2 + name_.back() % 3; }
  int SizeOf(int wave) const { return 1 + (name_.back() + wave) % 4; }
  std::vector<TaskSpec> Wave(const std::string& before) {
    std::vector<TaskSpec> tasks;
    constexpr Stage kStages[] = {Stage::kSurvey, Stage::kFill, Stage::kSampleLayer, Stage::kAssemble};
    for (int i = 0; i < SizeOf(wave_); ++i) {
      TaskSpec& task = tasks.emplace_back();
      task.cell = {i, 0};
      task.stage = kStages[wave_];
      task.input = Mix(absl::StrCat(before, " ", i));
    }
    return tasks;
  }

  const std::string name_;
  int wave_ = 0;
  std::map<CellId, std::string> results_;
  std::string outcome_;
};

}  // namespace tilemend::simulation

#endif  // TILEMEND_TESTS_COORDINATOR_STATE_SIMULATION_PIPELINE_H_
