// A simulated coordinator: the state machine and its journal, with what Coordinator does around them.
#ifndef TILEMEND_TESTS_COORDINATOR_STATE_SIMULATION_COORDINATOR_H_
#define TILEMEND_TESTS_COORDINATOR_STATE_SIMULATION_COORDINATOR_H_

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "coordinator/state/coordinator_state.h"
#include "coordinator/state/patience.h"
#include "tests/coordinator/state/simulation/pipeline.h"
#include "tests/coordinator/state/simulation/store.h"
#include "tests/coordinator/state/simulation/world.h"

namespace tilemend::simulation {

struct Attempt {
  TaskKey key;
  uint64_t token = 0;
};
struct Report {
  Attempt attempt;
  std::string output;  // empty: the machine failed
};
struct Request {
  std::string worker;
  uint64_t sequence = 0;
  int32_t threads = 1, prefetch = 0;
  bool draining = false;
  std::vector<Attempt> held;
  std::set<uint64_t> begun;  // tokens of those that do not wait for a thread
  std::vector<Report> finished;
};
struct Given {
  Attempt attempt;
  CellId cell;
  Stage stage = Stage::kSurvey;
  std::string input;
};
struct Response {
  std::vector<Given> start;
  std::vector<Attempt> keep, acknowledged;
  bool leave = false;
};
struct Told {
  JobState state = JobState::kRunning;
  std::string outcome;
};

// What happened, over all processes.
struct Tally {
  int64_t events = 0, crashes = 0, refused_late = 0, struck = 0, quarantined = 0, failed = 0, doubled = 0,
          committed = 0, suspected = 0, cleared = 0, revoked = 0;
  uint64_t trace = 0;  // of all events, in their order
};

class Coordinator {
 public:
  static constexpr absl::Duration kLease = absl::Seconds(5);

  Coordinator(World& world, Store& store, std::vector<std::string>& broken)
      : world_(world), store_(store), broken_(broken) {}

  void Boot();
  // What was not durable is gone; another process boots after a while.
  void Crash();
  void Pause(absl::Duration duration) { paused_until_ = std::max(paused_until_, world_.now() + duration); }

  // Messages. Nothing comes of them if it is down.
  void OnSync(const Request& request, const std::function<void(Response)>& answer);
  void OnSubmit(const std::string& name, const std::function<void()>& answer);
  void OnCancel(const std::string& name);
  void OnGet(const std::string& name, const std::function<void(Told)>& answer);

  void CheckState();
  // When all jobs are over.
  void CheckEnd() { Require(suspected_.empty(), "a worker waits for the verdict on a job that is over"); }
  const Tally& tally() const { return tally_; }
  // Workers that were set aside, over all processes.
  const std::set<std::string>& ever_set_aside() const { return ever_set_aside_; }

 private:
  struct Entry {
    std::unique_ptr<Pipeline> pipeline;
    std::string outcome;             // when it is over
    std::vector<std::string> wrong;  // workers that gave wrong results which the pipeline has taken
    int beginnings = 0;              // of the pipeline; what was settled before the last one is of no interest
  };

  // Runs `action` in this process, when it is not stopped.
  void WhenAwake(std::function<void()> action);
  // When all that was put so far is durable.
  void WhenDurable(std::function<void()> action);
  void CommitSoon();
  void Tick();
  std::optional<Effects> Apply(const Event& event);
  void Deliver(const SettledTask& task, const std::string& output);
  void AddTasks(const std::string& id, std::vector<TaskSpec> tasks);
  void EndIfDone(const std::string& id);
  // Somebody has verified the results.
  void Disprove(const std::string& id, const std::string& worker);
  void Revoke(const Revoked& revoked);
  void BeginAgain(const std::string& id, int beginning);
  void EndJob(const std::string& id, JobState state, const std::string& outcome);
  void PutJob(const Job& job);
  void Restore(const JobRecord& record);
  Response Sync(const Request& request);
  void TakeReport(const std::string& worker, const Report& report);
  Event EventOf(const std::string& worker, const Report& report, const Task* task);
  // An account of its own of which attempts may still bring a result.
  void Account(const Event& event, const Effects& effects);
  bool IsValid(const Attempt& attempt, const std::string& worker) const;
  void Require(bool condition, const std::string& what) {
    if (!condition) broken_.push_back(what);
  }
  void Trace(const Event& event);
  bool MayWork(const std::string& worker) const { return !set_aside_.contains(worker) && !suspected_.contains(worker); }
  void TakeVerdicts(const Effects& effects);

  World& world_;
  Store& store_;
  std::vector<std::string>& broken_;
  Tally tally_;
  int process_ = 0;  // 0: down
  int last_process_ = 0;
  absl::Time paused_until_ = absl::InfinitePast();
  std::unique_ptr<CoordinatorState> state_;
  std::optional<Patience> patience_;
  std::map<std::string, Entry> entries_;
  std::map<std::string, uint64_t> sequences_;
  std::set<std::string> set_aside_, suspected_;
  std::set<std::string> ever_set_aside_;
  std::map<uint64_t, std::pair<TaskKey, std::string>> valid_;
  std::deque<std::pair<uint64_t, std::function<void()>>> waiting_;
  bool is_committing_ = false;
};

}  // namespace tilemend::simulation

#endif  // TILEMEND_TESTS_COORDINATOR_STATE_SIMULATION_COORDINATOR_H_
