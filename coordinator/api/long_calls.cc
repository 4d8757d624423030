#include "coordinator/api/long_calls.h"

#include <algorithm>

#include "absl/strings/str_cat.h"
#include "common/util/error_info.h"

namespace tilemend {

absl::StatusOr<std::unique_ptr<LongCalls::Call>> LongCalls::Enter(std::string job, absl::Time now,
                                                                  std::function<void()> stop) {
  std::lock_guard<std::mutex> lock(mutex_);
  const bool is_full = entries_.size() - stopped_ >= most_;
  if (is_full && (when_full_ == WhenFull::kRefuse || entries_.size() >= 2 * most_)) {
    return WithErrorInfo(
        absl::ResourceExhaustedError(absl::StrCat(most_,
                                                  " calls of this kind are running, which is the limit; try "
                                                  "again in a second")),
        {"TOO_MANY_CALLS", {{"limit", absl::StrCat(most_)}, {"retry_after_s", "1"}}});
  }
  if (is_full) StopOldest();
  entries_[++last_] = {std::move(job), now, std::move(stop), false};
  return std::make_unique<Call>(*this, last_);
}

void LongCalls::StopOldest() {
  const auto is_older = [](const auto& a, const auto& b) {
    return std::pair(a.second.is_stopped, a.second.last) < std::pair(b.second.is_stopped, b.second.last);
  };
  Entry& oldest = std::min_element(entries_.begin(), entries_.end(), is_older)->second;
  oldest.is_stopped = true;
  ++stopped_;
  oldest.stop();
}

void LongCalls::Stop(absl::Time since, const std::function<bool(const std::string&)>& is_over) {
  std::lock_guard<std::mutex> lock(mutex_);
  for (const auto& [number, entry] : entries_) {
    if (entry.last < since || is_over(entry.job)) entry.stop();
  }
}

void LongCalls::Name(uint64_t number, std::string job) {
  std::lock_guard<std::mutex> lock(mutex_);
  entries_.at(number).job = std::move(job);
}

void LongCalls::Touch(uint64_t number, absl::Time now) {
  std::lock_guard<std::mutex> lock(mutex_);
  entries_.at(number).last = now;
}

void LongCalls::Leave(uint64_t number) {
  std::lock_guard<std::mutex> lock(mutex_);
  const auto entry = entries_.find(number);
  if (entry->second.is_stopped) --stopped_;
  entries_.erase(entry);
}

}  // namespace tilemend
