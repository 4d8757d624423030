#include "common/gis/geo_package.h"

#include "absl/strings/str_cat.h"
#include "common/gis/gdal_process.h"
#include "common/gis/vector_message.h"
#include "common/util/status_macros.h"

namespace tilemend {

absl::StatusOr<std::string> GeoPackageOf(const std::string& geojson, const std::string& layer,
                                         const std::string& name) {
  const std::string message = static_cast<char>(GdalTask::kWritePackage) + layer + "\n" + geojson;
  TILEMEND_ASSIGN_OR_RETURN(std::string package, AskGdal(message, name));
  if (package.empty()) return absl::InternalError(absl::StrCat(name, ": GDAL cannot write it"));
  return package;
}

}  // namespace tilemend
