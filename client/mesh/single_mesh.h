// A single mesh as a scene.
#ifndef TILEMEND_CLIENT_MESH_SINGLE_MESH_H_
#define TILEMEND_CLIENT_MESH_SINGLE_MESH_H_

#include <string>

#include "common/grid/scene.h"

namespace tilemend {

// One cell (0, 0) with the tile `path`, and no grid: the cell's size is 0.
Scene SceneOfMesh(const std::string& path);

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_MESH_SINGLE_MESH_H_
