// One image for all filled faces of a tile.
#ifndef TILEMEND_WORKER_TEXTURE_ATLAS_H_
#define TILEMEND_WORKER_TEXTURE_ATLAS_H_

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/image/image.h"
#include "common/mesh/tri_mesh.h"
#include "common/util/colour.h"
#include "worker/texture/ortho_raster.h"

namespace tilemend {

// Colours from above, of Synthesize.
struct MadeRaster {
  RasterFrame frame;
  std::vector<Rgb> colours;
};

struct AtlasFaces {
  std::span<const Point3> points;
  std::span<const Triangle> triangles;
  std::vector<int32_t> rasters;    // of each triangle: the raster that it is seen in from above; -1: it is steep
  std::vector<Rgb> steep_colours;  // of each corner of each triangle, three a triangle; read for those with -1
};

struct Atlas {
  Image image;                                    // sides are powers of two, 8 to 8192
  std::vector<std::array<float, 2>> coordinates;  // u to the right, v upward
  std::vector<Triangle> corners;                  // of each triangle, into `coordinates`
};

inline constexpr int32_t kAtlasGutter = 4;  // pixels of the raster around each part of the image

// Packs the parts of the rasters that the triangles cover, in the rasters' order. Steep triangles get small squares of
// blended corner colours; those of equal colours share one. If the squares take more than half of 8192 x 8192 pixels,
// colours of steep triangles lose as many of their low bits as it needs. If all of it is larger than 8192 x 8192, parts
// are halved until it fits. Pixels between the parts have the mean colour of all. Coordinates keep half a pixel away
// from the border of their part. A triangle that lies outside its raster gets the nearest pixels of it. Preconditions:
// indices are valid; there is a triangle; at most 10^7 rasters have triangles. Cost: linear in the image, O(n log n) in
// the triangles.
Atlas PackAtlas(const AtlasFaces& faces, std::span<const MadeRaster> rasters);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_TEXTURE_ATLAS_H_
