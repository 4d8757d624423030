// Local copies of objects, as files without a name.
#ifndef TILEMEND_COMMON_S3_LOCAL_COPIES_H_
#define TILEMEND_COMMON_S3_LOCAL_COPIES_H_

#include <cstdint>
#include <list>
#include <mutex>
#include <string>

#include "absl/status/statusor.h"

namespace tilemend {

// Keeps up to `most` bytes, and drops those first that were not used for the longest time. The files have no names:
// they are gone when the process is, however it ends. Thread-safe.
class LocalCopies {
 public:
  // `folder` is where the files lie; "" for that of temporary files.
  LocalCopies(std::string folder, int64_t most) : folder_(std::move(folder)), most_(most) {}
  ~LocalCopies();
  LocalCopies(const LocalCopies&) = delete;
  LocalCopies& operator=(const LocalCopies&) = delete;

  // A new empty file. kResourceExhausted, kPermissionDenied, ...
  absl::StatusOr<int> NewFile() const;
  // A descriptor of the copy that is kept under this name; -1 if there is none.
  int Find(const std::string& name);
  // Keeps a copy of `bytes` bytes. The descriptor stays the caller's.
  void Keep(const std::string& name, int file, int64_t bytes);

 private:
  struct Copy {
    std::string name;
    int file = -1;
    int64_t bytes = 0;
  };
  void DropLast();

  const std::string folder_;
  const int64_t most_;
  std::mutex mutex_;
  std::list<Copy> copies_;  // the one that was used last comes first
  int64_t bytes_ = 0;
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_S3_LOCAL_COPIES_H_
