// A journal on a simulated disk. What was put is lost with the process unless it was committed before.
#ifndef TILEMEND_TESTS_COORDINATOR_STATE_SIMULATION_STORE_H_
#define TILEMEND_TESTS_COORDINATOR_STATE_SIMULATION_STORE_H_

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "absl/strings/match.h"
#include "absl/strings/str_cat.h"
#include "coordinator/journal/journal.h"

namespace tilemend::simulation {

class Store : public Journal {
 public:
  uint32_t epoch() const override { return epoch_; }
  std::vector<JobRecord> TakeJobs() override {
    std::vector<JobRecord> jobs;
    for (const auto& [number, job] : jobs_) jobs.push_back(job);
    return jobs;
  }
  void PutJob(JobRecord job) override { queue_.emplace_back(std::move(job)); }
  void PutResult(int64_t job, TaskName task, ResultRecord result) override {
    queue_.emplace_back(Result{NameOf(job, task), std::move(result)});
  }
  void DropJob(int64_t) override {}
  void DropResults(int64_t job, const std::string& worker) override { queue_.emplace_back(False{job, worker}); }
  std::vector<SetAsideRecord> TakeSetAside() override {
    std::vector<SetAsideRecord> records;
    for (const auto& [worker, reason] : set_aside_) records.push_back({worker, reason});
    return records;
  }
  void PutSetAside(SetAsideRecord record) override { queue_.emplace_back(std::move(record)); }
  void Await() override {}  // who has to wait does so by is_durable(put)
  absl::StatusOr<std::optional<ResultRecord>> Find(int64_t job, const TaskName& task) override {
    const auto found = results_.find(NameOf(job, task));
    if (found == results_.end()) return std::nullopt;
    return found->second;
  }
  absl::StatusOr<std::vector<std::string>> Outputs(int64_t) override { return std::vector<std::string>(); }
  bool is_durable() const override { return true; }

  void Open() { ++epoch_; }
  void Crash() {
    committed_ += queue_.size();  // numbers of puts go on
    queue_.clear();
  }
  // The number of the last put; durable when committed() is as large.
  uint64_t put() const { return committed_ + queue_.size(); }
  uint64_t committed() const { return committed_; }
  // All that was put.
  void Commit() {
    committed_ += queue_.size();
    for (auto& put : std::exchange(queue_, {})) {
      if (auto* job = std::get_if<JobRecord>(&put)) {
        if (const auto old = jobs_.find(job->number); old != jobs_.end() && old->second.over && !job->over) ++revived_;
        jobs_[job->number] = std::move(*job);
      } else if (auto* aside = std::get_if<SetAsideRecord>(&put)) {
        set_aside_[aside->worker] = aside->reason;
      } else if (auto* wrong = std::get_if<False>(&put)) {
        std::erase_if(results_, [&](const auto& entry) {
          const auto& [name, result] = entry;
          return absl::StartsWith(name, absl::StrCat(wrong->job, " ")) && result.state == TaskState::kCommitted &&
                 result.worker == wrong->worker;
        });
      } else {
        auto& [name, result] = std::get<Result>(put);
        const auto old = results_.find(name);
        if (old != results_.end() && IsSettled(old->second.state)) ++twice_;
        results_[name] = std::move(result);
      }
    }
  }

  int committed_twice() const { return twice_; }
  int revived() const { return revived_; }  // jobs that were over, and then were not

 private:
  using Name = std::string;
  struct Result {
    Name name;
    ResultRecord result;
  };
  struct False {
    int64_t job;
    std::string worker;
  };
  static Name NameOf(int64_t job, const TaskName& task) {
    return absl::StrCat(job, " ", task.cell.col, " ", task.cell.row, " ", static_cast<int>(task.stage), " ",
                        task.input);
  }

  uint32_t epoch_ = 0;
  uint64_t committed_ = 0;
  std::vector<std::variant<JobRecord, Result, SetAsideRecord, False>> queue_;
  std::map<std::string, std::string> set_aside_;
  std::map<int64_t, JobRecord> jobs_;
  std::map<Name, ResultRecord> results_;
  int twice_ = 0, revived_ = 0;
};

}  // namespace tilemend::simulation

#endif  // TILEMEND_TESTS_COORDINATOR_STATE_SIMULATION_STORE_H_
