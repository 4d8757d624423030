// What a tile that is a tree of files looks like.
#ifndef TILEMEND_WORKER_MATERIALS_TREE_LOOK_H_
#define TILEMEND_WORKER_MATERIALS_TREE_LOOK_H_

#include <string>
#include <string_view>

#include "absl/status/statusor.h"
#include "common/codec/tree/tile_tree.h"
#include "worker/materials/rim_colours.h"
#include "worker/materials/tile_look.h"
#include "worker/survey/rim_spots.h"

namespace tilemend {

// The files of the tile `path` beside its own, as images that it names: the output has them, too.
TileLook ReadTreeLook(const std::string& path, const TileTree& tile);

// The texels at the spots of the finest level of `tile`, or the colour of a material without an image. Decodes only the
// images at a spot, one at a time. An image that cannot be read gives a warning, as one that lies in another file.
RimColours SampleTreeRim(const TileTree& tile, const TreeLevel& finest, const std::vector<RimSpot>& spots,
                         size_t vertices, const std::string& name);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_MATERIALS_TREE_LOOK_H_
