// Objects of Amazon S3 and of stores that speak its protocol.
#ifndef TILEMEND_COMMON_S3_S3_STORE_H_
#define TILEMEND_COMMON_S3_S3_STORE_H_

#include <cstdint>
#include <memory>

#include "common/s3/s3_requests.h"
#include "common/util/object_store.h"

namespace tilemend {

struct S3Limits {
  int64_t most_copied = int64_t{2048} << 20;  // bytes of local copies that are kept (TMPDIR)
  int64_t part_bytes = int64_t{64} << 20;     // larger objects are sent and copied in parts of this size (s3_parts.h)
};

std::unique_ptr<ObjectStore> NewS3Store(const Environment& environment, S3Limits limits, S3Patience patience = {});

// For the start of main: UseObjects with the store of the process's environment. TILEMEND_S3_CACHE_MB and
// TILEMEND_S3_PART_MB set the limits. kInvalidArgument for what is no number there, or parts of less than 5 MB or more
// than 5120, which stores do not take.
absl::Status UseS3();

}  // namespace tilemend

#endif  // TILEMEND_COMMON_S3_S3_STORE_H_
