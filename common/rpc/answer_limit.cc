#include "common/rpc/answer_limit.h"

#include <grpcpp/server.h>

#include <condition_variable>
#include <utility>

namespace tilemend {
namespace {

constexpr std::chrono::seconds kLongestAnswer(30);
constexpr std::chrono::seconds kBetweenLooks(5);

AnswerLimit& LimitOfProcess() {
  static AnswerLimit* const limit = new AnswerLimit(kLongestAnswer);  // threads of gRPC may outlive statics
  return *limit;
}

void BeginAnswer(const grpc::ServerContextBase& context) {
  LimitOfProcess().Begin(
      &context, [&context] { context.TryCancel(); }, std::chrono::steady_clock::now());
}

class WatchedCalls : public grpc::Server::GlobalCallbacks {
 public:
  void PreSynchronousRequest(grpc::ServerContext* context) override { BeginAnswer(*context); }
  void PostSynchronousRequest(grpc::ServerContext* context) override { LimitOfProcess().End(context); }
};

void Look(const std::stop_token& stop) {
  std::mutex mutex;
  std::condition_variable_any never;
  std::unique_lock<std::mutex> lock(mutex);
  while (!stop.stop_requested()) {
    never.wait_for(lock, stop, kBetweenLooks, [] { return false; });
    LimitOfProcess().CancelDue(std::chrono::steady_clock::now());
  }
}

}  // namespace

void AnswerLimit::Begin(const void* call, std::function<void()> cancel, Time now) {
  std::lock_guard<std::mutex> lock(mutex_);
  calls_[call] = {now, std::move(cancel)};
}

bool AnswerLimit::End(const void* call) {
  std::lock_guard<std::mutex> lock(mutex_);
  return calls_.erase(call) > 0;
}

size_t AnswerLimit::CancelDue(Time now) const {
  std::lock_guard<std::mutex> lock(mutex_);
  size_t due = 0;
  for (const auto& [key, call] : calls_) {
    if (now - call.begin < longest_) continue;
    ++due;
    call.cancel();
  }
  return due;
}

AnswerWatch::AnswerWatch() : thread_(Look) {
  static const bool is_set = [] {
    grpc::Server::SetGlobalCallbacks(new WatchedCalls);  // gRPC's from now on
    return true;
  }();
  static_cast<void>(is_set);
}

Answering::Answering(const grpc::ServerContextBase& context) : context_(context) { BeginAnswer(context); }

Answering::~Answering() { LimitOfProcess().End(&context_); }

Handling::Handling(const grpc::ServerContext& context)
    : context_(context), is_watched_(LimitOfProcess().End(&context)) {}

Handling::~Handling() {
  if (is_watched_) BeginAnswer(context_);
}

}  // namespace tilemend
