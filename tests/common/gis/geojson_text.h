// GeoJSON for tests.
#ifndef TILEMEND_TESTS_COMMON_GIS_GEOJSON_TEXT_H_
#define TILEMEND_TESTS_COMMON_GIS_GEOJSON_TEXT_H_

#include <string>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "absl/strings/str_join.h"
#include "common/mesh/tri_mesh.h"

namespace tilemend {

inline std::string PositionsText(const std::vector<Point2>& points) {
  return absl::StrCat("[",
                      absl::StrJoin(points, ",",
                                    [](std::string* out, const Point2& p) {
                                      absl::StrAppendFormat(out, "[%.12f,%.12f]", p.x(), p.y());
                                    }),
                      "]");
}

inline std::string PolygonText(std::vector<Point2> ring) {
  ring.push_back(ring.front());
  return absl::StrCat(R"({"type":"Polygon","coordinates":[)", PositionsText(ring), "]}");
}

inline std::string LineText(const std::vector<Point2>& points) {
  return absl::StrCat(R"({"type":"LineString","coordinates":)", PositionsText(points), "}");
}

inline std::string FeatureText(const std::string& geometry, const std::string& properties = "{}") {
  return absl::StrCat(R"({"type":"Feature","properties":)", properties, R"(,"geometry":)", geometry, "}");
}

// `crs` is a name, or "" for none.
inline std::string CollectionText(const std::vector<std::string>& features, const std::string& crs = "") {
  const std::string member =
      crs.empty() ? "" : absl::StrCat(R"("crs":{"type":"name","properties":{"name":")", crs, R"("}},)");
  return absl::StrCat(R"({"type":"FeatureCollection",)", member, R"("features":[)", absl::StrJoin(features, ","), "]}");
}

// Corners of a square, from the lower left.
inline std::vector<Point2> SquareAt(double x, double y, double side) {
  return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
}

}  // namespace tilemend

#endif  // TILEMEND_TESTS_COMMON_GIS_GEOJSON_TEXT_H_
