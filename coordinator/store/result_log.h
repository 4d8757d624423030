// Results of tasks by the content of what they were made from, kept with an output for the jobs that come after.
#ifndef TILEMEND_COORDINATOR_STORE_RESULT_LOG_H_
#define TILEMEND_COORDINATOR_STORE_RESULT_LOG_H_

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"

namespace tilemend {

// One file to which records are appended, each with a sum over all of it. It is not synced: a record that is torn, or
// changed since, is as good as none. A process that is killed loses nothing of it.
//
// A job sees what was there when it began, and nothing of its own: so one that goes on after a restart of its
// coordinator sees the same as before, and asks the same of its workers. Memory: 8 bytes for each result that is put,
// 80 for each that was there before.
//
//   TILEMEND_ASSIGN_OR_RETURN(ResultLog log, ResultLog::Open(path, ResultLog::Opening::kNewJob));
//   if (const auto result = log.Find(key)) ...;
//   TILEMEND_RETURN_IF_ERROR(log.Put(key, bytes));
//   TILEMEND_RETURN_IF_ERROR(log.KeepUsed());
class ResultLog {
 public:
  enum class Opening {
    kNewJob,
    kSameJob,      // the last job there is this one
    kSameJobAnew,  // likewise; what it has put is forgotten
  };
  // Goes on with the file `path`, which appears with the first result. A file that is no log of this release is
  // replaced then. One process at a time. kPermissionDenied, kUnavailable.
  static absl::StatusOr<ResultLog> Open(const std::string& path, Opening how);
  ResultLog(ResultLog&& other) noexcept;
  ResultLog& operator=(ResultLog&&) = delete;
  ~ResultLog();

  // The newest result that an earlier job put under this SHA-256 (64 hexadecimal digits).
  std::optional<std::string> Find(const std::string& key);
  // `digest`: Sha256Hex of the result, where it is known. kResourceExhausted (disk full), kUnavailable.
  absl::Status Put(const std::string& key, std::string_view result, const std::string& digest = "");
  // Takes the file away again, if this process made it.
  void Discard();
  // Forgets what this job has neither found nor put. The old file or the new one is there at any time.
  absl::Status KeepUsed();

 private:
  using Name = std::array<char, 16>;  // of a key
  struct Place {
    int64_t offset = 0;  // of the record
    bool used = false;
  };
  struct Record;

  ResultLog(std::string path, int fd) : path_(std::move(path)), fd_(fd) {}
  absl::Status Scan(Opening how);
  // Of the file as it is: none if it is not whole.
  std::optional<Record> ReadHead(int64_t offset) const;
  std::optional<std::string> ReadResult(int64_t offset) const;
  absl::Status Append(const Name& name, std::string_view result, const std::string& digest, bool begins);

  std::string path_;
  int fd_ = -1;
  bool made_ = false;              // by this process
  int64_t end_ = 0;                // of the last whole record
  bool begun_ = false;             // there is a record that says so
  std::map<Name, Place> earlier_;  // of earlier jobs
  std::map<Name, Place> own_;      // of this job, by an earlier process of it
  std::vector<int64_t> put_;       // offsets of what this process has put
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_STORE_RESULT_LOG_H_
