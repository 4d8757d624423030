// Sizes and times that both ends of the protocol agree on.
#ifndef TILEMEND_COMMON_RPC_LIMITS_H_
#define TILEMEND_COMMON_RPC_LIMITS_H_

#include <cstddef>
#include <cstdint>

#include "absl/time/time.h"

namespace tilemend {

// Grows with every change that makes a coordinator and a worker of before and after it not understand each other, or
// give other bytes. One output is the work of one release.
inline constexpr int32_t kProtocolVersion = 8;

// Bytes of a blob in one message of a stream.
inline constexpr size_t kMaxChunkBytes = size_t{1} << 20;

// A blob up to this size travels inside Sync and needs no stream of its own: the survey of a cell of a million
// triangles has some 400 KB.
inline constexpr size_t kInlineBlobBytes = size_t{512} << 10;

// No message is larger: inlined blobs, and lists of tasks beside them.
inline constexpr int kMaxMessageBytes = 4 << 20;

// Inlined bytes in one Sync request or response; blobs beyond that are streamed.
inline constexpr size_t kMaxInlineBytesPerSync = size_t{1} << 20;

// One blob, and all that an attempt sends. Larger than any band or patch of a cell by far.
inline constexpr int64_t kMaxBlobBytes = int64_t{1} << 30;

// A call waits no longer in the coordinator when there is nothing to tell.
inline constexpr absl::Duration kMaxPoll = absl::Seconds(1);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_RPC_LIMITS_H_
