// The frame around encoded meshes, and the check of a Draco stream before Draco sees it.
//
// Draco trusts its input: 61 bytes can make its decoder allocate 20 GB (google/draco#1169). Two guards stand before it.
// The frame carries a length and a CRC-32C, so that damaged bytes never reach Draco. A malicious peer can compute
// those, so CheckDracoStream reads the stream's headers itself. It holds every count in them against the limits and the
// bytes that are there.
#ifndef TILEMEND_COMMON_CODEC_DRACO_FRAME_H_
#define TILEMEND_COMMON_CODEC_DRACO_FRAME_H_

#include <cstdint>
#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/codec/draco_mesh.h"

namespace tilemend {

enum class FrameContent : uint8_t {
  kPlain = 1,  // two counts and the numbers themselves: for what Draco cannot encode (no points, very wide ranges)
  kDraco = 2,  // a least corner, then the mesh relative to it as a Draco stream
};

struct Frame {
  FrameContent content = FrameContent::kPlain;
  std::string_view payload;  // of the bytes that were given
};

// Magic, content, length, CRC-32C, payload.
std::string WrapFrame(FrameContent content, std::string_view payload);
absl::StatusOr<Frame> UnwrapFrame(std::string_view bytes);

struct DracoCounts {
  uint32_t points = 0;
  uint32_t triangles = 0;
};

// Accepts exactly what EncodeDraco makes Draco write: version 2.2, a sequentially encoded mesh without metadata, with
// plain indices. It has one int32 attribute of three components, in integer coding with difference prediction or none.
// Symbol tables are no larger than their bit length allows. Returns the counts.
absl::StatusOr<DracoCounts> CheckDracoStream(std::string_view stream, const DracoLimits& limits);

// kResourceExhausted if the counts are beyond the limits.
absl::Status CheckCounts(uint64_t points, uint64_t triangles, const DracoLimits& limits);

// Little-endian numbers.
uint32_t LoadUint32(const char* p);
void AppendUint32(uint32_t value, std::string& out);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_CODEC_DRACO_FRAME_H_
