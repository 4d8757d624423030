// Content-addressed blobs in a folder: border profiles, bands, samples and patches between the stages.
//
// A blob's name is the SHA-256 of its bytes, so a blob never changes. Putting the same bytes twice is the same as once,
// and a retry cannot overwrite another attempt's result. Blob abcdef... lies in <folder>/ab/cdef....
//
//   TILEMEND_ASSIGN_OR_RETURN(BlobStore store, BlobStore::Open(folder));
//   TILEMEND_ASSIGN_OR_RETURN(const std::string digest, store.Put(bytes));
//   TILEMEND_ASSIGN_OR_RETURN(const std::string same, store.Get(digest));
//
// Thread-safe, also between processes on one folder: a blob appears whole or not at all. Blobs are not synced to the
// disk. One that a power cut tore is found by its digest (kDataLoss), and the stage that put it makes it again.
#ifndef TILEMEND_COMMON_STORE_BLOB_STORE_H_
#define TILEMEND_COMMON_STORE_BLOB_STORE_H_

#include <string>
#include <string_view>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"

namespace tilemend {

class BlobStore {
 public:
  // Uses `folder`, which is created if it does not exist. kInvalidArgument if it is no folder, kPermissionDenied.
  static absl::StatusOr<BlobStore> Open(const std::string& folder);

  // Stores `bytes` and returns their digest. kResourceExhausted (disk full), kPermissionDenied, kInternal.
  absl::StatusOr<std::string> Put(std::string_view bytes) const;

  // The bytes of the blob. Errors: kNotFound, kDataLoss if the bytes on the disk are not those that were put,
  // kInvalidArgument if `digest` is no digest (here and below).
  absl::StatusOr<std::string> Get(const std::string& digest) const;

  absl::StatusOr<bool> Contains(const std::string& digest) const;

  // Removes the blob; OK if there is none.
  absl::Status Remove(const std::string& digest) const;

  const std::string& folder() const { return folder_; }

 private:
  explicit BlobStore(std::string folder) : folder_(std::move(folder)) {}

  // Where the blob lies. A digest comes from the network: it must not become another path.
  absl::StatusOr<std::string> PathOf(const std::string& digest) const;

  std::string folder_;
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_STORE_BLOB_STORE_H_
