#include "coordinator/api/watch_handler.h"

#include <algorithm>

#include "common/rpc/limits.h"
#include "common/util/status_macros.h"
#include "coordinator/jobs/describe_job.h"
#include "coordinator/state/demand.h"

namespace tilemend {

// Belongs to the thread once it has been told of it. It counts as a call as long as anybody knows it.
class Watch {
 public:
  explicit Watch(Watcher& to) : watcher(to) {}

  Watcher& watcher;
  std::string topic;
  uint64_t cursor = 0;
  bool lives = false;  // between its beginning and its end
  bool is_sending = false;
  bool has_last = false;               // the state that is being sent is the last one
  std::optional<absl::Status> leaves;  // why
  std::unique_ptr<LongCalls::Call> call;
};

namespace {

using SteadyTime = std::chrono::steady_clock::time_point;

constexpr std::chrono::milliseconds kWatchInterval(200);

// Some 20 kB each.
constexpr size_t kMostWatches = 4096;

// Whether there is news. With the lock.
bool LookAtDemand(const Cluster& cluster, WatchTopic& topic) {
  const bool active = DemandOf(cluster.state).jobs > 0;
  if (topic.news && topic.news->active == active) return false;
  topic.news = WatchNews{topic.news ? topic.news->number + 1 : 1, false, nullptr, active};
  return true;
}

// Likewise. `next_look` becomes earlier if news wait.
bool LookAtJob(const Cluster& cluster, const std::string& name, WatchTopic& topic, SteadyTime now,
               SteadyTime& next_look) {
  const auto job = cluster.JobNamed(name);
  topic.error = job.status();
  if (!job.ok()) return true;
  const bool over = IsOver((*job)->state);
  if (topic.news && (topic.news->is_last || (*job)->version <= topic.news->number)) return false;
  if (!over && now < topic.next) {
    next_look = std::min(next_look, topic.next);
    return false;
  }
  auto message = std::make_shared<const v1::Job>(DescribeJob(cluster, **job));
  topic.news = WatchNews{message->cursor(), over, message};
  topic.next = now + kWatchInterval;
  return true;
}

std::optional<absl::Status> MayNotGoOn(Watch& watch) {
  absl::Status status = watch.watcher.GoOn();
  return status.ok() ? std::nullopt : std::optional(std::move(status));
}

// What is known was told before, and an end that is known is the end.
std::optional<absl::Status> LeftByTheCoordinator(Watch& watch) {
  if (watch.has_last) return std::nullopt;
  return absl::UnavailableError(watch.topic.empty()
                                    ? "the coordinator is shutting down"
                                    : "the coordinator is shutting down; watch again with the last cursor");
}

void Deliver(Watch& watch, const WatchTopic& topic, absl::Time now) {
  if (watch.is_sending || !topic.news) return;
  if (topic.news->number <= watch.cursor && !topic.news->is_last) return;
  watch.cursor = topic.news->number;
  watch.is_sending = true;
  watch.has_last = topic.news->is_last;
  watch.call->Touch(now);
  watch.watcher.Send(*topic.news);
}

}  // namespace

WatchHandler::WatchHandler(Cluster& cluster)
    : cluster_(cluster), watches_(kMostWatches, LongCalls::WhenFull::kStopOldest), thread_([this] { Run(); }) {}

WatchHandler::~WatchHandler() {
  {
    const ClusterLock lock(cluster_.mutex);
    quits_ = true;
    cluster_.job_changed.Wake();
  }
  thread_.join();
}

std::shared_ptr<Watch> NewWatch(Watcher& watcher) { return std::make_shared<Watch>(watcher); }

absl::Status WatchHandler::WatchJob(const v1::WatchJobRequest& request, const std::shared_ptr<Watch>& watch) {
  {
    const ClusterLock lock(cluster_.mutex);
    TILEMEND_RETURN_IF_ERROR(cluster_.JobNamed(request.name()).status());
  }
  return Enter(request.name(), request.cursor(), watch);
}

absl::Status WatchHandler::WatchDemand(const std::shared_ptr<Watch>& watch) { return Enter("", 0, watch); }

absl::Status WatchHandler::Enter(const std::string& topic, uint64_t cursor, const std::shared_ptr<Watch>& watch) {
  const auto give_way = [this, weak = std::weak_ptr(watch)] {
    if (auto oldest = weak.lock()) Tell(std::move(oldest), Post::kGivesWay);
  };
  TILEMEND_ASSIGN_OR_RETURN(watch->call, watches_.Enter(topic, cluster_.options.clock(), give_way));
  watch->topic = topic;
  watch->cursor = cursor;
  Tell(watch, Post::kNew);
  return absl::OkStatus();
}

void WatchHandler::Sent(std::shared_ptr<Watch> watch) { Tell(std::move(watch), Post::kSent); }

void WatchHandler::Gone(std::shared_ptr<Watch> watch) { Tell(std::move(watch), Post::kGone); }

void WatchHandler::Tell(std::shared_ptr<Watch> watch, Post post) {
  const ClusterLock lock(cluster_.mutex);
  posts_.emplace_back(std::move(watch), post);
  cluster_.job_changed.Wake();
}

void WatchHandler::Run() {
  SteadyTime next_question = SteadyTime::min();
  ClusterLock lock(cluster_.mutex);
  while (true) {
    auto posts = std::exchange(posts_, {});
    lock.unlock();
    for (const auto& [watch, post] : posts) Take(watch, post);
    posts.clear();  // without the lock: the last to know a watch takes that of its call
    const SteadyTime now = std::chrono::steady_clock::now();
    if (now >= next_question) {
      EndWhere(MayNotGoOn);
      next_question = now + absl::ToChronoMilliseconds(kMaxPoll);
    }
    lock.lock();
    const uint64_t seen = cluster_.job_changed.count();
    const bool stops = cluster_.stopping;
    const Found found = Look(now);
    lock.unlock();
    HandOut(found.changed);
    if (stops) EndWhere(LeftByTheCoordinator);
    lock.lock();
    if (quits_ && topics_.empty() && posts_.empty()) return;
    if (!posts_.empty()) continue;
    if (found.quiet_until > now) {
      cluster_.job_changed.SleepUntil(lock, std::min(next_question, found.quiet_until));
    } else {
      cluster_.job_changed.WaitUntil(lock, seen, std::min(next_question, found.next_look));
    }
  }
}

void WatchHandler::Take(const std::shared_ptr<Watch>& watch, Post post) {
  if (post == Post::kNew) {
    watch->lives = true;
    topics_[watch->topic].watches.insert(watch);
  }
  if (post == Post::kGone) watch->leaves = absl::CancelledError("the watcher went away");
  if (post == Post::kGivesWay) watch->leaves = absl::OkStatus();
  if (post == Post::kSent) {
    watch->is_sending = false;
    if (watch->has_last) watch->leaves = absl::OkStatus();
  }
  if (!watch->lives) return;  // not yet, or no more
  watch->leaves ? End(watch, *watch->leaves) : Deliver(*watch, topics_.at(watch->topic), cluster_.options.clock());
}

WatchHandler::Found WatchHandler::Look(SteadyTime now) {
  Found found;
  for (auto& [name, topic] : topics_) {
    const bool has_news =
        name.empty() ? LookAtDemand(cluster_, topic) : LookAtJob(cluster_, name, topic, now, found.next_look);
    if (has_news) found.changed.push_back(name);
    found.quiet_until = std::min(found.quiet_until, topic.next);
  }
  return found;
}

void WatchHandler::HandOut(const std::vector<std::string>& changed) {
  if (changed.empty()) return;
  cluster_.journal->Await();
  for (const std::string& name : changed) {
    const auto topic = topics_.find(name);
    if (topic->second.error.ok()) {
      for (const auto& watch : topic->second.watches) Deliver(*watch, topic->second, cluster_.options.clock());
      continue;
    }
    const absl::Status error = topic->second.error;
    for (const auto& watch : std::set(topic->second.watches)) End(watch, error);
  }
}

void WatchHandler::EndWhere(const std::function<std::optional<absl::Status>(Watch&)>& why) {
  std::vector<std::shared_ptr<Watch>> all;
  for (const auto& [name, topic] : topics_) all.insert(all.end(), topic.watches.begin(), topic.watches.end());
  for (const auto& watch : all) {
    if (const auto reason = why(*watch)) End(watch, *reason);
  }
}

void WatchHandler::End(const std::shared_ptr<Watch>& watch, const absl::Status& status) {
  watch->lives = false;
  const auto topic = topics_.find(watch->topic);
  topic->second.watches.erase(watch);
  if (topic->second.watches.empty()) topics_.erase(topic);
  watch->watcher.End(status);
}

}  // namespace tilemend
