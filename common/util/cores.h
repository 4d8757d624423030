// Cores that the threads of a process share.
#ifndef TILEMEND_COMMON_UTIL_CORES_H_
#define TILEMEND_COMMON_UTIL_CORES_H_

#include <condition_variable>
#include <mutex>

namespace tilemend {

// So many cores. More threads than that may be at work as long as the others wait for something else: a disk, a
// network. Thread-safe.
class Cores {
 public:
  explicit Cores(int count) : free_(count) {}
  Cores(const Cores&) = delete;
  Cores& operator=(const Cores&) = delete;

  // A core for the thread that makes it, which waits until one is free. A thread holds at most one.
  class Held {
   public:
    explicit Held(Cores& cores);
    ~Held();
    Held(const Held&) = delete;
    Held& operator=(const Held&) = delete;
  };

 private:
  friend class LentCore;
  void Take();
  void Give();

  std::mutex mutex_;
  std::condition_variable freed_;
  int free_;
};

// Gives the core that this thread holds to others for as long as this lives; does nothing for a thread that holds none.
// For what waits: reading, writing and syncing files.
class LentCore {
 public:
  LentCore();
  ~LentCore();
  LentCore(const LentCore&) = delete;
  LentCore& operator=(const LentCore&) = delete;

 private:
  Cores* const cores_;
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_UTIL_CORES_H_
