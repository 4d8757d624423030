// A watch over gRPC, by its callback API: no thread waits for it.
#ifndef TILEMEND_COORDINATOR_API_WATCH_REACTOR_H_
#define TILEMEND_COORDINATOR_API_WATCH_REACTOR_H_

#include <grpcpp/server_context.h>
#include <grpcpp/support/server_callback.h>

#include <memory>
#include <mutex>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>

#include "absl/status/status.h"
#include "absl/time/clock.h"
#include "absl/time/time.h"
#include "common/rpc/answer_limit.h"
#include "common/rpc/grpc_status.h"
#include "coordinator/api/guarded_calls.h"
#include "coordinator/api/watch_handler.h"
#include "externalscaler/externalscaler.pb.h"
#include "tilemend/v1/jobs.pb.h"

namespace tilemend {

template <class Message>
std::shared_ptr<const Message> MessageOf(const WatchNews& news) {
  if constexpr (std::is_same_v<Message, v1::Job>) {
    return news.job;
  } else {
    auto message = std::make_shared<Message>();
    message->set_result(news.active);
    return message;
  }
}

// Deletes itself when gRPC is done with the call.
template <class Message>
class WatchReactor : public grpc::ServerWriteReactor<Message>, private Watcher {
 public:
  // All must outlive the call.
  WatchReactor(const Entrance& entrance, WatchHandler& watches, const grpc::CallbackServerContext& context, Peer peer,
               const char* rpc)
      : entrance_(entrance), watches_(watches), context_(context), peer_(std::move(peer)), rpc_(rpc) {}

  // `start` hands the watch to the handler, or gives an error.
  template <class Start>
  void Begin(Start start) {
    const auto caller = entrance_.Begin(peer_, rpc_);
    const absl::Status status = caller.ok() ? start(watch_) : caller.status();
    if (!status.ok()) End(status);
  }

 private:
  // What the handler calls.
  absl::Status GoOn() override { return entrance_.MayGoOn(peer_, rpc_); }
  void Send(const WatchNews& news) override {
    {
      std::lock_guard<std::mutex> lock(mutex_);
      is_writing_ = true;
    }
    message_ = MessageOf<Message>(news);
    this->StartWrite(message_.get());
  }
  void End(const absl::Status& status) override {
    entrance_.End(rpc_, status, begin_);
    {
      std::lock_guard<std::mutex> lock(mutex_);
      answering_.emplace(context_);
      end_ = status;
      if (is_writing_) return;
    }
    this->Finish(ToGrpcStatus(status));
  }

  // What gRPC calls.
  void OnWriteDone(bool is_sent) override {
    std::optional<absl::Status> end;
    {
      std::lock_guard<std::mutex> lock(mutex_);
      is_writing_ = false;
      end = end_;
    }
    if (end) return this->Finish(ToGrpcStatus(*end));
    is_sent ? watches_.Sent(watch_) : watches_.Gone(watch_);
  }
  void OnCancel() override { watches_.Gone(watch_); }
  void OnDone() override { delete this; }

  const Entrance& entrance_;
  WatchHandler& watches_;
  const grpc::CallbackServerContext& context_;
  const Peer peer_;
  const char* const rpc_;
  const absl::Time begin_ = absl::Now();
  const std::shared_ptr<Watch> watch_ = NewWatch(*this);
  std::shared_ptr<const Message> message_;  // that is being written
  std::mutex mutex_;                        // guards all below
  bool is_writing_ = false;
  std::optional<absl::Status> end_;
  std::optional<Answering> answering_;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_API_WATCH_REACTOR_H_
