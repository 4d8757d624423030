#include "common/gis/lon_lat.h"

#include <cstring>

#include "absl/strings/str_cat.h"
#include "common/gis/gdal_process.h"
#include "common/gis/vector_message.h"
#include "common/util/status_macros.h"
#include "common/util/text.h"

namespace tilemend {

absl::StatusOr<std::vector<Point2>> LonLatOf(const std::string& crs, const std::vector<Point2>& points) {
  if (points.empty()) return std::vector<Point2>();
  std::string request(1, static_cast<char>(GdalTask::kLonLat));
  const size_t bytes = points.size() * sizeof(Point2);
  request.append(reinterpret_cast<const char*>(&bytes), sizeof(bytes));
  request.append(reinterpret_cast<const char*>(points.data()), bytes);
  TILEMEND_ASSIGN_OR_RETURN(const std::string answer, AskGdal(absl::StrCat(request, crs), "crs"));
  if (answer.size() != bytes) {
    return absl::InvalidArgumentError(absl::StrCat("crs '", Printable(crs),
                                                   "': PROJ does not know it, it is none in metres, or it has no "
                                                   "longitude and latitude for the scene's cells"));
  }
  std::vector<Point2> degrees(points.size());
  std::memcpy(static_cast<void*>(degrees.data()), answer.data(), bytes);
  return degrees;
}

}  // namespace tilemend
