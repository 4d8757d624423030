// A survey record that may lie elsewhere than in memory.
#ifndef TILEMEND_COMMON_RECORDS_STORED_RECORD_H_
#define TILEMEND_COMMON_RECORDS_STORED_RECORD_H_

#include <cstddef>
#include <memory>
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

  // Where a record lies.
  class Source {
   public:
    virtual ~Source() = default;
    virtual const SurveySummary& summary() const = 0;
    // Never null. The band may be missing unless it is asked for. What fails to read throws.
    virtual Pointer Read(bool with_band) const = 0;
  };

  StoredRecord(std::nullptr_t = nullptr) {}  // NOLINT: as a pointer
  // In memory, where the record must outlive the handle.
  StoredRecord(const SurveyRecord* record) : StoredRecord(Pointer(Pointer(), record)) {}  // NOLINT: as a pointer
  explicit StoredRecord(Pointer record) {
    if (record != nullptr) source_ = std::make_shared<InMemory>(std::move(record));
  }
  explicit StoredRecord(std::shared_ptr<const Source> source) : source_(std::move(source)) {}

  bool operator==(std::nullptr_t) const { return source_ == nullptr; }

  // Preconditions of all below: not null.
  const SurveySummary& operator*() const { return source_->summary(); }
  const SurveySummary* operator->() const { return &**this; }
  // All but the band, which may be there.
  Pointer Outline() const { return source_->Read(false); }
  Pointer WithBand() const { return source_->Read(true); }

 private:
  class InMemory : public Source {
   public:
    explicit InMemory(Pointer record) : record_(std::move(record)) {}
    const SurveySummary& summary() const override { return *record_; }
    Pointer Read(bool) const override { return record_; }

   private:
    const Pointer record_;
  };

  std::shared_ptr<const Source> source_;
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_RECORDS_STORED_RECORD_H_
