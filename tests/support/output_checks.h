// Made scenes on disk, and what must hold of an output: read back from the files alone.
#ifndef TILEMEND_TESTS_SUPPORT_OUTPUT_CHECKS_H_
#define TILEMEND_TESTS_SUPPORT_OUTPUT_CHECKS_H_

#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "common/codec/mesh_file.h"
#include "tests/support/scene_maker.h"

namespace tilemend {

// Four by three cells with a lake over corners, small closed holes and one cell without surface.
SceneMakerOptions SmallScene(Cut cut);

// Writes the made scene to `folder`, and gives it.
std::string WriteMade(const SceneMakerOptions& options, const std::string& folder);

// The bytes of every file below `folder` by its relative path; a folder with nothing in it as "name/".
std::map<std::string, std::string> FilesBelow(const std::string& folder);
// The same of the tiles alone, which is what must not depend on workers.
std::map<std::string, std::string> TilesBelow(const std::string& folder);

nlohmann::json ReportOf(const std::string& out);

// Every input vertex and triangle is in the tile of the same name, first, and its coordinates have the same bits.
void ExpectOriginalsKept(const std::string& scene, const std::string& out);

// Over all tiles, equal positions welded: an edge with one triangle lies on the rim of the scene's cells. No edge has
// more than two, and none is used twice in one direction.
void ExpectClosed(const SceneMakerOptions& options, const std::string& out);

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_OUTPUT_CHECKS_H_
