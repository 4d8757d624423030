// Where a scene lies, whatever path names it.
#ifndef TILEMEND_COMMON_GRID_SCENE_PLACE_H_
#define TILEMEND_COMMON_GRID_SCENE_PLACE_H_

#include <string>

namespace tilemend {

// What tells apart scenes that LoadScene reads: the path without links, and the folder for the scene.json in it.
std::string ScenePlaceOf(const std::string& path);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_GRID_SCENE_PLACE_H_
