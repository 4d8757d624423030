#include "client/water_proposal.h"

#include <limits>
#include <utility>
#include <vector>

#include "absl/strings/match.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "client/output_file.h"
#include "common/gis/geo_package.h"
#include "common/mesh/polygon_index.h"
#include "common/util/files.h"
#include "common/util/status_macros.h"
#include "coordinator/report/scene_geojson.h"
#include "worker/propose/water_surfaces.h"

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

constexpr char kPackage[] = ".gpkg";
constexpr char kGeoJson[] = ".geojson";
constexpr char kLayer[] = "water";

// Takes out what does not lie in the area: a polygon with `clear` across its edge would be refused.
void KeepInside(const PolygonIndex& area, GroundRaster& raster) {
  constexpr double kMargin = 0.05;  // metres, so that no square touches the edge
  for (int32_t row = raster.row; row < raster.row + raster.rows; ++row) {
    for (int32_t col = raster.col; col < raster.col + raster.cols; ++col) {
      const Point2 low = Point2(col, row) * raster.square - Point2::Constant(kMargin);
      const Point2 high = Point2(col + 1, row + 1) * raster.square + Point2::Constant(kMargin);
      const bool inside = area.Contains(low) && area.Contains(high) && area.Contains({low.x(), high.y()}) &&
                          area.Contains({high.x(), low.y()});
      if (!inside) raster.heights[raster.IndexOf(col, row)] = std::numeric_limits<float>::quiet_NaN();
    }
  }
}

std::vector<ProposedSurface> SurfacesOf(const SceneWaves& waves) {
  std::vector<GroundRaster> rasters;
  for (const auto& [cell, stored] : waves.survey().records()) {
    if (stored != nullptr) rasters.push_back(stored.Outline()->lowest);
  }
  const PlanePolygon& area = waves.scene().area;
  if (!area.empty()) {
    const PolygonIndex index(area);
    for (GroundRaster& raster : rasters) KeepInside(index, raster);
  }
  std::vector<ProposedSurface> surfaces;
  for (LowRegion& region : FindWaterSurfaces(rasters)) {
    const std::string reason =
        absl::StrFormat("level surface; ground along %.0f %% of its rim is higher by %g m or more",
                        100 * region.shore_share, LevelRegionOptions().bank);
    surfaces.push_back({std::move(region.outline), region.level, region.sigma, region.area, reason});
  }
  return surfaces;
}

}  // namespace

absl::Status CheckWaterProposal(const std::string& path, bool overwrite) {
  if (!absl::EndsWithIgnoreCase(path, kPackage) && !absl::EndsWithIgnoreCase(path, kGeoJson)) {
    return absl::InvalidArgumentError(
        absl::StrCat(path, ": expected a name that ends in ", kPackage, " or ", kGeoJson));
  }
  return CheckOutputFile(path, overwrite, "--propose-water");
}

absl::StatusOr<Json> WriteWaterProposal(const std::string& path, bool overwrite, const SceneWaves& waves) {
  TILEMEND_RETURN_IF_ERROR(CheckWaterProposal(path, overwrite));
  const std::vector<ProposedSurface> surfaces = SurfacesOf(waves);
  std::string content = ProposalsGeoJson(waves.plan(), surfaces, waves.scene());
  Json proposed = Json::array();
  const Json file = Json::parse(content);
  for (const Json& feature : file["features"]) proposed.push_back(feature["properties"]);
  if (absl::EndsWithIgnoreCase(path, kPackage)) {
    TILEMEND_ASSIGN_OR_RETURN(content, GeoPackageOf(content, kLayer, path));
  }
  TILEMEND_RETURN_IF_ERROR(WriteFileAtomically(path, content));
  return proposed;
}

}  // namespace tilemend
