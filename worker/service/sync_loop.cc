#include "worker/service/sync_loop.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "absl/random/random.h"
#include "common/rpc/limits.h"
#include "common/util/error_info.h"
#include "common/util/version.h"
#include "worker/service/worker_id.h"

namespace tilemend {
namespace {

absl::Duration HalfToAllOf(absl::Duration backoff) {
  absl::InsecureBitGen random;
  return backoff * absl::Uniform(random, 0.5, 1.0);
}

}  // namespace

SyncLoop::SyncLoop(const WorkerOptions& options, WorkLink& link, WorkerState& state, CoordinatorContact& contact)
    : options_(options),
      link_(link),
      state_(state),
      contact_(contact),
      secret_(NewSecret()),
      backoff_(options.first_backoff) {}

absl::Status SyncLoop::Run() {
  while (CallOnce()) {
  }
  return end_;
}

bool SyncLoop::CallOnce() {
  const std::unique_ptr<SyncCall> call = link_.NewSync();
  v1::SyncRequest request = NewRequest();
  std::optional<absl::StatusOr<v1::SyncResponse>> ended = state_.Call(*call, request);
  if (!ended) return false;
  absl::StatusOr<v1::SyncResponse>& response = *ended;
  const std::optional<absl::Duration> wait = RetryAfter(response.status());
  if (response.ok() || wait) {
    contact_.SetConnected(absl::OkStatus());
    backoff_ = options_.first_backoff;
    in_vain_ = absl::ZeroDuration();
  }
  if (wait) return state_.Pause(HalfToAllOf(2 * std::max(*wait, backoff_)));  // at least what is to be waited
  if (response.ok()) {
    const bool leave = response->leave();
    const std::string set_aside = response->set_aside();
    if (state_.Take(request, *std::move(response))) contact_.SetAside(set_aside);
    return !leave;
  }
  if (absl::IsCancelled(response.status()) || absl::IsAborted(response.status())) return true;  // call again
  return AfterFailure(response.status());
}

bool SyncLoop::AfterFailure(const absl::Status& status) {
  contact_.SetConnected(status);
  in_vain_ += backoff_;
  const std::string reason = ErrorReason(status);
  if (reason == "PROTOCOL_VERSION" || reason == "OTHER_BUILD" || absl::IsInvalidArgument(status) ||
      in_vain_ > options_.patience) {
    end_ = status;
    return false;
  }
  return state_.Pause(HalfToAllOf(std::exchange(backoff_, std::min(2 * backoff_, options_.max_backoff))));
}

v1::SyncRequest SyncLoop::NewRequest() {
  v1::SyncRequest request;
  request.set_protocol(kProtocolVersion);
  request.set_worker(options_.id);
  request.set_secret(secret_);
  request.set_release(Version());
  request.set_build(options_.build);
  request.set_sequence(++sequence_);
  request.set_wait_ms(static_cast<int32_t>(absl::ToInt64Milliseconds(kMaxPoll)));
  return request;
}

}  // namespace tilemend
