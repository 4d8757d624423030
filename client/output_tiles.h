// Which tiles an output lacks, and which meshes lie among its tiles that are none of them.
#ifndef TILEMEND_CLIENT_OUTPUT_TILES_H_
#define TILEMEND_CLIENT_OUTPUT_TILES_H_

#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "common/grid/scene.h"

namespace tilemend {

// Paths relative to the output's folder, sorted.
struct OutputTiles {
  std::vector<std::string> missing;  // tiles of cells that had a surface, or where holes were filled
  std::vector<std::string> others;   // .ply and .obj files among the tiles that are of no cell of the scene
};

// Looks at the output `folder` with this `report`, of `scene` as it was before. `chosen`: the cells that were to be
// written; empty: all. Links are not followed. Cost: lists the folders of the tiles.
OutputTiles LookForTiles(const std::string& folder, const nlohmann::ordered_json& report, const Scene& scene,
                         const std::set<CellId>& chosen);

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_OUTPUT_TILES_H_
