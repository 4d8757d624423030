// What a GIS shows of an output: holes.geojson and breaklines.geojson.
#ifndef TILEMEND_COORDINATOR_REPORT_SCENE_GEOJSON_H_
#define TILEMEND_COORDINATOR_REPORT_SCENE_GEOJSON_H_

#include <string>
#include <vector>

#include "common/grid/scene.h"
#include "coordinator/report/scene_report.h"

namespace tilemend {

// Both: GeoJSON in the scene's CRS (scene coordinates plus the origin, millimetres), named by the member `crs` that
// GDAL and QGIS honour. Without a CRS the member says that there is none. Features are in the order of the plan.

// Every hole, as valid Polygons, or MultiPolygons, with islands, of what its boundary winds around seen from above.
// Some holes are MultiLineStrings of their rim: those that are not closed, as where a tile is missing, or less than a
// millimetre wide. For the properties see docs/user-guide.md, "Files for a GIS". ParseWaterFile reads those that are
// water.
std::string HolesGeoJson(const SceneReportInput& input, const Scene& scene);

// The waters that were levelled: of each its shore, as a polygon; of rivers the centreline as well. Every point has the
// level there as its height. ParseWaterFile reads it.
std::string BreaklinesGeoJson(const SceneReportInput& input, const Scene& scene);

// Surface that looks like water, in metres relative to the scene's origin.
struct ProposedSurface {
  PlanePolygon outline;
  double level = 0, sigma = 0, area = 0;  // metres, metres, m2
  std::string reason;
};

// Polygons for --water: the waters of the plan, level holes as large as the smallest lake, and surfaces, which have the
// property `clear`. Each has `proposed_level_m`, its standard deviation and the reason. Its `level_m` is null: the
// level is estimated when it is filled. ParseWaterFile reads it.
std::string ProposalsGeoJson(const Plan& plan, const std::vector<ProposedSurface>& surfaces, const Scene& scene);

// An area of the scene, with what is inside on the left of its rings. ParseAreaFile reads it.
std::string AreaGeoJson(const PlanePolygon& area, const Scene& scene);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_REPORT_SCENE_GEOJSON_H_
