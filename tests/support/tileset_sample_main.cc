// tileset_sample FOLDER one|of-tiles|on-earth|earth-centred: writes the made scene of 3D Tiles (tileset_scene.h).
#include <cstdio>
#include <filesystem>
#include <map>
#include <string>

#include "common/util/files.h"
#include "tests/support/tileset_scene.h"

int main(int count, char** words) {
  using namespace tilemend;
  const std::map<std::string, TilesetScene> scenes = {{"one", {}},
                                                      {"of-tiles", {.files = TilesetScene::Files::kOfTiles}},
                                                      {"on-earth", {.place = TilesetScene::Place::kOnEarth}},
                                                      {"earth-centred", {.place = TilesetScene::Place::kEarthCentred}}};
  if (count != 3 || !scenes.contains(words[2])) return 2;
  for (const auto& [path, bytes] : scenes.at(words[2]).All()) {
    const std::filesystem::path file = std::filesystem::path(words[1]) / path;
    std::filesystem::create_directories(file.parent_path());
    const absl::Status status = WriteFileAtomically(file.string(), bytes);
    if (!status.ok()) return std::fprintf(stderr, "%s\n", std::string(status.message()).c_str()), 1;
  }
  return 0;
}
