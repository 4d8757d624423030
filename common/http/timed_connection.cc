#include "common/http/timed_connection.h"

#include <fcntl.h>
#include <netdb.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "absl/time/clock.h"

namespace tilemend {
namespace {

// How often it is looked whether others have come.
constexpr int kLookMilliseconds = 50;

}  // namespace

TimedConnection::TimedConnection(int fd, ConnectionLimits limits, std::function<bool()> others_wait)
    : fd_(fd),
      limits_(limits),
      others_wait_(std::move(others_wait)),
      begin_(absl::Now()),
      allowed_while_others_wait_(limits.time_while_others_wait) {
  fcntl(fd_, F_SETFL, fcntl(fd_, F_GETFL) | O_NONBLOCK);
}

TimedConnection::~TimedConnection() {
  if (ssl_ != nullptr) SSL_shutdown(ssl_.get());  // says that this is the end, and does not wait for an answer
  shutdown(fd_, SHUT_RDWR);
  close(fd_);
}

bool TimedConnection::HasTime() const {
  return absl::Now() - begin_ < (others_wait_() ? allowed_while_others_wait_ : limits_.time);
}

bool TimedConnection::AwaitReady(short events) const {  // NOLINT(google-runtime-int)
  while (HasTime()) {
    pollfd waited{fd_, events, 0};
    const int ready = poll(&waited, 1, kLookMilliseconds);
    if (ready > 0) return true;
    if (ready < 0 && errno != EINTR) return false;
  }
  return false;
}

bool TimedConnection::Again(int result) const {
  switch (SSL_get_error(ssl_.get(), result)) {
    case SSL_ERROR_WANT_READ:
      return AwaitReady(POLLIN);
    case SSL_ERROR_WANT_WRITE:
      return AwaitReady(POLLOUT);
    default:
      return false;
  }
}

bool TimedConnection::Encrypt(SSL_CTX* context) {
  ssl_.reset(SSL_new(context));
  if (ssl_ == nullptr || SSL_set_fd(ssl_.get(), fd_) != 1) return false;
  int result = 0;
  do {
    result = SSL_accept(ssl_.get());
  } while (result != 1 && Again(result));
  return result == 1;
}

ssize_t TimedConnection::ReadSome(char* to, size_t size) {
  if (ssl_ != nullptr) {
    int count = 0;
    do {
      count = SSL_read(ssl_.get(), to, static_cast<int>(size));
    } while (count <= 0 && Again(count));
    return std::max(count, -1);
  }
  ssize_t count = 0;
  do {
    count = recv(fd_, to, size, 0);
  } while (count < 0 && (errno == EINTR || (errno == EAGAIN && AwaitReady(POLLIN))));
  return count;
}

ssize_t TimedConnection::read(char* to, size_t size) {
  if (at_ == read_.size()) {
    if (read_.size() >= limits_.read_bytes || !HasTime()) return -1;
    std::array<char, 4096> part{};
    const ssize_t count = ReadSome(part.data(), part.size());
    if (count <= 0) return count;
    read_.append(part.data(), static_cast<size_t>(count));
  }
  const size_t given = std::min(size, read_.size() - at_);
  std::memcpy(to, read_.data() + at_, given);
  at_ += given;
  return static_cast<ssize_t>(given);
}

void TimedConnection::Rewind() {
  at_ = 0;
  begin_ = absl::Now();
  allowed_while_others_wait_ = limits_.time_while_others_wait;
  holds_answer_ = false;
  was_rewound_ = true;
}

ssize_t TimedConnection::write(const char* from, size_t size) {
  if (holds_answer_) return -1;
  StartWriting();
  if (!HasTime()) return -1;
  if (ssl_ != nullptr) {
    int count = 0;
    do {
      count = SSL_write(ssl_.get(), from, static_cast<int>(size));
    } while (count <= 0 && Again(count));
    return std::max(count, -1);
  }
  ssize_t count = 0;
  do {
    count = send(fd_, from, size, MSG_NOSIGNAL);
  } while (count < 0 && (errno == EINTR || (errno == EAGAIN && AwaitReady(POLLOUT))));
  return count;
}

std::unique_ptr<X509, void (*)(X509*)> TimedConnection::PeerCertificate() const {
  return {ssl_ == nullptr ? nullptr : SSL_get1_peer_certificate(ssl_.get()), X509_free};
}

void TimedConnection::get_remote_ip_and_port(std::string& ip, int& port) const {
  sockaddr_storage address{};
  socklen_t length = sizeof(address);
  std::array<char, NI_MAXHOST> host{};
  std::array<char, NI_MAXSERV> service{};
  auto* const any = reinterpret_cast<sockaddr*>(&address);
  if (getpeername(fd_, any, &length) != 0 || getnameinfo(any, length, host.data(), host.size(), service.data(),
                                                         service.size(), NI_NUMERICHOST | NI_NUMERICSERV) != 0) {
    return;
  }
  ip = host.data();
  port = std::atoi(service.data());  // NOLINT(cert-err34-c): the library writes a number
}
void TimedConnection::get_local_ip_and_port(std::string&, int&) const {}

}  // namespace tilemend
