// A watch that its caller waits for.
#ifndef TILEMEND_TESTS_SUPPORT_WAITING_WATCH_H_
#define TILEMEND_TESTS_SUPPORT_WAITING_WATCH_H_

#include <functional>
#include <future>
#include <memory>
#include <utility>

#include "absl/status/status.h"
#include "coordinator/api/watch_handler.h"

namespace tilemend {

class WaitingWatch : private Watcher {
 public:
  // `send` returns false to go away.
  using SendNews = std::function<bool(const WatchNews&)>;
  using Question = std::function<absl::Status()>;
  WaitingWatch(WatchHandler& watches, SendNews send, Question go_on)
      : watches_(watches), send_(std::move(send)), go_on_(std::move(go_on)) {}

  absl::Status WatchJob(const v1::WatchJobRequest& request) { return AwaitEnd(watches_.WatchJob(request, watch_)); }
  absl::Status WatchDemand() { return AwaitEnd(watches_.WatchDemand(watch_)); }

 private:
  absl::Status GoOn() override { return go_on_(); }
  void Send(const WatchNews& news) override { send_(news) ? watches_.Sent(watch_) : watches_.Gone(watch_); }
  void End(const absl::Status& status) override {
    const auto end = end_;  // this may be gone before set_value has returned
    end->set_value(status);
  }
  absl::Status AwaitEnd(const absl::Status& start) { return start.ok() ? end_->get_future().get() : start; }

  WatchHandler& watches_;
  const SendNews send_;
  const Question go_on_;
  const std::shared_ptr<std::promise<absl::Status>> end_ = std::make_shared<std::promise<absl::Status>>();
  const std::shared_ptr<Watch> watch_ = NewWatch(*this);
};

inline absl::Status AlwaysOk() { return absl::OkStatus(); }

// Follows a job until it is over or `send` returns false.
inline absl::Status WatchAndWait(WatchHandler& watches, const v1::WatchJobRequest& request,
                                 const std::function<bool(const v1::Job&)>& send,
                                 const WaitingWatch::Question& go_on = AlwaysOk) {
  return WaitingWatch(
             watches, [&](const WatchNews& news) { return send(*news.job); }, go_on)
      .WatchJob(request);
}

// The same of the demand.
inline absl::Status WatchDemandAndWait(WatchHandler& watches, const std::function<bool(bool)>& send) {
  return WaitingWatch(
             watches, [&](const WatchNews& news) { return send(news.active); }, AlwaysOk)
      .WatchDemand();
}

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_WAITING_WATCH_H_
