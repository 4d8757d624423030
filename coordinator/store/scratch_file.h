// What a job puts aside while it runs: survey records and patches, in a file without a name.
#ifndef TILEMEND_COORDINATOR_STORE_SCRATCH_FILE_H_
#define TILEMEND_COORDINATOR_STORE_SCRATCH_FILE_H_

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/records/stored_record.h"
#include "common/util/recently_used.h"

namespace tilemend {

// The file ends with its last owner, however that ends. Thread-safe.
class ScratchFile : public std::enable_shared_from_this<ScratchFile> {
 public:
  struct Place {
    int64_t at = 0;
    int64_t size = 0;  // bytes
  };

  // In a folder that is there; empty: that of the system for such files. kPermissionDenied, kNotFound,
  // kResourceExhausted.
  static absl::StatusOr<std::shared_ptr<ScratchFile>> Create(const std::string& folder);
  ~ScratchFile();
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;

  // kResourceExhausted (disk full).
  absl::StatusOr<Place> Put(std::string_view bytes);
  absl::StatusOr<std::string> Get(const Place& place) const;

  // A handle that keeps the file, and the record's summary in memory. It reads in time linear in what is asked for, and
  // throws std::runtime_error where the disk fails.
  absl::StatusOr<StoredRecord> Keep(const SurveyRecord& record);

 private:
  class StoredColumns;
  // Bytes. A plan asks for each record about ten times, mostly for those of neighbours one after the other.
  static constexpr size_t kRecent = size_t{12} << 20;

  using Records = RecentlyUsed<int64_t, SurveyRecord>;  // by their place in the file

  ScratchFile(int fd, std::string folder) : fd_(fd), folder_(std::move(folder)), outlines_(kRecent), whole_(kRecent) {}
  absl::Status WriteAt(int64_t at, std::string_view bytes) const;
  absl::Status ReadInto(int64_t at, void* data, size_t size) const;

  const int fd_;
  const std::string folder_;
  std::atomic<int64_t> end_{0};
  Records outlines_, whole_;  // that were read last
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_STORE_SCRATCH_FILE_H_
