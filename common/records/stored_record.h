// A survey record that may lie elsewhere than in memory.
#ifndef TILEMEND_COMMON_RECORDS_STORED_RECORD_H_
#define TILEMEND_COMMON_RECORDS_STORED_RECORD_H_

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "common/records/survey_record.h"

namespace tilemend {

// A handle on a record: the summary is always there, the rest is read for as long as somebody holds it. A null handle
// stands for a cell without surface.
//
//   const auto record = stored.Outline();  // hold it while you look at vertices and edges
//   Use(stored->lo, record->vertices);
//
// Copies share one record. Thread-safe if what reads is.
class StoredRecord {
 public:
  using Pointer = std::shared_ptr<const SurveyRecord>;
  // Never null. The band may be missing unless it is asked for. What fails to read throws.
  using Read = std::function<Pointer(bool with_band)>;

  StoredRecord(std::nullptr_t = nullptr) {}  // NOLINT: as a pointer
  // In memory, where the record must outlive the handle.
  StoredRecord(const SurveyRecord* record) : record_(Pointer(), record) {}  // NOLINT: as a pointer
  explicit StoredRecord(Pointer record) : record_(std::move(record)) {}
  StoredRecord(const SurveySummary& summary, Read read) : summary_(summary), read_(std::move(read)) {}

  bool operator==(std::nullptr_t) const { return record_ == nullptr && !summary_; }

  // Preconditions of all below: not null.
  const SurveySummary& operator*() const { return record_ != nullptr ? *record_ : *summary_; }
  const SurveySummary* operator->() const { return &**this; }
  // All but the band, which may be there.
  Pointer Outline() const { return record_ != nullptr ? record_ : read_(false); }
  Pointer WithBand() const { return record_ != nullptr ? record_ : read_(true); }

 private:
  Pointer record_;
  std::optional<SurveySummary> summary_;
  Read read_;
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_RECORDS_STORED_RECORD_H_
