// What a tile of OSGB files looks like.
#ifndef TILEMEND_WORKER_MATERIALS_OSGB_LOOK_H_
#define TILEMEND_WORKER_MATERIALS_OSGB_LOOK_H_

#include <string>
#include <string_view>

#include "absl/status/statusor.h"
#include "common/codec/osgb/osgb_tile.h"
#include "worker/materials/rim_colours.h"
#include "worker/materials/tile_look.h"
#include "worker/survey/rim_spots.h"

namespace tilemend {

// The files of the tile `path` beside its own, as images that it names: the output has them, too.
TileLook ReadOsgbLook(const std::string& path, const OsgbTile& tile);

// The texels at the spots of the finest level of `tile`. Decodes only the images at a spot, one at a time. An image
// that cannot be read gives a warning, as one that lies in another file.
RimColours SampleOsgbRim(const OsgbTile& tile, const OsgbLevel& finest, const std::vector<RimSpot>& spots,
                         size_t vertices, const std::string& name);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_MATERIALS_OSGB_LOOK_H_
