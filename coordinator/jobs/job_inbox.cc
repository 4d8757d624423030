#include "coordinator/jobs/job_inbox.h"

#include <utility>

#include "absl/strings/cord.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

constexpr char kBegunAgain[] = "begun-again";

bool IsBegunAgain(const absl::Status& status) { return status.GetPayload(kBegunAgain).has_value(); }

// What ends the pipeline, if anything does.
absl::Status EndOf(const std::stop_source& cancel, const absl::Status& failure) {
  return cancel.stop_requested() ? absl::CancelledError("the job was cancelled") : failure;
}

}  // namespace

absl::Status BegunAgain() {
  absl::Status status = absl::AbortedError("the job begins again");
  status.SetPayload(kBegunAgain, absl::Cord());
  return status;
}

void JobInbox::Deliver(SettledTask task, std::optional<std::string> content) {
  std::lock_guard<std::mutex> lock(mutex_);
  if (cancel_.stop_requested()) return;
  if (content.has_value()) queued_bytes_ += content->size();
  deliveries_.push_back({std::move(task), std::move(content)});
  changed_.notify_one();
}

void JobInbox::Fail(absl::Status error) {
  std::lock_guard<std::mutex> lock(mutex_);
  if (failure_.ok() || !IsBegunAgain(error)) failure_ = std::move(error);
  changed_.notify_one();
}

bool JobInbox::Cancel() {
  std::lock_guard<std::mutex> lock(mutex_);
  if (cancel_.stop_requested()) return true;
  if (too_late_ || (pipeline_ != nullptr && !pipeline_->Cancel())) return false;
  cancel_.request_stop();
  changed_.notify_one();
  return true;
}

absl::Status JobInbox::Wait(std::chrono::milliseconds time) {
  std::unique_lock<std::mutex> lock(mutex_);
  changed_.wait_for(lock, time, [this] { return !EndOf(cancel_, failure_).ok(); });
  return EndOf(cancel_, failure_);
}

absl::StatusOr<std::deque<JobInbox::Delivery>> JobInbox::Next() {
  std::unique_lock<std::mutex> lock(mutex_);
  changed_.wait(lock, [this] { return !EndOf(cancel_, failure_).ok() || !deliveries_.empty(); });
  TILEMEND_RETURN_IF_ERROR(EndOf(cancel_, failure_));
  return std::exchange(deliveries_, {});
}

absl::Status JobInbox::Begin(const Delivery& delivery) {
  std::lock_guard<std::mutex> lock(mutex_);
  TILEMEND_RETURN_IF_ERROR(EndOf(cancel_, failure_));
  if (delivery.content.has_value()) queued_bytes_ -= delivery.content->size();
  return absl::OkStatus();
}

absl::Status JobInbox::SetPipeline(JobPipeline& pipeline) {
  std::lock_guard<std::mutex> lock(mutex_);
  if (cancel_.stop_requested()) return EndOf(cancel_, failure_);
  pipeline_ = &pipeline;
  return absl::OkStatus();
}

bool JobInbox::BeginsAgain() {
  std::lock_guard<std::mutex> lock(mutex_);
  if (!IsBegunAgain(failure_) || cancel_.stop_requested()) return false;
  pipeline_ = nullptr;
  return true;
}

void JobInbox::Restart() {
  std::lock_guard<std::mutex> lock(mutex_);
  deliveries_.clear();
  queued_bytes_ = 0;
  if (IsBegunAgain(failure_)) failure_ = absl::OkStatus();
}

JobInbox::End JobInbox::Close(bool may_begin_again) {
  std::lock_guard<std::mutex> lock(mutex_);
  const bool is_cancelled = cancel_.stop_requested();
  if (may_begin_again && IsBegunAgain(failure_) && !is_cancelled) return End::kBeginsAgain;
  pipeline_ = nullptr;
  too_late_ = !is_cancelled;
  return is_cancelled ? End::kCancelled : End::kDone;
}

}  // namespace tilemend
