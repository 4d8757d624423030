// Takes connections for a server that must not run out of descriptors.
//
// gRPC 1.51 stops accepting for good after accept() failed once for want of a descriptor. So connections are accepted
// here, and beyond a number of open descriptors below the limit they are closed at once: the other side tries again.
#ifndef TILEMEND_COMMON_RPC_ACCEPTOR_H_
#define TILEMEND_COMMON_RPC_ACCEPTOR_H_

#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "absl/status/statusor.h"

namespace tilemend {

class Acceptor {
 public:
  // Listens on all addresses that `host` has; port 0 takes a free one. Nothing is accepted before Start. kUnavailable
  // if an address cannot be had.
  static absl::StatusOr<std::unique_ptr<Acceptor>> Listen(const std::string& host, int port);
  // Stops.
  ~Acceptor();

  int port() const { return port_; }
  // Gives each connection, as a non-blocking descriptor that is the taker's, to `take`, on a thread of its own.
  // Descriptors of `most` and more are closed instead: so many others are open then, since numbers are given out from
  // the lowest free one.
  void Start(int most, std::function<void(int)> take);
  // Stops listening. Safe to call twice.
  void Stop();

 private:
  Acceptor() = default;
  absl::Status Add(const void* address, unsigned size, int family);
  void Run(int most, const std::function<void(int)>& take);

  std::vector<int> listeners_;
  int wake_ = -1;
  int port_ = 0;
  std::thread thread_;
};

// How many descriptors connections may fill of those that the process may open (RLIMIT_NOFILE), and of a number that
// keeps their memory within bounds.
int MostDescriptorsOfConnections();

}  // namespace tilemend

#endif  // TILEMEND_COMMON_RPC_ACCEPTOR_H_
