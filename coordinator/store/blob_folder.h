// The blobs of one job, named by the SHA-256 of their bytes. They are files in a folder; those that are needed for a
// while are in memory.
#ifndef TILEMEND_COORDINATOR_STORE_BLOB_FOLDER_H_
#define TILEMEND_COORDINATOR_STORE_BLOB_FOLDER_H_

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/store/digest.h"
#include "common/util/files.h"

namespace tilemend {

inline constexpr size_t kMostHeldBytes = size_t{8} << 20;

// Thread-safe. A blob appears at once or not at all. One that is written with Sync::kYes is on the disk with its name
// when the write returns. The others are made again after a crash, so they need not be.
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
    Writer(BlobFolder& folder, Sync sync, std::string path, int fd)
        : folder_(folder), sync_(sync), path_(std::move(path)), fd_(fd) {}
    absl::Status Write(std::string_view bytes);
    absl::Status MoveTo(const std::string& digest);
    BlobFolder& folder_;
    const Sync sync_;
    std::string path_;
    int fd_;
    int64_t size_ = 0;
    Sha256 sha_;
  };

  // Makes the folder, or goes on with it.
  static absl::StatusOr<std::shared_ptr<BlobFolder>> Create(const std::string& path);
  explicit BlobFolder(std::string path) : path_(std::move(path)) {}
  ~BlobFolder() { LetGoOfAll(); }
  BlobFolder(const BlobFolder&) = delete;
  BlobFolder& operator=(const BlobFolder&) = delete;

  // The digest of `bytes`, which are stored unless they are there already. With Sync::kYes they are stored in any case:
  // what is there may not be on the disk. `known`: their digest, where it is known.
  absl::StatusOr<std::string> Put(std::string_view bytes, Sync sync = Sync::kNo, std::string known = "");
  // As Put, but only until LetGo was called as often; `read` gives the bytes that have the digest, and is called only
  // if they are not there. The bytes are in memory, unless all folders of the process would then hold more than
  // kMostHeldBytes there. The first call decides where, until the last has let go.
  absl::Status Hold(const std::string& digest, const std::function<absl::StatusOr<std::string>()>& read);
  void LetGo(const std::string& digest);
  absl::StatusOr<std::unique_ptr<Writer>> NewWriter(Sync sync = Sync::kNo);

  // kNotFound (BLOB_NOT_FOUND), kInvalidArgument for a malformed digest, here and below.
  absl::StatusOr<int64_t> Size(const std::string& digest) const;
  // kUnavailable (BLOB_DAMAGED) if the bytes are not those of the digest.
  absl::StatusOr<std::string> Read(const std::string& digest) const;
  // Gives the blob's bytes to `take` in order, at most kMaxChunkBytes at a time, until it returns false.
  absl::Status ReadChunks(const std::string& digest, const std::function<bool(std::string_view)>& take) const;

  // Removes all but these, and what was being written when an earlier process ended. They go to a folder beside this
  // one, of the same name with an ending, since to delete them takes long on some disks. Before anything else is
  // called. Without hard links they are deleted at once.
  absl::Status KeepOnly(const std::set<std::string>& digests);

  // Refuses every later write and removes the folder, which on some disks takes seconds for each thousand blobs. Before
  // each blob it asks `stop` whether to leave the rest there.
  void Remove(const std::function<bool()>& stop = [] { return false; });

 private:
  struct HeldBlob {
    size_t MemoryBytes() const { return bytes == nullptr ? 0 : bytes->size(); }
    std::shared_ptr<const std::string> bytes;  // null: in a file
    int times = 0;
  };

  // Null if it is not in memory.
  std::shared_ptr<const std::string> HeldBytes(const std::string& digest) const;
  void LetGoOfAll();
  absl::Status MoveIntoPlace(const std::string& temporary, const std::string& digest, Sync sync);

  std::string path_;
  std::atomic<bool> removed_{false};
  std::atomic<uint32_t> synced_parents_{0};  // a bit for each digit whose folder is durable in path_
  mutable std::mutex mutex_;
  std::map<std::string, HeldBlob> held_;  // with the lock
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_STORE_BLOB_FOLDER_H_
