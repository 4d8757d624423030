// Images for the fill of all levels of detail of a tile, from what was made for its finest.
#ifndef TILEMEND_WORKER_TEXTURE_LEVEL_PAINT_H_
#define TILEMEND_WORKER_TEXTURE_LEVEL_PAINT_H_

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "common/mesh/tri_mesh.h"
#include "common/util/colour.h"
#include "worker/texture/atlas.h"
#include "worker/texture/fill_parts.h"

namespace tilemend {

class LevelPaint {
 public:
  // `rasters` are those of the parts. `rim` has colours of the finest surface at points that steep faces hang from.
  LevelPaint(FillParts parts, std::vector<MadeRaster> rasters, std::map<std::array<double, 3>, Rgb> rim);

  // The image of some faces of the level that is `above_finest` levels coarser than the finest. Its texel is that of
  // the rasters, doubled for each of these levels, as edges are. The `colours` of each triangle are for steep ones that
  // nothing else tells. Where a coarser face covers several parts it shows the colours of each. Cost: linear in the
  // rasters at the first call for a level, else as PackAtlas. Not safe from several threads.
  Atlas AtlasOf(std::span<const Point3> points, std::span<const Triangle> triangles, std::span<const Rgb> colours,
                int32_t above_finest);

 private:
  const std::vector<MadeRaster>& RastersAt(int32_t above_finest);
  std::vector<MadeRaster> Joined() const;
  int32_t PartOf(const Point3& middle) const;

  FillParts parts_;
  std::map<std::array<double, 3>, Rgb> rim_;
  std::map<int32_t, std::vector<MadeRaster>> rasters_;  // by the levels above the finest
};

}  // namespace tilemend

#endif  // TILEMEND_WORKER_TEXTURE_LEVEL_PAINT_H_
