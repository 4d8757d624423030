// A simulated worker: the protocol of worker/service/worker.h, on a machine with faults.
#ifndef TILEMEND_TESTS_COORDINATOR_STATE_SIMULATION_WORKER_H_
#define TILEMEND_TESTS_COORDINATOR_STATE_SIMULATION_WORKER_H_

#include <map>
#include <set>
#include <string>
#include <utility>

#include "absl/strings/str_cat.h"
#include "tests/coordinator/state/simulation/coordinator.h"

namespace tilemend::simulation {

class Worker {
 public:
  // What is wrong with the machine, as long as the world is faulty.
  enum class Kind { kGood, kLiar, kSwindler, kFullDisk, kSlow };

  Worker(World& world, Coordinator& coordinator, std::string name, Kind kind, int threads)
      : world_(world), coordinator_(coordinator), name_(std::move(name)), kind_(kind), threads_(threads) {}

  void Boot() {
    process_ = ++last_process_;
    id_ = absl::StrCat(name_, ".", process_);
    held_.clear();
    finished_.clear();
    sequence_ = waiting_ = 0;
    frozen_until_ = absl::InfinitePast();
    is_draining_ = false;
    Sync();
  }
  // Another process begins after a while.
  void Die() {
    if (process_ == 0) return;
    process_ = 0;
    world_.After(world_.random.Time(200, 3000), [this] { Boot(); });
  }
  void Freeze(absl::Duration duration) { frozen_until_ = std::max(frozen_until_, world_.now() + duration); }
  void Drain() { is_draining_ = true; }
  // Nothing comes through, for a while, one way or both.
  void Cut(bool to, bool from, absl::Duration duration) {
    if (to) cut_to_ = world_.now() + duration;
    if (from) cut_from_ = world_.now() + duration;
  }
  void Heal() {
    // A liar is set aside until it is started anew.
    if (kind_ != Kind::kLiar && kind_ != Kind::kSwindler) kind_ = Kind::kGood;
    cut_to_ = cut_from_ = absl::InfinitePast();
  }

 private:
  struct Held {
    Given given;
    bool is_dropped = false;
    bool has_begun = false;
  };

  // Runs `action` in this process, when it is not frozen.
  void WhenAwake(int process, const std::function<void()>& action) {
    if (process_ != process) return;
    if (world_.now() >= frozen_until_) return action();
    world_.After(frozen_until_ - world_.now(), [this, process, action] { WhenAwake(process, action); });
  }
  void After(absl::Duration delay, const std::function<void()>& action) {
    world_.After(delay, [this, process = process_, action] { WhenAwake(process, action); });
  }

  void Sync();
  Request NextRequest();
  void Take(const Request& request, const Response& response);
  void Run(const Given& given);
  void Finish(uint64_t token);

  World& world_;
  Coordinator& coordinator_;
  const std::string name_;
  Kind kind_;
  const int threads_;
  int process_ = 0, last_process_ = 0;
  std::string id_;
  std::map<uint64_t, Held> held_;
  std::map<uint64_t, Report> finished_;
  uint64_t sequence_ = 0, waiting_ = 0;  // the call that is waited for, 0: none
  absl::Time frozen_until_ = absl::InfinitePast(), cut_to_ = absl::InfinitePast(), cut_from_ = absl::InfinitePast();
  bool is_draining_ = false;
};

}  // namespace tilemend::simulation

#endif  // TILEMEND_TESTS_COORDINATOR_STATE_SIMULATION_WORKER_H_
