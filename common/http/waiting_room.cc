#include "common/http/waiting_room.h"

#include <sys/epoll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <string_view>
#include <utility>
#include <vector>

#include "absl/time/clock.h"

namespace tilemend {
namespace {

// How often it is looked for connections whose time is over.
constexpr int kLookMilliseconds = 250;
// Of a head; a longer one goes on to a thread, which reads it in its own time.
constexpr size_t kMostHead = 8192;

}  // namespace

WaitingRoom::WaitingRoom(Limits limits, std::function<void(int fd)> leave)
    : limits_(limits),
      leave_(std::move(leave)),
      epoll_(epoll_create1(EPOLL_CLOEXEC)),
      wake_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)),
      thread_([this] { Watch(); }) {
  epoll_event event{.events = EPOLLIN, .data = {.fd = wake_}};
  epoll_ctl(epoll_, EPOLL_CTL_ADD, wake_, &event);
}

WaitingRoom::~WaitingRoom() {
  Close();
  close(epoll_);
  close(wake_);
}

void WaitingRoom::Add(int fd) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (closed_) {
    close(fd);
    return;
  }
  if (guests_.size() >= limits_.connections) CloseFirst();
  by_fd_[fd] = guests_.insert(guests_.end(), {fd, absl::Now() + limits_.time});
  // With each byte that comes, and not while nothing does.
  epoll_event event{.events = EPOLLIN | EPOLLRDHUP | EPOLLET, .data = {.fd = fd}};
  epoll_ctl(epoll_, EPOLL_CTL_ADD, fd, &event);
}

void WaitingRoom::Close() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    closed_ = true;
  }
  eventfd_write(wake_, 1);
  if (thread_.joinable()) thread_.join();
  while (!guests_.empty()) CloseFirst();
}

void WaitingRoom::CloseFirst() {
  by_fd_.erase(guests_.front().fd);
  close(guests_.front().fd);
  guests_.pop_front();
}

void WaitingRoom::CloseOverdue() {
  const absl::Time now = absl::Now();
  const std::lock_guard<std::mutex> lock(mutex_);
  while (!guests_.empty() && guests_.front().until <= now) CloseFirst();
}

bool WaitingRoom::IsReady(int fd) const {
  std::array<char, kMostHead> head{};
  const ssize_t count = recv(fd, head.data(), head.size(), MSG_PEEK | MSG_DONTWAIT);
  if (count < 0) return errno != EAGAIN && errno != EINTR;
  if (count == 0 || !limits_.whole_head || static_cast<size_t>(count) == head.size()) return true;
  return std::string_view(head.data(), static_cast<size_t>(count)).find("\r\n\r\n") != std::string_view::npos;
}

void WaitingRoom::TakeReady(int fd) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto known = by_fd_.find(fd);
    if (known == by_fd_.end() || !IsReady(fd)) return;
    epoll_ctl(epoll_, EPOLL_CTL_DEL, fd, nullptr);
    guests_.erase(known->second);
    by_fd_.erase(known);
  }
  leave_(fd);
}

void WaitingRoom::Watch() {
  std::array<epoll_event, 64> events{};
  while (true) {
    const int count = epoll_wait(epoll_, events.data(), static_cast<int>(events.size()), kLookMilliseconds);
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (closed_) return;
    }
    for (int k = 0; k < count; ++k) TakeReady(events[static_cast<size_t>(k)].data.fd);
    CloseOverdue();
  }
}

}  // namespace tilemend
