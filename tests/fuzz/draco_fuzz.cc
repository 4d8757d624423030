// Two ways in: the bytes as they are, which a checksum guards, and the same bytes as the payload of a frame with a
// correct checksum, as a malicious peer would send it.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "common/codec/draco_frame.h"
#include "common/codec/draco_mesh.h"
#include "tests/fuzz/fuzz_target.h"

namespace tilemend {
namespace {

// Small, so that a decoder that ignores them shows in the address space that the driver allows.
constexpr DracoLimits kLimits = {.max_points = 100000, .max_triangles = 100000};

void CheckDecoding(std::string_view bytes) {
  const absl::StatusOr<LatticeMesh> mesh = DecodeDraco(bytes, kLimits);
  if (!mesh.ok()) {
    if (mesh.status().message().find("not enough memory") == absl::string_view::npos) return;
    std::fprintf(stderr, "%s\n", mesh.status().ToString().c_str());
    std::abort();
  }
  const absl::StatusOr<LatticeMesh> again = DecodeDraco(EncodeDraco(*mesh), kLimits);
  if (!again.ok() || again->points != mesh->points || again->triangles != mesh->triangles) std::abort();
}

std::string Payload(const LatticeMesh& mesh) {
  const std::string bytes = EncodeDraco(mesh);
  return std::string(UnwrapFrame(bytes)->payload);
}

LatticeMesh Grid(int32_t side, int32_t step) {
  LatticeMesh mesh;
  for (int32_t i = 0; i < side * side; ++i)
    mesh.points.push_back({i % side * step, i / side * step, i % 100 * i % 977});
  for (int32_t i = 0; i + side + 1 < side * side; ++i) {
    if (i % side != side - 1) mesh.triangles.push_back({i, i + 1, i + side});
  }
  return mesh;
}

}  // namespace

std::vector<std::string> FuzzSeeds() {
  LatticeMesh points_only = Grid(3, 7);
  points_only.triangles.clear();
  LatticeMesh flat = Grid(30, 0);
  for (auto& point : flat.points) point = {5, 5, 5};
  return {Payload(flat),
          Payload(Grid(300, 9)),
          Payload(Grid(3, 1000)),
          Payload(Grid(20, 1 << 20)),
          Payload(Grid(2, 1)),
          Payload(points_only),
          EncodeDraco(Grid(4, 50)),
          EncodeDraco({}),
          EncodeDraco({.points = {{1, 2, 3}}, .triangles = {}})};
}

}  // namespace tilemend

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  tilemend::CheckDecoding(bytes);
  tilemend::CheckDecoding(tilemend::WrapFrame(tilemend::FrameContent::kDraco, bytes));
  tilemend::CheckDecoding(tilemend::WrapFrame(tilemend::FrameContent::kPlain, bytes));
  return 0;
}
