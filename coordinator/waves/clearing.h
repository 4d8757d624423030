// What surface is taken out of the tiles of a scene, because areas of the user ask for it.
#ifndef TILEMEND_COORDINATOR_WAVES_CLEARING_H_
#define TILEMEND_COORDINATOR_WAVES_CLEARING_H_

#include <Eigen/Geometry>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "common/grid/scene.h"
#include "common/grid/water_areas.h"
#include "common/mesh/clear_area.h"
#include "common/mesh/height_tally.h"
#include "common/mesh/polygon_tree.h"

namespace tilemend {

// What one area took out.
struct ClearedArea {
  std::string label;          // of the area
  bool water = true;          // as the area says
  std::optional<double> top;  // nothing above this height was taken out; none: no limit, or no surface
  std::map<CellId, int64_t> triangles_of = {};  // taken out of each tile, where any were
};

// First the tiles in reach of areas of water without a level are measured (Polygons, TakeTallies). Then Settle gives
// each such area one level, the same for all tiles: the half-sample mode of the heights in it. An area that is mostly
// open in the cells of the scene gets none; what is taken out there is up to its clear_height above the mode of the
// lower half. From then on Areas says what is taken out of a tile. Pure. Not thread-safe. Cost of a tile: O(log areas),
// the areas in its reach, and the tallies until Settle.
class Clearing {
 public:
  // Without areas nothing is taken out.
  Clearing() = default;
  // `areas` without `clear` are skipped. `cells` are all of the scene, each once: what lies beyond them tells nothing.
  // A scene without a grid has one tile, which all areas reach. `bounds`: the area of the scene, if it has one; what
  // lies across its outline is not taken out.
  Clearing(const std::vector<WaterArea>& areas, const Grid& grid, std::span<const CellId> cells,
           const PlanePolygon& bounds = {});

  // What is to be measured of the tile of a cell; empty: nothing.
  std::vector<PlanePolygon> Polygons(CellId cell) const;
  bool IsMeasured(CellId cell) const { return !Measured(cell).empty(); }
  // The heights in these polygons, in their order. kInvalidArgument for another number of them.
  absl::Status TakeTallies(CellId cell, std::span<const HeightTally> tallies);
  // Sets the level, and its sigma, of each of the areas that was measured and has surface inside. `areas` are those of
  // the constructor.
  void Settle(std::vector<WaterArea>& areas);

  // What is taken out of the tile of a cell. After its TakeCounts: empty if that was nothing.
  std::vector<ClearArea> Areas(CellId cell) const;
  // How many triangles each of these took out, in their order. kInvalidArgument for another number of counts, or a
  // negative one.
  absl::Status TakeCounts(CellId cell, std::span<const int64_t> counts);

  // Sets the cells that each of the areas took triangles out of. Call it after all TakeCounts.
  void TellCells(std::vector<WaterArea>& areas) const;

  // One for each area that asks for it, in the order of the areas.
  std::vector<ClearedArea> Cleared() const;

 private:
  struct Asked {
    size_t area = 0;  // its number among all areas
    std::string label;
    bool water = true;
    bool measured = false;  // else its level is given, or it needs none
    double clear_height = 0;
    PlanePolygon polygon;
    double area_in_scene = 0;  // m2 of the polygon, if it is measured
    HeightTally heights;
    std::optional<double> top;  // infinite where everything goes
    std::map<CellId, int64_t> triangles_of;
  };

  // Numbers in asked_, rising: of those whose bounds reach the tile of a cell, and of those among them that are
  // measured there, or cut.
  std::vector<size_t> InReach(CellId cell) const;
  std::vector<size_t> Measured(CellId cell) const;
  std::vector<size_t> Cutting(CellId cell) const;

  // All that a tile may reach. Precondition: the scene has a grid.
  Eigen::AlignedBox2d TileBox(CellId cell) const;
  // The parts of the outline near the tile of a cell.
  std::vector<PlaneSegment> OutlineNear(CellId cell) const;

  Grid grid_;
  std::vector<PlaneSegment> outline_;  // of the bounds
  std::vector<Asked> asked_;
  PolygonTree where_;               // they are
  std::map<CellId, bool> counted_;  // whether anything was taken out
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_WAVES_CLEARING_H_
