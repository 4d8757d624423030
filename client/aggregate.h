// The way of Han 2019, as Wang 2021, 2.1 tells it: all cells joined to one mesh, and the holes of that filled.
#ifndef TILEMEND_CLIENT_AGGREGATE_H_
#define TILEMEND_CLIENT_AGGREGATE_H_

#include <cstdint>
#include <string>
#include <string_view>

#include "absl/status/statusor.h"
#include "client/mesh/mesh_filler.h"
#include "client/step_watcher.h"
#include "common/grid/scene.h"

namespace tilemend {

struct AggregateOptions {
  std::string joined;        // where the joined mesh is written before it is filled
  int64_t memory_bytes = 0;  // of address space that the process may take; 0: any
  int32_t longest_loop = 2000;
  StepWatcher watcher = [](std::string_view, size_t, size_t, std::string_view) {};
};

// Reads all tiles of the scene, welds equal positions and writes the mesh as a binary PLY of 64-bit numbers. Then it
// fills the closed loops of that mesh with the filler minimum-area. The outline of the joined surface is no hole: holes
// that reach it stay open, as in the paper. Materials, textures and colours of the tiles are lost.
//
// Memory grows with the scene. Where it is more than allowed the error is kResourceExhausted and says how far it came;
// the process keeps the limit. Errors of ReadMeshFile and FillMesh.
absl::StatusOr<FilledMesh> AggregateAndFill(const Scene& scene, const AggregateOptions& options);

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_AGGREGATE_H_
