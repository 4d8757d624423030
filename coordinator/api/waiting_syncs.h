// Calls of workers that wait for news. They hold no thread of their own: one thread serves all.
#ifndef TILEMEND_COORDINATOR_API_WAITING_SYNCS_H_
#define TILEMEND_COORDINATOR_API_WAITING_SYNCS_H_

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <thread>
#include <utility>

#include "absl/status/statusor.h"
#include "coordinator/api/long_calls.h"
#include "coordinator/jobs/cluster.h"
#include "tilemend/v1/work.pb.h"

namespace tilemend {

// One call of a worker.
struct WorkerSync {
  using Answer = std::function<void(absl::StatusOr<v1::SyncResponse>)>;

  v1::SyncRequest request;
  std::string identity;
  std::function<bool()> alive;  // whether the worker still waits for the answer; with or without the lock
  Answer answer;                // once, without the lock
  v1::SyncResponse response = {};
  std::chrono::steady_clock::time_point deadline = {};
  std::unique_ptr<LongCalls::Call> call = nullptr;
};

// All methods but the constructor and the destructor need the lock.
class WaitingSyncs {
 public:
  // Whether the call has come to its end. With the lock held.
  using Try = std::function<bool(const std::shared_ptr<WorkerSync>&)>;

  // `try_answer` is called for each waiting call when work has changed, and for each that is due. `cluster` must
  // outlive this.
  WaitingSyncs(Cluster& cluster, Try try_answer);
  // Precondition: all calls have ended.
  ~WaitingSyncs();

  void Add(std::shared_ptr<WorkerSync> sync);
  // Tries the calls of this worker: a later one may have taken its place, or its caller is gone.
  void TryCallsOf(const std::string& worker);

 private:
  using SteadyTime = std::chrono::steady_clock::time_point;

  void Run();
  std::set<uint64_t> Due(SteadyTime now) const;
  std::set<uint64_t> All() const;
  void TryOne(uint64_t number);

  Cluster& cluster_;
  const Try try_answer_;
  std::map<uint64_t, std::shared_ptr<WorkerSync>> waiting_;  // those that wait for longest first
  std::set<std::pair<SteadyTime, uint64_t>> deadlines_;
  std::set<std::pair<std::string, uint64_t>> workers_;
  uint64_t last_ = 0;
  uint64_t seen_ = 0;  // changes that all of them were tried after
  bool quits_ = false;
  std::thread thread_;  // last: it uses the others
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_API_WAITING_SYNCS_H_
