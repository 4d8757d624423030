#include "coordinator/jobs/decoded_surveys.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace tilemend {
namespace {

template <typename T>
size_t BytesOf(const std::vector<T>& values) {
  return values.size() * sizeof(T);
}

size_t BytesOf(const SurveyRecord& record) {
  return sizeof(record) + BytesOf(record.vertices) + BytesOf(record.edges) + BytesOf(record.band.points) +
         BytesOf(record.band.triangles) + BytesOf(record.colours);
}

}  // namespace

void DecodedSurveys::Put(std::string output, SurveyRecord record) {
  const size_t bytes = output.size() + BytesOf(record);
  const std::lock_guard<std::mutex> lock(mutex_);
  ++puts_;
  for (; !entries_.empty() && puts_ - entries_.front().number > max_age_; entries_.pop_front()) {
    bytes_ -= entries_.front().bytes;
  }
  if (bytes > max_bytes_ - bytes_) return;
  entries_.push_back({std::move(output), std::move(record), bytes, puts_});
  bytes_ += bytes;
}

std::optional<SurveyRecord> DecodedSurveys::Take(const std::string& output) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto entry = std::ranges::find(entries_, output, &Entry::output);
  if (entry == entries_.end()) return std::nullopt;
  SurveyRecord record = std::move(entry->record);
  bytes_ -= entry->bytes;
  entries_.erase(entry);
  return record;
}

}  // namespace tilemend
