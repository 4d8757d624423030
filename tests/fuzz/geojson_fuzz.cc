#include <cmath>
#include <cstdlib>
#include <string>

#include "common/gis/area_file.h"
#include "tests/fuzz/fuzz_target.h"

// Whatever the bytes: areas with finite coordinates and rings of at least three points, or an error that names the
// file.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const auto areas = tilemend::ParseWaterFile({reinterpret_cast<const char*>(data), size}, "lakes.geojson", {});
  if (!areas.ok()) {
    if (areas.status().message().find("lakes.geojson: ") != 0) std::abort();
    return 0;
  }
  for (const tilemend::WaterArea& area : areas->areas) {
    for (const auto& ring : area.polygon.rings) {
      if (ring.size() < 3) std::abort();
      for (const tilemend::Point2& p : ring) {
        if (!p.allFinite()) std::abort();
      }
    }
  }
  return 0;
}

namespace tilemend {

std::vector<std::string> FuzzSeeds() {
  return {
      R"({"type":"Polygon","coordinates":[[[0,0],[9,0],[9,9],[0,0]],[[1,1],[2,1],[2,2],[1,1]]]})",
      R"({"type":"Feature","properties":{"water":false},"geometry":{"type":"MultiPolygon","coordinates":)"
      R"([[[[0,0,5],[1e3,0],[9,-9.5],[0,0,5]]],[]]}})",
      R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":null,"geometry":{"type":"Polygon",)"
      R"("coordinates":[[[0,0],[9,0],[9,9],[0,0]]]}}, {"type":"Feature","properties":{"water":null},"geometry":null}]})"};
}

}  // namespace tilemend
