// Objects of Amazon S3 and of stores that speak its protocol.
#ifndef TILEMEND_COMMON_S3_S3_STORE_H_
#define TILEMEND_COMMON_S3_S3_STORE_H_

#include <cstdint>
#include <memory>

#include "common/s3/s3_requests.h"
#include "common/util/object_store.h"

namespace tilemend {

// `most_copied` bounds the bytes of local copies that are kept (TMPDIR).
std::unique_ptr<ObjectStore> NewS3Store(const Environment& environment, int64_t most_copied, S3Patience patience = {});

// For the start of main: UseObjects with the store of the process's environment. TILEMEND_S3_CACHE_MB bounds the local
// copies, 2048 if it is not set. kInvalidArgument for anything but a number there.
absl::Status UseS3();

}  // namespace tilemend

#endif  // TILEMEND_COMMON_S3_S3_STORE_H_
