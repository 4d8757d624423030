// Time, chance and the network of a simulated cluster: one queue of what happens next, no thread and no clock.
#ifndef TILEMEND_TESTS_COORDINATOR_STATE_SIMULATION_WORLD_H_
#define TILEMEND_TESTS_COORDINATOR_STATE_SIMULATION_WORLD_H_

#include <cstdint>
#include <functional>
#include <queue>
#include <string>
#include <utility>
#include <vector>

#include "absl/time/time.h"

namespace tilemend::simulation {

// The same on every machine; seeded in no time. https://prng.di.unimi.it/splitmix64.c
class Random {
 public:
  explicit Random(uint64_t seed) : state_(seed) {}
  uint64_t Next() {
    uint64_t z = state_ += 0x9e3779b97f4a7c15;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9;
    z = (z ^ z >> 27) * 0x94d049bb133111eb;
    return z ^ z >> 31;
  }
  int Draw(int below) { return static_cast<int>(Next() % static_cast<uint64_t>(below)); }
  bool Chance(int percent) { return Draw(100) < percent; }
  absl::Duration Time(int least_ms, int most_ms) { return absl::Milliseconds(least_ms + Draw(most_ms - least_ms + 1)); }

 private:
  uint64_t state_;
};

// A function of its input: what a good worker makes of a task, the input of one that comes after others.
inline std::string Mix(const std::string& text) {
  uint64_t hash = 0xcbf29ce484222325;  // FNV-1a
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  std::string mixed;
  for (int i = 0; i < 12; ++i) mixed.push_back("0123456789abcdef"[hash >> 4 * i & 15]);
  return mixed;
}

// A wrong result that no check refuses: only who computes it again can tell.
inline constexpr char kPlausible[] = "plausible";

// What may go wrong in a history, each in percent of the occasions; all 0 is a calm day.
struct Faults {
  int loss = 0, doubling = 0, delay = 0;               // of messages
  int partition = 0;                                   // of a worker, one way or both, each second
  int death = 0, freeze = 0;                           // of a worker, each second
  int crash = 0, pause = 0;                            // of the coordinator, each second
  int failing_store = 0;                               // of a commit; the coordinator ends by it
  int trouble = 0;                                     // of a task: a machine error
  bool liar = false, full_disk = false, slow = false;  // one of the workers is
  bool killer = false;                                 // one task takes its worker down
  bool poison = false;                                 // whoever does tasks of one job, its results are wrong
  bool cancel = false;                                 // the client cancels a job
  bool drain = false;                                  // workers leave in good order and come back
  bool swindler = false;                               // one of the workers gives wrong results that no check refuses
  bool prefetch = false;                               // workers hold tasks for which they have no thread yet
};

class World {
 public:
  World(uint64_t seed, const Faults& what_may_happen) : faults(what_may_happen), random(seed) {}

  absl::Time now() const { return now_; }
  void After(absl::Duration delay, std::function<void()> action) {
    events_.push({now_ + delay, ++last_event_, std::move(action)});
  }
  // Does what comes next; false if nothing does.
  bool Step() {
    if (events_.empty()) return false;
    Event event = std::move(const_cast<Event&>(events_.top()));
    events_.pop();
    now_ = event.time;
    event.action();
    return true;
  }
  // Delivers a message: later, twice or not at all.
  void Send(bool is_cut, const std::function<void()>& deliver) {
    if (is_cut || random.Chance(faults.loss)) return;
    const int copies = random.Chance(faults.doubling) ? 2 : 1;
    for (int i = 0; i < copies; ++i) {
      After(random.Chance(faults.delay) ? random.Time(100, 9000) : random.Time(1, 20), deliver);
    }
  }

  Faults faults;
  Random random;

 private:
  struct Event {
    absl::Time time;
    uint64_t number;
    std::function<void()> action;
    bool operator<(const Event& other) const { return time != other.time ? other.time < time : other.number < number; }
  };
  absl::Time now_ = absl::FromUnixSeconds(1'000'000);
  uint64_t last_event_ = 0;
  std::priority_queue<Event> events_;
};

}  // namespace tilemend::simulation

#endif  // TILEMEND_TESTS_COORDINATOR_STATE_SIMULATION_WORLD_H_
