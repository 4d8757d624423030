// An end to calls whose answer nobody takes.
//
// A thread of gRPC holds a call until its answer is on the way, so a caller that reads nothing holds the thread. As
// many such callers as the server has calls at once, and nobody else is served.
#ifndef TILEMEND_COMMON_RPC_ANSWER_LIMIT_H_
#define TILEMEND_COMMON_RPC_ANSWER_LIMIT_H_

#include <grpcpp/server_context.h>

#include <chrono>
#include <cstddef>
#include <functional>
#include <map>
#include <mutex>
#include <thread>

namespace tilemend {

// Thread-safe.
class AnswerLimit {
 public:
  using Time = std::chrono::steady_clock::time_point;

  explicit AnswerLimit(std::chrono::seconds longest) : longest_(longest) {}

  // `cancel` is called, with the lock of this held, if the call is not over `longest` after `now`.
  void Begin(const void* call, std::function<void()> cancel, Time now);
  // Nothing is done to the call any more. Whether it had begun.
  bool End(const void* call);
  // Cancels calls that are due, again each time. How many those were.
  size_t CancelDue(Time now) const;

 private:
  struct Call {
    Time begin;
    std::function<void()> cancel;
  };
  const std::chrono::seconds longest_;
  mutable std::mutex mutex_;
  std::map<const void*, Call> calls_;
};

// Works while a server of the process runs. Calls end half a minute after their handler, which is as long as our own
// callers wait. If no Handling is reported, they end half a minute after they began. Made before the first server of
// the process.
class AnswerWatch {
 public:
  AnswerWatch();

 private:
  std::jthread thread_;
};

// From the last word of a call that has no thread to its end: the caller has half a minute to take the answer.
class Answering {
 public:
  explicit Answering(const grpc::ServerContextBase& context);
  ~Answering();
  Answering(const Answering&) = delete;
  Answering& operator=(const Answering&) = delete;

 private:
  const grpc::ServerContextBase& context_;
};

// Where a handler is at work, which bounds itself. The answer is watched if the call was.
class Handling {
 public:
  explicit Handling(const grpc::ServerContext& context);
  ~Handling();
  Handling(const Handling&) = delete;
  Handling& operator=(const Handling&) = delete;

 private:
  const grpc::ServerContext& context_;
  const bool is_watched_;
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_RPC_ANSWER_LIMIT_H_
