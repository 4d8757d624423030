// The blobs of one job: files in a folder, named by the SHA-256 of their bytes.
#ifndef TILEMEND_COORDINATOR_SERVICE_BLOB_FOLDER_H_
#define TILEMEND_COORDINATOR_SERVICE_BLOB_FOLDER_H_

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/store/digest.h"

namespace tilemend {

// Thread-safe. A blob appears at once or not at all. Nothing is synced to disk: blobs are no longer needed after a
// crash, for their job is then gone too.
class BlobFolder {
 public:
  // A blob that comes in pieces. Leaves nothing behind unless Commit succeeds.
  class Writer {
   public:
    ~Writer();
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;
    // kResourceExhausted (BLOB_TOO_LARGE, or the disk is full).
    absl::Status Append(std::string_view bytes);
    // The blob's size. kInvalidArgument (BLOB_CORRUPT) unless the bytes have the digest `expected`.
    absl::StatusOr<int64_t> Commit(const std::string& expected);

   private:
    friend class BlobFolder;
    Writer(BlobFolder& folder, std::string path, int fd) : folder_(folder), path_(std::move(path)), fd_(fd) {}
    BlobFolder& folder_;
    std::string path_;
    int fd_;
    int64_t size_ = 0;
    Sha256 sha_;
  };

  // Makes the folder.
  static absl::StatusOr<std::shared_ptr<BlobFolder>> Create(const std::string& path);
  explicit BlobFolder(std::string path) : path_(std::move(path)) {}

  // The digest of `bytes`, which are stored unless they are there already.
  absl::StatusOr<std::string> Put(std::string_view bytes);
  absl::StatusOr<std::unique_ptr<Writer>> NewWriter();

  // kNotFound (BLOB_NOT_FOUND), kInvalidArgument for a malformed digest, here and below.
  absl::StatusOr<int64_t> Size(const std::string& digest) const;
  absl::StatusOr<std::string> Read(const std::string& digest) const;
  // Gives the blob's bytes to `take` in order, at most kMaxChunkBytes at a time, until it returns false.
  absl::Status ReadChunks(const std::string& digest, const std::function<bool(std::string_view)>& take) const;

  // Removes the folder and refuses every later write.
  void Remove();

 private:
  absl::StatusOr<std::string> PathOf(const std::string& digest) const;
  absl::Status MoveIntoPlace(const std::string& temporary, const std::string& digest);

  std::string path_;
  std::atomic<uint64_t> next_temporary_{0};
  std::atomic<bool> removed_{false};
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_SERVICE_BLOB_FOLDER_H_
