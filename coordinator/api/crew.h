// A few threads that work off a queue.
#ifndef TILEMEND_COORDINATOR_API_CREW_H_
#define TILEMEND_COORDINATOR_API_CREW_H_

#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <iterator>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace tilemend {

// Thread-safe.
template <class Work>
class Crew {
 public:
  // `work` is called on each of the threads with what waits, in order, and at most `most` of that.
  Crew(size_t threads, size_t most, std::function<void(std::vector<Work>)> work) : most_(most), work_(std::move(work)) {
    for (size_t i = 0; i < threads; ++i) threads_.emplace_back([this] { Run(); });
  }
  ~Crew() { Finish(); }

  // Not after Finish.
  void Add(Work work) {
    {
      std::lock_guard<std::mutex> lock(mutex_);
      queue_.push_back(std::move(work));
    }
    added_.notify_one();
  }
  // Waits until all is done. Safe to call twice.
  void Finish() {
    {
      std::lock_guard<std::mutex> lock(mutex_);
      finishes_ = true;
    }
    added_.notify_all();
    threads_.clear();
  }

 private:
  void Run() {
    std::unique_lock<std::mutex> lock(mutex_);
    while (true) {
      added_.wait(lock, [this] { return finishes_ || !queue_.empty(); });
      if (queue_.empty()) return;
      const auto end = queue_.begin() + static_cast<std::ptrdiff_t>(std::min(most_, queue_.size()));
      std::vector<Work> taken(std::make_move_iterator(queue_.begin()), std::make_move_iterator(end));
      queue_.erase(queue_.begin(), end);
      lock.unlock();
      work_(std::move(taken));
      lock.lock();
    }
  }

  const size_t most_;
  const std::function<void(std::vector<Work>)> work_;
  std::mutex mutex_;  // guards all below but the threads
  std::condition_variable added_;
  std::deque<Work> queue_;
  bool finishes_ = false;
  std::vector<std::jthread> threads_;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_API_CREW_H_
