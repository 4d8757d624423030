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

#include "absl/strings/match.h"
#include "absl/strings/numbers.h"
#include "absl/strings/str_split.h"
#include "absl/strings/string_view.h"
#include "absl/time/clock.h"

namespace tilemend {
namespace {

// How often it is looked for connections whose time is over.
constexpr int kLookMilliseconds = 250;

constexpr std::string_view kHeadEnd = "\r\n\r\n";

// Bytes of a request; a longer one goes on to a thread, which reads or refuses it in its own time.
constexpr size_t kMostRequest = 8192;

// What the head says of the body; 0 if it says nothing that can be read.
size_t BodyLength(absl::string_view head) {
  for (const absl::string_view line : absl::StrSplit(head, "\r\n")) {
    const std::pair<absl::string_view, absl::string_view> field = absl::StrSplit(line, absl::MaxSplits(':', 1));
    size_t length = 0;
    if (absl::EqualsIgnoreCase(field.first, "content-length") && absl::SimpleAtoi(field.second, &length)) return length;
  }
  return 0;
}

bool IsWhole(std::string_view request, size_t most_body) {
  const size_t end = request.find(kHeadEnd);
  if (end == std::string_view::npos) return request.size() == kMostRequest;
  const size_t length = BodyLength({request.data(), end}), there = request.size() - end - kHeadEnd.size();
  return there >= length || length > most_body || request.size() == kMostRequest;
}

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
  std::array<char, kMostRequest> request{};
  const ssize_t count = recv(fd, request.data(), request.size(), MSG_PEEK | MSG_DONTWAIT);
  if (count < 0) return errno != EAGAIN && errno != EINTR;
  return count == 0 || !limits_.whole_request ||
         IsWhole({request.data(), static_cast<size_t>(count)}, limits_.body_bytes);
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
