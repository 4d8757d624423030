#include "client/mesh/single_mesh.h"

namespace tilemend {

Scene SceneOfMesh(const std::string& path) {
  Scene scene;
  scene.cols = scene.rows = 1;
  scene.tiles = {{{0, 0}, path}};
  return scene;
}

}  // namespace tilemend
