// scene.json and metadata.xml.
#include <cstdlib>
#include <string>

#include "common/grid/scene_sources.h"
#include "tests/fuzz/fuzz_target.h"

namespace tilemend {
namespace {

// Whatever the bytes: a scene whose text is read back as the same, or an error that names the file.
void CheckJson(const std::string& text) {
  const auto scene = ParseSceneJson(text, "scene.json");
  if (!scene.ok()) {
    if (scene.status().message().find("scene.json: ") != 0) std::abort();
    return;
  }
  const std::string written = SceneJson(*scene);
  const auto again = ParseSceneJson(written, "scene.json");
  if (!again.ok() || SceneJson(*again) != written) std::abort();
}

void CheckMetadata(const std::string& text) {
  Scene scene;
  const absl::Status status = ParseMetadata(text, "metadata.xml", &scene);
  if (status.ok() ? !scene.origin.allFinite() : status.message().find("metadata.xml: ") != 0) std::abort();
}

}  // namespace
}  // namespace tilemend

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  tilemend::CheckJson(text);
  tilemend::CheckMetadata(text);
  return 0;
}

namespace tilemend {

std::vector<std::string> FuzzSeeds() {
  return {R"({"crs": "EPSG:32650", "origin": [500000, 4100000.5, 12], "grid_corner": [-3, 1e3], "cell_size": [250, 125],
              "cols": 2, "rows": 2, "area_known": false, "area": {"type": "MultiPolygon", "coordinates":
              [[[[0, 0], [9, 0], [9, 9], [0, 0]], [[1, 1], [2, 1], [2, 2], [1, 1]]], [[[20, 0], [30, 0], [30, 9], [20, 0]]]]},
              "tiles": [{"col": 0, "row": 1, "path": "tiles/a.ply"}, {"col": 1, "row": 1, "path": null}]})",
          R"({"cell_size": 10, "cols": 1, "rows": 1, "area": "area.geojson",
              "tiles": [{"col": 0, "row": 0, "path": "b.OBJ"}]})",
          R"(<?xml version="1.0" encoding="utf-8"?><ModelMetadata version="1"><!-- a note --><SRS>EPSG:32650</SRS>
             <SRSOrigin>500000.0,4100000,-1e1</SRSOrigin><Texture><ColorSource>Visible &amp; more</ColorSource></Texture>
             </ModelMetadata>)"};
}

}  // namespace tilemend
