// A log that passes its lines on, and keeps the last ones on each job.
#ifndef TILEMEND_COMMON_UTIL_JOB_LOG_TAIL_H_
#define TILEMEND_COMMON_UTIL_JOB_LOG_TAIL_H_

#include <cstddef>
#include <deque>
#include <functional>
#include <list>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "absl/time/clock.h"
#include "absl/time/time.h"
#include "common/util/log.h"

namespace tilemend {

// Lines are of a job if they have a field "job". 5 MB at most, with lines of 500 bytes. Thread-safe.
class JobLogTail : public Log {
 public:
  static constexpr size_t kMostLines = 100;  // of one job
  static constexpr size_t kMostJobs = 100;   // those with the last lines

  // `next` must outlive this.
  explicit JobLogTail(Log& next, std::function<absl::Time()> clock = absl::Now)
      : next_(next), clock_(std::move(clock)) {}

  void Write(LogLevel level, std::string_view event, const LogFields& fields) override;
  // As text (LogLine) without line ends, the oldest first.
  std::vector<std::string> LinesOf(const std::string& job) const;

 private:
  struct JobLines {
    std::string job;
    std::deque<std::string> lines;
  };

  Log& next_;
  const std::function<absl::Time()> clock_;
  mutable std::mutex mutex_;
  std::list<JobLines> jobs_;  // that with the last line first
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_UTIL_JOB_LOG_TAIL_H_
