// The input holds the files of a tileset, with a line of three equals signs between them: tileset.json, then 1.json,
// 2.json and so on.
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "tests/fuzz/fuzz_target.h"
#include "tests/support/tileset_samples.h"

namespace tilemend {
namespace {

constexpr std::string_view kSeparator = "\n===\n";

std::map<std::string, std::string> FilesOf(std::string_view bytes) {
  std::map<std::string, std::string> files;
  for (size_t begin = 0; begin <= bytes.size();) {
    const size_t end = std::min(bytes.find(kSeparator, begin), bytes.size());
    const std::string name = files.empty() ? "tileset.json" : std::to_string(files.size()) + ".json";
    files[name] = std::string(bytes.substr(begin, end - begin));
    begin = end + kSeparator.size();
  }
  return files;
}

bool StaysBelow(const std::string& path) {
  const std::filesystem::path p = path;
  return p.is_relative() && p.lexically_normal() == p && !path.starts_with("..");
}

std::string Violation(std::string_view bytes) {
  std::map<std::string, std::string> files = FilesOf(bytes);
  absl::StatusOr<Tileset> tileset = ReadTileset(MemorySource(files), "tileset.json", {.max_tiles = 10000});
  if (!tileset.ok()) {
    if (absl::IsNotFound(tileset.status())) return "";
    const absl::string_view message = tileset.status().message();
    return message.find(".json: ") != absl::string_view::npos ? "" : tileset.status().ToString();
  }
  for (const TilesetTile& tile : tileset->tiles) {
    if (!tile.content.empty() && !StaysBelow(tile.content)) return "a path leads out: " + tile.content;
  }
  for (int32_t i = 0; i < static_cast<int32_t>(tileset->documents.size()); ++i) {
    if (WriteTilesetDocument(*tileset, i) != tileset->documents[static_cast<size_t>(i)].text) return "text changed";
  }
  const auto last = static_cast<int32_t>(tileset->tiles.size()) - 1;
  GrowVolumes(*tileset, last, {{1, 2, 3}, {-500, 700, 4000}});
  for (int32_t i = 0; i < static_cast<int32_t>(tileset->documents.size()); ++i) {
    files[tileset->documents[static_cast<size_t>(i)].file] = WriteTilesetDocument(*tileset, i);
  }
  const absl::StatusOr<Tileset> again = ReadTileset(MemorySource(files), "tileset.json");
  // A volume of 1e308 m may overflow.
  if (!again.ok()) return again.status().message().find("finite") != absl::string_view::npos ? "" : "not read again";
  if (again->tiles.size() != tileset->tiles.size()) return "other number of tiles";
  for (size_t i = 0; i < again->tiles.size(); ++i) {
    if (again->tiles[i].volume != tileset->tiles[i].volume) return "other volume";
    if (again->tiles[i].content != tileset->tiles[i].content) return "other content";
  }
  return "";
}

}  // namespace

std::vector<std::string> FuzzSeeds() {
  const std::string region = R"({"boundingVolume":{"region":[0.1,0.2,0.3,0.4,-5,50]},"geometricError":1})";
  const std::string sphere = R"({"boundingVolume":{"sphere":[1,2,3,40]},"geometricError":0,"refine":"ADD"})";
  const std::string up = R"({"asset":{"version":"1.0","gltfUpAxis":"Z"},"root":)" + TileJson("c.b3dm") + "}";
  return {TilesetJson(TileJson("a.glb", ",\"refine\":\"REPLACE\",\"children\":[" + TileJson("1.json") + "]")) +
              std::string(kSeparator) + TilesetJson(TileJson("b.glb")),
          TilesetJson(TileJson("1.json")) + std::string(kSeparator) + TilesetJson(TileJson("2.json")) +
              std::string(kSeparator) + TilesetJson(region),
          TilesetJson(region),
          TilesetJson(sphere),
          up,
          TilesetJson(TileJson("x.glb", R"(,"transform":[1,0,0,0,0,1,0,0,0,0,1,0,9,8,7,1])"))};
}

}  // namespace tilemend

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string violation = tilemend::Violation({reinterpret_cast<const char*>(data), size});
  if (violation.empty()) return 0;
  std::fprintf(stderr, "%s\n", violation.c_str());
  std::abort();
}
