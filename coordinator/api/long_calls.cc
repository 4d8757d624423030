#include "coordinator/api/long_calls.h"

#include <utility>

#include "absl/strings/str_cat.h"
#include "common/util/error_info.h"

namespace tilemend {

absl::StatusOr<std::unique_ptr<LongCalls::Call>> LongCalls::Enter(std::string job, absl::Time now,
                                                                  std::function<void()> stop) {
  std::lock_guard<std::mutex> lock(mutex_);
  if (entries_.size() >= most_) {
    return WithErrorInfo(
        absl::ResourceExhaustedError(absl::StrCat(most_,
                                                  " calls of this kind are running, which is the limit; try "
                                                  "again in a second")),
        {"TOO_MANY_CALLS", {{"limit", absl::StrCat(most_)}, {"retry_after_s", "1"}}});
  }
  entries_[++last_] = {std::move(job), now, std::move(stop)};
  return std::make_unique<Call>(*this, last_);
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
  entries_.erase(number);
}

}  // namespace tilemend
