#include "common/service/service_notifier.h"

#include <systemd/sd-daemon.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <utility>

namespace tilemend {
namespace {

constexpr std::chrono::microseconds kUsualInterval = std::chrono::seconds(2);

// Half of what the watchdog allows, as systemd asks for.
std::chrono::microseconds Interval() {
  uint64_t allowed_us = 0;
  if (sd_watchdog_enabled(0, &allowed_us) <= 0) return kUsualInterval;
  return std::min(kUsualInterval, std::chrono::microseconds(allowed_us / 2));
}

}  // namespace

ServiceNotifier::ServiceNotifier(std::function<std::string()> status) : status_(std::move(status)) {
  if (std::getenv("NOTIFY_SOCKET") == nullptr) return;
  sd_notify(0, "READY=1");
  thread_ = std::thread([this, interval = Interval()] { Run(interval); });
}

ServiceNotifier::~ServiceNotifier() {
  if (!thread_.joinable()) return;
  sd_notify(0, "STOPPING=1");
  {
    std::lock_guard<std::mutex> lock(mutex_);
    end_ = true;
  }
  ended_.notify_all();
  thread_.join();
}

void ServiceNotifier::Run(std::chrono::microseconds interval) {
  std::unique_lock<std::mutex> lock(mutex_);
  while (!end_) {
    lock.unlock();
    const std::string status = status_();
    sd_notifyf(0, "WATCHDOG=1\nSTATUS=%s", status.c_str());
    lock.lock();
    ended_.wait_for(lock, interval, [this] { return end_; });
  }
}

}  // namespace tilemend
