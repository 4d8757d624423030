// One connection of the web server that must come to its end in time, however slowly the other side speaks.
#ifndef TILEMEND_COMMON_HTTP_TIMED_CONNECTION_H_
#define TILEMEND_COMMON_HTTP_TIMED_CONNECTION_H_

#include <httplib.h>
#include <openssl/ssl.h>

#include <functional>
#include <memory>
#include <string>

#include "absl/time/time.h"

namespace tilemend {

// What a connection gets in all. A byte now and then does not make it longer.
struct ConnectionLimits {
  absl::Duration time = absl::Seconds(5);
  absl::Duration time_while_others_wait = absl::Milliseconds(250);  // until the answer begins
  size_t read_bytes = size_t{64} << 10;
  absl::Duration write_time_while_others_wait = absl::Milliseconds(250);  // once it has begun
};

// Reads and writes a socket, in plain text or over TLS, until it has had what it gets; then reads and writes fail.
class TimedConnection : public httplib::Stream {
 public:
  // Takes the socket `fd` and closes it in the end. `others_wait` may be called at any time while this lives.
  TimedConnection(int fd, ConnectionLimits limits, std::function<bool()> others_wait);
  ~TimedConnection() override;
  TimedConnection(const TimedConnection&) = delete;
  TimedConnection& operator=(const TimedConnection&) = delete;

  // Goes on over TLS. False if the other side does not, or not in time.
  bool Encrypt(SSL_CTX* context);

  bool is_readable() const override { return true; }
  bool is_writable() const override { return true; }
  ssize_t read(char* to, size_t size) override;
  ssize_t write(const char* from, size_t size) override;
  // Nothing is sent from now on: writes fail.
  void HoldAnswer() { holds_answer_ = true; }
  // After HoldAnswer: what was read is read once more, with all the time for it and for the answer.
  void Rewind();
  bool was_rewound() const { return was_rewound_; }
  // Of one that waits: another takes its place.
  void MakeRoom() { made_room_ = true; }
  bool made_room() const { return made_room_; }
  // The certificate that the other side has shown; null without one.
  std::unique_ptr<X509, void (*)(X509*)> PeerCertificate() const;

  void get_remote_ip_and_port(std::string& ip, int& port) const override;
  void get_local_ip_and_port(std::string& ip, int& port) const override;
  socket_t socket() const override { return fd_; }

 private:
  bool HasTime() const;
  // From now on the answer's limits count.
  void StartWriting() { allowed_while_others_wait_ = limits_.write_time_while_others_wait; }
  // Until the socket is ready for `events` (poll); false if there is no more time.
  bool AwaitReady(short events) const;  // NOLINT(google-runtime-int): as poll has it
  // Whether a call of TLS that gave `result` is to be repeated, after waiting for what it lacks.
  bool Again(int result) const;
  ssize_t ReadSome(char* to, size_t size);

  struct FreeSsl {
    void operator()(SSL* ssl) const { SSL_free(ssl); }
  };

  const int fd_;
  const ConnectionLimits limits_;
  const std::function<bool()> others_wait_;
  absl::Time begin_;
  absl::Duration allowed_while_others_wait_;
  std::unique_ptr<SSL, FreeSsl> ssl_;  // null: plain text
  std::string read_;                   // all that came: the server reads byte by byte, and perhaps twice
  size_t at_ = 0;                      // what of it is still to be read
  bool holds_answer_ = false, was_rewound_ = false, made_room_ = false;
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_HTTP_TIMED_CONNECTION_H_
