// What a store says of a file, which two programs can compare without reading it.
#ifndef TILEMEND_COMMON_STORE_FILE_RECEIPT_H_
#define TILEMEND_COMMON_STORE_FILE_RECEIPT_H_

#include <cstdint>
#include <string>

#include "absl/status/statusor.h"

namespace tilemend {

// Two equal receipts are of one file that nobody wrote to in between. The times of a file system are coarse: a change
// within one tick of its clock may leave no trace. Renaming the file changes nothing of it.
struct FileReceipt {
  int64_t bytes = 0;
  uint64_t inode = 0;    // of an object, the beginning of a digest of its ETag
  int64_t modified = 0;  // nanoseconds since 1970; 0 of an object
  bool operator==(const FileReceipt&) const = default;
};

// Of a regular file; a link is not followed. kNotFound, kPermissionDenied.
absl::StatusOr<FileReceipt> ReceiptOf(const std::string& path);

// The FileDigest of a regular file that is opened anew, and its receipt.
struct ReadReceipt {
  std::string digest;
  FileReceipt receipt;
};

// Cost: reads the file. Errors of ReadFile; kUnavailable if the file changed while it was read.
absl::StatusOr<ReadReceipt> ReadForReceipt(const std::string& path);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_STORE_FILE_RECEIPT_H_
