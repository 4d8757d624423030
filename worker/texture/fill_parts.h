// The filled faces of a tile in parts that are seen from above, each in a raster of its own, and steep faces.
#ifndef TILEMEND_WORKER_TEXTURE_FILL_PARTS_H_
#define TILEMEND_WORKER_TEXTURE_FILL_PARTS_H_

#include <Eigen/Geometry>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "common/mesh/tri_mesh.h"
#include "common/util/colour.h"
#include "worker/texture/atlas.h"
#include "worker/texture/ortho_raster.h"
#include "worker/texture/synthesize.h"

namespace tilemend {

struct FilledFaces {
  std::vector<Point3> points;
  std::vector<Triangle> triangles;
  std::vector<uint8_t> is_water;  // of each triangle
  std::vector<Rgb> flat;          // of each triangle: its colour where nothing else tells it
};

struct FillParts {
  std::vector<RasterFrame> frames;
  std::vector<int32_t> of_triangles;            // into `frames`; -1: steeper than 45 degrees, or too small to be seen
  std::vector<std::vector<int32_t>> triangles;  // of each part
  RasterFrame site;                             // squares of the site
  std::vector<int32_t> of_squares;              // the part of each; -1: none

  // The part at a place seen from above; -1: none.
  int32_t At(const Point3& place) const;
};

// Whether a face is steeper than 45 degrees, or looks down: it is not seen from above.
bool IsSteepFace(const SpaceTriangle& corners);

// A raster for the shapes of all surface that PlanParts looks at. It is `box` in squares of 0.5 m, or larger ones if it
// has more than kMostRasterPixels.
OrthoRaster SiteRaster(const Eigen::AlignedBox2d& box);

// The texel of a raster by the place of what it is made for, metres.
using TexelOfPlace = std::function<double(const Eigen::AlignedBox2d&)>;

// Parts are the connected regions of the fill and of squares without surface in `cells`, as far as they hold faces of
// the fill. So two cells that share a hole give it the same part, if both see all of it. Regions of ground of at most
// 8 m are one part if their middles lie in the same square of 32 m. Many small holes would else draw the same ground
// many times. A frame reaches 6 to 20 m beyond its part, by the size of its largest region, and ends at multiples of 4
// m. Its texel is that of the region or of the square of 32 m, or coarser by a power of two so that it has at most
// kMostRasterPixels. Cost: linear in the site's squares and the faces.
FillParts PlanParts(const FilledFaces& faces, const OrthoRaster& site, std::span<const Eigen::AlignedBox2d> cells,
                    const TexelOfPlace& texel);

// What the pixels of a part's raster are, with the original surface drawn into it.
FillMap FillMapOf(const FilledFaces& faces, const FillParts& parts, int32_t part, const OrthoRaster& raster);

// The level of a part's water, and the flat colours of its faces.
FillLook LookOf(const FilledFaces& faces, const FillParts& parts, int32_t part);

// The points of steep faces.
std::vector<int32_t> SteepPoints(const FilledFaces& faces, const FillParts& parts);

// Colours of the corners of steep faces: of the surface that they hang from. At a point of that surface `rim` has its
// colour. It is handed on along steep faces, ring by ring. A steep face that reaches no such point gets the colours of
// the rasters at its points, or its flat one. Linear.
std::vector<Rgb> SteepColours(const FilledFaces& faces, const FillParts& parts, std::span<const std::optional<Rgb>> rim,
                              std::span<const MadeRaster> rasters);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_TEXTURE_FILL_PARTS_H_
