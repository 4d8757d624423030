// Tilesets in memory, for tests.
#ifndef TILEMEND_TESTS_SUPPORT_TILESET_SAMPLES_H_
#define TILEMEND_TESTS_SUPPORT_TILESET_SAMPLES_H_

#include <map>
#include <string>
#include <utility>

#include "common/codec/tiles3d/tileset.h"

namespace tilemend {

class MemorySource : public TilesetSource {
 public:
  explicit MemorySource(std::map<std::string, std::string> files) : files_(std::move(files)) {}

  absl::StatusOr<std::string> Read(const std::string& file) const override {
    const auto it = files_.find(file);
    if (it == files_.end()) return absl::NotFoundError(file + ": not found");
    return it->second;
  }

 private:
  std::map<std::string, std::string> files_;
};

// A tile without children; `more` is put behind its members, and begins with a comma.
inline std::string TileJson(const std::string& uri, const std::string& more = "") {
  return R"({"boundingVolume":{"box":[0,0,0,10,0,0,0,20,0,0,0,5]},"geometricError":2.5,"content":{"uri":")" + uri +
         "\"}" + more + "}";
}

inline std::string TilesetJson(const std::string& root, const std::string& version = "1.1") {
  return R"({"asset":{"version":")" + version + R"("},"geometricError":64,"root":)" + root + "}";
}

// An entry of two levels, whose second child is an external tileset in a folder of its own.
inline MemorySource TwoFileTileset() {
  const std::string moved = R"(,"transform":[1,0,0,0,0,1,0,0,0,0,1,0,100,200,0,1],"extras":{"survey":"May"})";
  const std::string children = ",\"refine\":\"REPLACE\",\"children\":[" + TileJson("Data/a_fine.b3dm") + "," +
                               TileJson("Data/B/b.json", moved) + "]";
  return MemorySource({{"tileset.json", TilesetJson(TileJson("Data/a.glb", children))},
                       {"Data/B/b.json", TilesetJson(TileJson("b%20fine.glb", moved), "1.0")}});
}

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_TILESET_SAMPLES_H_
