// How far apart the fills of two tiles are where both lie over one strip of ground.
#ifndef TILEMEND_COORDINATOR_WAVES_FILL_GAPS_H_
#define TILEMEND_COORDINATOR_WAVES_FILL_GAPS_H_

#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "common/mesh/tri_mesh.h"
#include "common/records/cell_holes.h"
#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// Compares fills along three lines in the strip of every border where tiles overlap, at 256 places on each, where both
// lie over one. Triangles with an original vertex do not count: there fills are as far apart as the originals are. Of a
// tile whose fill does so more than once, the lowest counts. The distance is that in space if it is less than a metre,
// since walls that are millimetres apart differ by metres in height. Else it is that in height. Patches may come in any
// order. Of each it keeps the triangles near the strip until the second tile has come. Pure; one thread at a time.
class FillGaps {
 public:
  using Border = std::pair<CellId, CellId>;  // as BorderAudit

  FillGaps() = default;
  FillGaps(const Grid& grid, const std::vector<BorderAudit>& borders);

  // Whether a cell has a border to compare over.
  bool Wants(CellId cell) const { return borders_of_.contains(cell); }

  // The patches of a cell, with the vertices that their corners name; once. Cost linear in the triangles, and in
  // the places under those on the strips.
  void Take(CellId cell, std::span<const RimVertex> vertices, std::span<const HolePatch> patches);

  // What both fills lie over somewhere.
  const std::map<Border, SurfaceGap>& gaps() const { return gaps_; }

 private:
  struct Strip {
    int axis = 0;               // across
    double lo = 0, hi = 0;      // the strip
    double begin = 0, end = 0;  // along
  };

  // What one tile has on a strip.
  struct Part {
    TriMesh mesh;
    std::vector<double> heights;  // at the places, line by line; infinity: none
  };

  static double LineOf(const Strip& strip, size_t line);
  static Part PartOn(const Strip& strip, std::span<const RimVertex> vertices, std::span<const HolePatch> patches);
  static SurfaceGap Compare(const Strip& strip, const Part& a, const Part& b);

  std::map<Border, Strip> strips_;
  std::map<CellId, std::vector<Border>> borders_of_;
  std::map<Border, Part> waiting_;  // of one tile
  std::map<Border, SurfaceGap> gaps_;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_WAVES_FILL_GAPS_H_
