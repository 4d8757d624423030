// Connections from which no request has come yet. They take no thread.
#ifndef TILEMEND_COMMON_HTTP_WAITING_ROOM_H_
#define TILEMEND_COMMON_HTTP_WAITING_ROOM_H_

#include <cstddef>
#include <functional>
#include <list>
#include <map>
#include <mutex>
#include <string>
#include <thread>

#include "absl/time/time.h"

namespace tilemend {

// One thread watches all of them. When there are too many, the one that came first is closed: who has something to ask
// does so at once. A head of more than 16 KB is answered 431 here. Thread-safe.
class WaitingRoom {
 public:
  struct Limits {
    size_t connections = 256;
    absl::Duration time = absl::Seconds(5);  // then a connection is closed
    size_t body_bytes = 4096;                // of a body that is waited for; a longer one is refused by the head
    bool whole_request = true;               // wait for its head and its body; false (TLS): for its first byte
  };

  // `leave` is called on the thread with each connection that has sent what it waits for; it takes the socket.
  WaitingRoom(Limits limits, std::function<void(int fd)> leave);
  // As Close.
  ~WaitingRoom();

  // Takes the socket.
  void Add(int fd);
  // Closes all connections, and those that come from now on. Ends the thread.
  void Close();

 private:
  struct Guest {
    int fd;
    absl::Time until;
  };
  using Guests = std::list<Guest>;

  // kAll: what is waited for, or it can send no more. kTooMuch: a head of more than 16 KB.
  enum class Sent { kPart, kAll, kTooMuch };

  void Watch();
  void TakeReady(int fd);
  void CloseOverdue();
  // These need the lock.
  Sent LookAt(int fd);
  void Forget(int fd);
  void CloseFirst();

  const Limits limits_;
  const std::function<void(int fd)> leave_;
  const int epoll_, wake_;
  std::mutex mutex_;
  std::string seen_;  // room for LookAt
  Guests guests_;     // the first first
  std::map<int, Guests::iterator> by_fd_;
  bool closed_ = false;
  std::thread thread_;  // last: it uses the others
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_HTTP_WAITING_ROOM_H_
