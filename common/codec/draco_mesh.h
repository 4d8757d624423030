// Triangle meshes on an integer lattice as compact bytes: what coordinator and workers send each other.
//
// Coordinates are quantized before they come here, to a power-of-two lattice with a shared origin, so that equal border
// vertices stay equal. Draco codes the integers without loss and in their order (sequential encoding, no quantization
// of its own).
#ifndef TILEMEND_COMMON_CODEC_DRACO_MESH_H_
#define TILEMEND_COMMON_CODEC_DRACO_MESH_H_

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/mesh/mesh_limits.h"
#include "common/mesh/tri_mesh.h"

namespace tilemend {

struct LatticeMesh {
  std::vector<std::array<int32_t, 3>> points;  // in steps of the lattice, which the message around this names
  std::vector<Triangle> triangles;             // indices into `points`
};

// What a decoder accepts. Memory stays below about 60 bytes a point and 30 a triangle, plus 20 MB.
struct DracoLimits {
  int64_t max_points = kMaxResultPoints;
  int64_t max_triangles = kMaxResultTriangles;
};

// Always succeeds, for any topology: no points, no triangles, degenerate or doubled triangles. The same mesh gives the
// same bytes. Precondition: indices are in range, fewer than 2^31 points.
std::string EncodeDraco(const LatticeMesh& mesh);

// The mesh that was encoded: same points, same triangles, same order. Returns kInvalidArgument for bytes that
// EncodeDraco did not write. Returns kResourceExhausted for a mesh beyond `limits` or beyond the memory. Does not
// throw.
absl::StatusOr<LatticeMesh> DecodeDraco(std::string_view bytes, const DracoLimits& limits);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_CODEC_DRACO_MESH_H_
