#include "common/http/waiting_room.h"

#include <sys/epoll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <string_view>
#include <utility>

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

// Bytes of a head, as Node.js has it by default. The library refuses a line of more than 8,192.
constexpr size_t kMostHead = 16384;

constexpr std::string_view kHeadTooLong =
    "HTTP/1.1 431 Request Header Fields Too Large\r\nContent-Type: text/plain; charset=utf-8\r\n"
    "Content-Length: 40\r\nConnection: close\r\n\r\nthe head of a request has at most 16 KB\n";

// What the head says of the body; 0 if it says nothing that can be read: the server refuses it by the head then, or
// there is none.
size_t BodyLength(absl::string_view head) {
  for (const absl::string_view line : absl::StrSplit(head, "\r\n")) {
    const std::pair<absl::string_view, absl::string_view> field = absl::StrSplit(line, absl::MaxSplits(':', 1));
    size_t length = 0;
    if (absl::EqualsIgnoreCase(field.first, "content-length") && absl::SimpleAtoi(field.second, &length)) return length;
  }
  return 0;
}

// `end`: of the head.
bool IsWhole(std::string_view request, size_t end, size_t most_body) {
  const size_t length = BodyLength({request.data(), end}), there = request.size() - end - kHeadEnd.size();
  return there >= length || length > most_body;
}

// Says so, as far as that goes at once. What has come is read, since the connection would else be reset.
void RefuseHead(int fd, std::string& buffer) {
  recv(fd, buffer.data(), buffer.size(), MSG_DONTWAIT);
  send(fd, kHeadTooLong.data(), kHeadTooLong.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
  shutdown(fd, SHUT_WR);
}

}  // namespace

WaitingRoom::WaitingRoom(Limits limits, std::function<void(int fd)> leave)
    : limits_(limits),
      leave_(std::move(leave)),
      epoll_(epoll_create1(EPOLL_CLOEXEC)),
      wake_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)),
      seen_(kMostHead + kHeadEnd.size() + limits.body_bytes, '\0'),
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
  const int fd = guests_.front().fd;
  Forget(fd);
  close(fd);
}

void WaitingRoom::Forget(int fd) {
  const auto known = by_fd_.find(fd);
  guests_.erase(known->second);
  by_fd_.erase(known);
}

void WaitingRoom::CloseOverdue() {
  const absl::Time now = absl::Now();
  const std::lock_guard<std::mutex> lock(mutex_);
  while (!guests_.empty() && guests_.front().until <= now) CloseFirst();
}

WaitingRoom::Sent WaitingRoom::LookAt(int fd) {
  const ssize_t count = recv(fd, seen_.data(), seen_.size(), MSG_PEEK | MSG_DONTWAIT);
  if (count < 0) return errno == EAGAIN || errno == EINTR ? Sent::kPart : Sent::kAll;
  if (count == 0 || !limits_.whole_request) return Sent::kAll;
  const std::string_view request(seen_.data(), static_cast<size_t>(count));
  const size_t end = request.find(kHeadEnd);
  if (std::min(end, request.size()) > kMostHead) return Sent::kTooMuch;
  return end != std::string_view::npos && IsWhole(request, end, limits_.body_bytes) ? Sent::kAll : Sent::kPart;
}

void WaitingRoom::TakeReady(int fd) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!by_fd_.contains(fd)) return;
    const Sent sent = LookAt(fd);
    if (sent == Sent::kPart) return;
    Forget(fd);
    if (sent == Sent::kTooMuch) {
      RefuseHead(fd, seen_);
      close(fd);
      return;
    }
    epoll_ctl(epoll_, EPOLL_CTL_DEL, fd, nullptr);
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
