// Connections whose request is read and whose answer waits for something. They take no thread.
#ifndef TILEMEND_COMMON_HTTP_HELD_CONNECTIONS_H_
#define TILEMEND_COMMON_HTTP_HELD_CONNECTIONS_H_

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <thread>

#include "common/http/timed_connection.h"

namespace tilemend {

// When there are too many, the one that came first makes room and is woken. Thread-safe.
class HeldConnections {
 public:
  // As HttpAnswer::wait.
  using Wait = std::function<std::shared_ptr<void>(std::function<void()> wake)>;

  // `leave` is called on a thread of this with each connection that was woken, and may block.
  HeldConnections(size_t most, std::function<void(std::shared_ptr<TimedConnection>)> leave);
  // As Close.
  ~HeldConnections();

  // Holds the connection until `wait`'s function is called. If `most` others have been woken and cannot leave yet, it
  // is closed.
  void Hold(std::shared_ptr<TimedConnection> connection, const Wait& wait);
  // Closes all connections, and those that come from now on. Ends the thread.
  void Close();

 private:
  struct Guest {
    std::shared_ptr<TimedConnection> connection;
    std::shared_ptr<void> waits;  // let go without the lock: it may wait for a thread that wakes
  };
  // What those who wake may still know when this is gone.
  struct Shared {
    std::mutex mutex;
    std::condition_variable changed;
    uint64_t last = 0;
    std::map<uint64_t, Guest> held;  // the first first
    std::deque<Guest> woken;
    bool closed = false;

    void Wake(uint64_t number);  // needs the lock
  };

  void Run();

  const size_t most_;
  const std::function<void(std::shared_ptr<TimedConnection>)> leave_;
  const std::shared_ptr<Shared> shared_ = std::make_shared<Shared>();
  std::thread thread_;  // last: it uses the others
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_HTTP_HELD_CONNECTIONS_H_
