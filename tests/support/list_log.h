// A log whose lines a test looks at.
#ifndef TILEMEND_TESTS_SUPPORT_LIST_LOG_H_
#define TILEMEND_TESTS_SUPPORT_LIST_LOG_H_

#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "common/util/log.h"

namespace tilemend {

class ListLog : public Log {
 public:
  void Write(LogLevel level, std::string_view event, const LogFields& fields) override {
    constexpr size_t kTime = 25;  // is left out
    std::lock_guard<std::mutex> lock(mutex_);
    lines_.push_back(LogLine(LogFormat::kText, absl::UnixEpoch(), level, event, fields).substr(kTime));
  }
  std::vector<std::string> lines() const {
    std::lock_guard<std::mutex> lock(mutex_);
    return lines_;
  }
  void clear() {
    std::lock_guard<std::mutex> lock(mutex_);
    lines_.clear();
  }

 private:
  mutable std::mutex mutex_;
  std::vector<std::string> lines_;
};

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_LIST_LOG_H_
