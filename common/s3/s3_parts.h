// Objects that are sent or copied in parts, because one request takes too long or takes no more.
//
// Source: Amazon S3 user guide, "Uploading and copying objects using multipart upload". The ETag of such an object is
// the MD5 of the MD5s of its parts: a copy in parts of the same size has the same one.
#ifndef TILEMEND_COMMON_S3_S3_PARTS_H_
#define TILEMEND_COMMON_S3_S3_PARTS_H_

#include <cstdint>
#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "common/s3/s3_address.h"
#include "common/s3/s3_requests.h"
#include "common/util/object_store.h"

namespace tilemend {

// The bytes of each part but the last one: `wanted`, or more where there would be over 10,000 parts, the most that a
// store takes.
int64_t PartBytes(int64_t object_bytes, int64_t wanted);

// At once or not at all, as one PUT: what came so far is taken back after an error. `name` stands in errors, which are
// those of S3Requests. A process that is killed leaves its parts in the store, where nobody sees them.
absl::Status PutInParts(S3Requests& requests, const S3Path& object, const std::string& name, std::string_view bytes,
                        int64_t part_bytes);

// The same with the content of the object at `from`, which `look` is of, within the store.
absl::Status CopyInParts(S3Requests& requests, const S3Path& from, const ObjectLook& look, const S3Path& to,
                         const std::string& name, int64_t part_bytes);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_S3_S3_PARTS_H_
