#include "worker/service/coordinator_contact.h"

#include <utility>

#include "absl/strings/str_cat.h"

namespace tilemend {
namespace {

constexpr char kNotYet[] = "has not reached its coordinator yet";

}  // namespace

CoordinatorContact::CoordinatorContact(Log& log, WorkerMetrics& metrics)
    : log_(log), metrics_(metrics), unconnected_(kNotYet) {}

void CoordinatorContact::SetConnected(const absl::Status& status) {
  metrics_.SetConnected(status.ok());
  std::string reason = status.ok() ? "" : absl::StrCat("cannot reach its coordinator: ", status.message());
  std::lock_guard<std::mutex> lock(mutex_);
  if (reason.empty() && !unconnected_.empty()) log_.Info("connected");
  // Once for each time, however the reason changes; an address that is wrong is told of as well.
  if (!reason.empty() && (unconnected_.empty() || unconnected_ == kNotYet))
    log_.Warn("not connected", {{"reason", reason}});
  unconnected_ = std::move(reason);
}

void CoordinatorContact::SetAside(const std::string& reason) {
  std::lock_guard<std::mutex> lock(mutex_);
  if (reason == set_aside_) return;
  set_aside_ = reason;
  if (set_aside_.empty()) {
    log_.Info("gets tasks again");
  } else {
    log_.Error("set aside", {{"reason", set_aside_}});
  }
}

bool CoordinatorContact::is_connected() const {
  std::lock_guard<std::mutex> lock(mutex_);
  return unconnected_.empty();
}

std::string CoordinatorContact::WhyNotReady() const {
  std::lock_guard<std::mutex> lock(mutex_);
  return unconnected_.empty() ? set_aside_ : unconnected_;
}

}  // namespace tilemend
