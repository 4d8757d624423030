// Survey records between the check of a result and the job that takes it.
#ifndef TILEMEND_COORDINATOR_JOBS_DECODED_SURVEYS_H_
#define TILEMEND_COORDINATOR_JOBS_DECODED_SURVEYS_H_

#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <string>

#include "common/records/survey_record.h"
#include "coordinator/jobs/job_pipeline.h"

namespace tilemend {

// Keeps what the check of a survey has decoded, so that the job need not decode it again. Holds at most `max_bytes`: a
// record that does not fit is not kept. Jobs take their results in the order in which they came, so the oldest records
// are the next ones that are taken. Nobody takes those of results that came late or twice, or whose job was cancelled:
// a record is dropped after `max_age` calls of Put. Thread-safe.
class DecodedSurveys {
 public:
  explicit DecodedSurveys(size_t max_bytes = size_t{16} << 20, int64_t max_age = kMostTasksOut)
      : max_bytes_(max_bytes), max_age_(max_age) {}

  // `output` is the result that the record was decoded from.
  void Put(std::string output, SurveyRecord record);
  // The record that was decoded from these very bytes; none: they have to be decoded. Cost: O(records + bytes).
  std::optional<SurveyRecord> Take(const std::string& output);

 private:
  struct Entry {
    std::string output;
    SurveyRecord record;
    size_t bytes = 0;
    int64_t number = 0;  // of the call of Put
  };

  const size_t max_bytes_;
  const int64_t max_age_;
  std::mutex mutex_;
  std::deque<Entry> entries_;  // by number. Guarded by mutex_.
  size_t bytes_ = 0;           // of all entries. Guarded by mutex_.
  int64_t puts_ = 0;           // calls of Put so far. Guarded by mutex_.
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_DECODED_SURVEYS_H_
