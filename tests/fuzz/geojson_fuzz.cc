#include <string>

#include "tests/fuzz/fuzz_target.h"
#include "tests/fuzz/vector_checks.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  tilemend::ReadAndCheck(tilemend::VectorFormat::kGeoJson, "lakes.geojson",
                         {reinterpret_cast<const char*>(data), size});
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
