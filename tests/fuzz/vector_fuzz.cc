// Formats beside GeoJSON: the first byte chooses one. DXF is not among them: GDAL 3.6 never ends on some of it, which
// the limits of the process end (gdal_main.cc).
#include <array>
#include <string>

#include "tests/fuzz/fuzz_target.h"
#include "tests/fuzz/vector_checks.h"

namespace {

constexpr std::array<const char*, 4> kNames = {"lakes.kml", "lakes.gml", "lakes.mif", "lakes.shp"};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  if (size == 0) return 0;
  tilemend::ReadAndCheck(tilemend::VectorFormat::kOther, kNames[data[0] % kNames.size()],
                         {reinterpret_cast<const char*>(data) + 1, size - 1});
  return 0;
}

namespace tilemend {

std::vector<std::string> FuzzSeeds() {
  const std::string ring = "0,0 9,0 9,9 0,0";
  return {
      std::string("\0", 1) +
          "<kml xmlns=\"http://www.opengis.net/kml/2.2\"><Document><Placemark><name>Pond</name>"
          "<ExtendedData><Data name=\"level_m\"><value>3.25 m</value></Data></ExtendedData>"
          "<Polygon><outerBoundaryIs><LinearRing><coordinates>" +
          ring + "</coordinates></LinearRing></outerBoundaryIs></Polygon></Placemark></Document></kml>",
      "\1<w:FeatureCollection xmlns:w=\"w\" xmlns:gml=\"http://www.opengis.net/gml\"><gml:featureMember><w:lake>"
      "<w:geometry><gml:Polygon><gml:outerBoundaryIs><gml:LinearRing><gml:coordinates>" +
          ring +
          "</gml:coordinates></gml:LinearRing></gml:outerBoundaryIs></gml:Polygon></w:geometry><w:kind>lake</w:kind>"
          "</w:lake></gml:featureMember></w:FeatureCollection>",
      "\2Version 300\nCharset \"Neutral\"\nDelimiter \",\"\nColumns 1\n  water Char(5)\nData\n\nRegion 1\n  4\n0 0\n9 "
      "0\n"
      "9 9\n0 0\n"};
}

}  // namespace tilemend
