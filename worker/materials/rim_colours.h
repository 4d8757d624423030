// The colours that a surface has beside its boundary.
#ifndef TILEMEND_WORKER_MATERIALS_RIM_COLOURS_H_
#define TILEMEND_WORKER_MATERIALS_RIM_COLOURS_H_

#include <optional>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/codec/obj.h"
#include "common/records/survey_record.h"
#include "common/util/colour.h"
#include "worker/materials/tile_look.h"
#include "worker/survey/rim_spots.h"

namespace tilemend {

struct RimColours {
  std::vector<std::optional<Rgb>> colours;  // of the boundary vertices; empty: the tile has none at all
  std::vector<std::string> warnings;        // images that cannot be read
  std::vector<FileWitness::Read> reads;     // the images
};

// The texels at the spots, or the diffuse colour of a material without an image. Where no material is in force, the
// colours of the boundary vertices `vertices` themselves, if the file has any. Reads only the images that lie at a
// spot, and holds one at a time. Errors of an object store (IsStoreError).
absl::StatusOr<RimColours> SampleRim(const std::string& root, const TileLook& look, const ObjTextures& textures,
                                     const std::vector<RimSpot>& spots, const std::vector<BoundaryVertex>& vertices);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_MATERIALS_RIM_COLOURS_H_
