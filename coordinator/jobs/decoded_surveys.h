// Survey records between the check of a result and the job that takes it.
#ifndef TILEMEND_COORDINATOR_JOBS_DECODED_SURVEYS_H_
#define TILEMEND_COORDINATOR_JOBS_DECODED_SURVEYS_H_

#include <cstddef>
#include <deque>
#include <mutex>
#include <optional>
#include <string>

#include "common/records/survey_record.h"

namespace tilemend {

// Keeps what the check of a survey has decoded, so that the job need not decode it again. Holds at most `max_bytes`;
// the oldest records are dropped first, and a larger one is not kept. Thread-safe.
class DecodedSurveys {
 public:
  explicit DecodedSurveys(size_t max_bytes = size_t{16} << 20) : max_bytes_(max_bytes) {}

  // `output` is the result that the record was decoded from.
  void Put(std::string output, SurveyRecord record);
  // The record that was decoded from these very bytes; none: they have to be decoded. Cost: O(records + bytes).
  std::optional<SurveyRecord> Take(const std::string& output);

 private:
  struct Entry {
    std::string output;
    SurveyRecord record;
    size_t bytes = 0;
  };

  const size_t max_bytes_;
  std::mutex mutex_;
  std::deque<Entry> entries_;  // with the lock, as below
  size_t bytes_ = 0;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_DECODED_SURVEYS_H_
