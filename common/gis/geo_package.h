// GeoPackages as output.
#ifndef TILEMEND_COMMON_GIS_GEO_PACKAGE_H_
#define TILEMEND_COMMON_GIS_GEO_PACKAGE_H_

#include <string>

#include "absl/status/statusor.h"

namespace tilemend {

// The bytes of a GeoPackage with the features of `geojson`, which this program wrote, in one layer `layer`. In messages
// `name` stands for the file. Errors of AskGdal; kInternal if GDAL cannot write it.
absl::StatusOr<std::string> GeoPackageOf(const std::string& geojson, const std::string& layer, const std::string& name);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_GIS_GEO_PACKAGE_H_
