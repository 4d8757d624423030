#include "common/rpc/acceptor.h"

#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "absl/strings/match.h"
#include "absl/strings/str_cat.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

constexpr int kBacklog = 4096;
constexpr int kPauseMs = 50;  // after accept() failed for want of something
// Of some 20 kB each.
constexpr int kMostConnections = 4096;

int SetPort(sockaddr_storage& address, int port) {
  auto* v4 = reinterpret_cast<sockaddr_in*>(&address);
  auto* v6 = reinterpret_cast<sockaddr_in6*>(&address);
  in_port_t& place = address.ss_family == AF_INET6 ? v6->sin6_port : v4->sin_port;
  if (port >= 0) place = htons(static_cast<uint16_t>(port));
  return ntohs(place);
}

absl::Status Refused(const std::string& why) { return absl::UnavailableError(why); }

}  // namespace

absl::StatusOr<std::unique_ptr<Acceptor>> Acceptor::Listen(const std::string& host, int port) {
  std::string name = host;
  if (absl::StartsWith(name, "[") && absl::EndsWith(name, "]")) name = name.substr(1, name.size() - 2);
  addrinfo hints{};
  hints.ai_socktype = SOCK_STREAM;
  hints.ai_flags = AI_PASSIVE;
  addrinfo* found = nullptr;
  if (const int error = getaddrinfo(name.c_str(), nullptr, &hints, &found); error != 0) {
    return Refused(gai_strerror(error));
  }
  const std::unique_ptr<addrinfo, decltype(&freeaddrinfo)> addresses(found, freeaddrinfo);
  std::unique_ptr<Acceptor> acceptor(new Acceptor());
  acceptor->port_ = port;
  acceptor->wake_ = eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
  if (acceptor->wake_ < 0) return Refused(std::strerror(errno));
  absl::Status last = Refused("no address");
  for (const addrinfo* at = found; at != nullptr; at = at->ai_next) {
    const absl::Status added = acceptor->Add(at->ai_addr, at->ai_addrlen, at->ai_family);
    if (!added.ok()) last = added;
    // A machine without IPv6 has a name for it all the same; a port that is taken is taken.
    if (!added.ok() && acceptor->listeners_.empty() && at->ai_next == nullptr) return last;
  }
  if (acceptor->listeners_.empty()) return last;
  return acceptor;
}

absl::Status Acceptor::Add(const void* address, unsigned size, int family) {
  sockaddr_storage own{};
  std::memcpy(&own, address, std::min<size_t>(size, sizeof(own)));
  SetPort(own, port_);
  const int fd = socket(family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (fd < 0) return Refused(std::strerror(errno));
  const int yes = 1;
  setsockopt(fd, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof(yes));  // what an earlier process left is no hindrance
  socklen_t length = sizeof(own);
  if (bind(fd, reinterpret_cast<const sockaddr*>(&own), size) != 0 || listen(fd, kBacklog) != 0 ||
      getsockname(fd, reinterpret_cast<sockaddr*>(&own), &length) != 0) {
    const int error = errno;
    close(fd);
    return Refused(std::strerror(error));
  }
  port_ = SetPort(own, -1);
  listeners_.push_back(fd);
  return absl::OkStatus();
}

Acceptor::~Acceptor() {
  Stop();
  if (wake_ >= 0) close(wake_);
}

void Acceptor::Start(int most, std::function<void(int)> take) {
  thread_ = std::thread([this, most, take = std::move(take)] { Run(most, take); });
}

void Acceptor::Stop() {
  if (thread_.joinable()) {
    eventfd_write(wake_, 1);
    thread_.join();
  }
  for (const int fd : std::exchange(listeners_, {})) close(fd);
}

void Acceptor::Run(int most, const std::function<void(int)>& take) {
  std::vector<pollfd> polled = {{wake_, POLLIN, 0}};
  for (const int fd : listeners_) polled.push_back({fd, POLLIN, 0});
  bool is_short = false;  // of descriptors or memory
  while (true) {
    // Short of something, the listeners stay ready: only the way out is waited for.
    const int ready = poll(polled.data(), is_short ? 1 : polled.size(), is_short ? kPauseMs : -1);
    if (polled[0].revents != 0) return;
    if (ready < 0 && errno != EINTR) is_short = true;
    if (ready == 0) is_short = false;
    for (size_t i = 1; i < polled.size() && !is_short; ++i) {
      const int fd = accept4(polled[i].fd, nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK);
      if (fd < 0) {
        is_short = errno == EMFILE || errno == ENFILE || errno == ENOBUFS || errno == ENOMEM;
        continue;
      }
      const int yes = 1;
      setsockopt(fd, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof(yes));
      fd < most ? take(fd) : static_cast<void>(close(fd));
    }
  }
}

int MostDescriptorsOfConnections() {
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0) return kMostConnections;
  const auto all = static_cast<int64_t>(std::min<rlim_t>(limit.rlim_cur, 1 << 20));
  return static_cast<int>(std::min<int64_t>(all - std::max<int64_t>(all / 4, 8), kMostConnections));
}

}  // namespace tilemend
