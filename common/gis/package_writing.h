// Writes GeoPackages, by GDAL, in the process that it runs in (gdal_process.h).
#ifndef TILEMEND_COMMON_GIS_PACKAGE_WRITING_H_
#define TILEMEND_COMMON_GIS_PACKAGE_WRITING_H_

#include <string>

namespace tilemend {

// The bytes of a GeoPackage with the features of `geojson` in a layer `layer`; empty where GDAL fails. The same bytes
// for the same input but for the time of writing, which is left out.
std::string PackageOf(const std::string& geojson, const std::string& layer);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_GIS_PACKAGE_WRITING_H_
