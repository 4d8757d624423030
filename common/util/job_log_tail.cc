#include "common/util/job_log_tail.h"

#include <algorithm>

namespace tilemend {

void JobLogTail::Write(LogLevel level, std::string_view event, const LogFields& fields) {
  next_.Write(level, event, fields);
  const auto job = std::ranges::find(fields, "job", &LogField::key);
  if (job == fields.end()) return;
  std::string line = LogLine(LogFormat::kText, clock_(), level, event, fields);
  if (line.ends_with('\n')) line.pop_back();
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto known = std::ranges::find(jobs_, job->text, &JobLines::job);
  if (known != jobs_.end()) {
    jobs_.splice(jobs_.begin(), jobs_, known);
  } else {
    jobs_.push_front({job->text, {}});
    if (jobs_.size() > kMostJobs) jobs_.pop_back();
  }
  std::deque<std::string>& lines = jobs_.front().lines;
  lines.push_back(std::move(line));
  if (lines.size() > kMostLines) lines.pop_front();
}

std::vector<std::string> JobLogTail::LinesOf(const std::string& job) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto known = std::ranges::find(jobs_, job, &JobLines::job);
  if (known == jobs_.end()) return {};
  return {known->lines.begin(), known->lines.end()};
}

}  // namespace tilemend
