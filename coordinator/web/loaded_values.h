// Values that take long to read, read on a thread of their own so that no request waits for them.
#ifndef TILEMEND_COORDINATOR_WEB_LOADED_VALUES_H_
#define TILEMEND_COORDINATOR_WEB_LOADED_VALUES_H_

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <iterator>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/util/heap.h"

namespace tilemend {

// A request waits so long for a value that is not there.
inline constexpr std::chrono::milliseconds kLoadingPatience(40);

// A value that nobody has fetched is kept so long. Pages ask every two seconds.
inline constexpr std::chrono::seconds kUnfetchedFor(10);

// The values that were asked for last, by name. Thread-safe. A value stays until somebody has fetched it, so more
// callers than there is room for take turns.
template <typename T>
class LoadedValues {
 public:
  using Result = absl::StatusOr<std::shared_ptr<const T>>;
  // Returns soon, with any status, once a stop is requested: the destructor waits for it.
  using Load = std::function<Result(const std::stop_token&)>;

  explicit LoadedValues(size_t most) : most_(most) {}
  ~LoadedValues() {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      ends_ = true;
    }
    stop_.request_stop();
    changed_.notify_all();
    if (thread_.joinable()) thread_.join();
  }

  // What `load` gave for this name; kUnavailable while it runs, or while others are read and there is no room. It is
  // called once, on the thread here. An error is told once: what asks next has it loaded again, as a shared folder may
  // be back.
  Result Find(const std::string& name, Load load) {
    std::unique_lock<std::mutex> lock(mutex_);
    if (Touch(name) == nullptr && !Insert(name, std::move(load))) {
      return absl::UnavailableError("others are being read; ask again");
    }
    const auto there = [&] {
      const Entry* const entry = Touch(name);
      return entry == nullptr || entry->result.has_value();
    };
    changed_.wait_for(lock, kLoadingPatience, there);
    Entry* const entry = Touch(name);
    if (entry != nullptr && entry->result) {
      Result result = *entry->result;
      entry->fetched = true;
      if (!result.ok()) entries_.pop_front();  // where Touch put it
      return result;
    }
    return absl::UnavailableError("it is being read; ask again");
  }

  // Puts a value there that somebody else has made. Without room it is not kept.
  void Keep(const std::string& name, std::shared_ptr<const T> value) {
    const std::lock_guard<std::mutex> lock(mutex_);
    Entry* known = Touch(name);
    if (known == nullptr && MakeRoom()) known = &entries_.emplace_front(Entry{.name = name});
    if (known == nullptr) return;
    known->result = std::move(value);
    known->fetched = true;
  }

 private:
  using Clock = std::chrono::steady_clock;

  struct Entry {
    std::string name;
    std::optional<Result> result = std::nullopt;  // none: it is being loaded
    Clock::time_point loaded = {};
    bool fetched = false;
  };

  // The entry of that name, which becomes the one that was asked for last. Null if there is none.
  Entry* Touch(const std::string& name) {
    for (auto it = entries_.begin(); it != entries_.end(); ++it) {
      if (it->name != name) continue;
      entries_.splice(entries_.begin(), entries_, it);
      return &entries_.front();
    }
    return nullptr;
  }
  static bool MayGo(const Entry& entry) {
    return entry.result && (entry.fetched || Clock::now() - entry.loaded > kUnfetchedFor);
  }
  // Room for one more; false if all that is there is needed still.
  bool MakeRoom() {
    if (entries_.size() < most_) return true;
    const auto oldest = std::find_if(entries_.rbegin(), entries_.rend(), MayGo);
    if (oldest == entries_.rend()) return false;
    entries_.erase(std::next(oldest).base());
    return true;
  }
  bool Insert(const std::string& name, Load load) {
    if (!MakeRoom()) return false;
    entries_.push_front({name});
    waiting_.emplace_back(name, std::move(load));
    if (!thread_.joinable()) thread_ = std::thread([this] { LoadAll(); });
    changed_.notify_all();
    return true;
  }
  void LoadAll() {
    std::unique_lock<std::mutex> lock(mutex_);
    while (true) {
      changed_.wait(lock, [this] { return ends_ || !waiting_.empty(); });
      if (ends_) return;
      const auto [name, load] = std::move(waiting_.front());
      waiting_.pop_front();
      lock.unlock();
      Result result = load(stop_.get_token());
      ReturnHeap();  // a report of 100 MB takes ten times as much while it is read
      lock.lock();
      if (Entry* const entry = Touch(name)) {
        entry->result = std::move(result);
        entry->loaded = Clock::now();
      }
      changed_.notify_all();
    }
  }

  const size_t most_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::list<Entry> entries_;                          // the last asked for first
  std::deque<std::pair<std::string, Load>> waiting_;  // names of entries without a result: at most `most_`
  bool ends_ = false;
  std::stop_source stop_;
  std::thread thread_;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_WEB_LOADED_VALUES_H_
