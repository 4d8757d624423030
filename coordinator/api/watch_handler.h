// Calls that follow jobs and the demand for workers.
//
// A watch holds no thread: it is an entry in a list. One thread looks at what has changed, describes each watched job
// once for all who watch it, and hands that out. To a watch that has not taken its last state yet only the newest one
// goes afterwards.
#ifndef TILEMEND_COORDINATOR_API_WATCH_HANDLER_H_
#define TILEMEND_COORDINATOR_API_WATCH_HANDLER_H_

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "coordinator/api/long_calls.h"
#include "coordinator/jobs/cluster.h"
#include "tilemend/v1/jobs.pb.h"

namespace tilemend {

// A state of a job, or of the demand.
struct WatchNews {
  uint64_t number = 0;                 // grows with each state; of a job its cursor
  bool is_last = false;                // the job is over
  std::shared_ptr<const v1::Job> job;  // null: of the demand
  bool active = false;                 // whether there is anything to do
};

// One who watches. All is called by one thread, which must not be kept waiting, and without a lock.
class Watcher {
 public:
  virtual ~Watcher() = default;
  // Why the watch is to end, or OK. At least once a second.
  virtual absl::Status GoOn() = 0;
  // Nothing further is sent before WatchHandler::Sent.
  virtual void Send(const WatchNews& news) = 0;
  // The last call, perhaps before Sent.
  virtual void End(const absl::Status& status) = 0;
};

class Watch;  // one call

// `watcher` must live until its End.
std::shared_ptr<Watch> NewWatch(Watcher& watcher);

// What is watched: a job, or the demand.
struct WatchTopic {
  std::optional<WatchNews> news;
  std::chrono::steady_clock::time_point next = {};  // no further state before
  absl::Status error;                               // why it cannot be watched any more
  std::set<std::shared_ptr<Watch>> watches;
};

// Thread-safe. If too many watch, the one that has had no news for longest ends (OK) and makes room; its caller may
// watch again. Watches end with kUnavailable when the coordinator ends.
class WatchHandler {
 public:
  // `cluster` must outlive this.
  explicit WatchHandler(Cluster& cluster);
  // Every watch has ended: the coordinator waits no more.
  ~WatchHandler();

  // Sends each state of the job as the message says. Ends when the job is over (OK), after Gone (kCancelled), and with
  // the error of GoOn. On an error here nothing of the watcher is ever called.
  absl::Status WatchJob(const v1::WatchJobRequest& request, const std::shared_ptr<Watch>& watch);
  // As WatchJob, of whether there is anything to do: now, and after each change.
  absl::Status WatchDemand(const std::shared_ptr<Watch>& watch);
  // The watch can take another state.
  void Sent(std::shared_ptr<Watch> watch);
  // Its caller has gone.
  void Gone(std::shared_ptr<Watch> watch);

 private:
  using SteadyTime = std::chrono::steady_clock::time_point;
  enum class Post { kNew, kSent, kGone, kGivesWay };
  using Topics = std::map<std::string, WatchTopic>;  // by the job's name; the demand is ""
  // What a look at the topics found.
  struct Found {
    std::vector<std::string> changed;            // topics with news
    SteadyTime next_look = SteadyTime::max();    // news wait so long
    SteadyTime quiet_until = SteadyTime::max();  // before that nothing but an end is news
  };

  absl::Status Enter(const std::string& topic, uint64_t cursor, const std::shared_ptr<Watch>& watch);
  void Tell(std::shared_ptr<Watch> watch, Post post);  // takes the lock
  // All below on the thread alone; with the lock held where that says so.
  void Run();
  void Take(const std::shared_ptr<Watch>& watch, Post post);
  Found Look(SteadyTime now);  // with the lock
  void HandOut(const std::vector<std::string>& changed);
  // Ends the watches for which `why` gives a reason.
  void EndWhere(const std::function<std::optional<absl::Status>(Watch&)>& why);
  void End(const std::shared_ptr<Watch>& watch, const absl::Status& status);

  Cluster& cluster_;
  LongCalls watches_;
  std::vector<std::pair<std::shared_ptr<Watch>, Post>> posts_;  // guarded by the lock
  bool quits_ = false;                                          // likewise
  Topics topics_;                                               // the thread's
  std::thread thread_;                                          // last: it uses the others
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_API_WATCH_HANDLER_H_
