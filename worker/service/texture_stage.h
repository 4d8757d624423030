// The image of the filled faces of a tile, made from the tiles around.
#ifndef TILEMEND_WORKER_SERVICE_TEXTURE_STAGE_H_
#define TILEMEND_WORKER_SERVICE_TEXTURE_STAGE_H_

#include <array>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/mesh/tri_mesh.h"
#include "common/rpc/tile_patch.h"
#include "common/util/cancel_token.h"
#include "tilemend/v1/stages.pb.h"
#include "worker/service/task_memory.h"

namespace tilemend {

struct FillTexture {
  std::string image;                         // a JPEG; empty: faces keep the colours of their holes
  std::vector<std::array<float, 2>> places;  // in the image, u to the right, v upward
  std::vector<Triangle> corners;             // of each triangle of the patch, into `places`
  PaintFaces paint;                          // of a tile that is a tree, in place of the image; empty: as above
  std::vector<std::string> warnings;         // images that could not be read
};

// Reads the tiles of AssembleInput.around and their images, as far as they lie near the patch. No image if none is
// asked for, the patch is empty, or the tile itself has no texture that can be read. Errors of ReadSurveyed and of the
// readers of meshes; kCancelled. Memory: these tiles, and rasters of kMostRasterPixels with one image of
// kFullPixels at most or with what Synthesize needs.
absl::StatusOr<FillTexture> TextureOf(const v1::AssembleInput& input, const TilePatch& added, TaskMemory& memory,
                                      const CancelToken& cancel);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_SERVICE_TEXTURE_STAGE_H_
