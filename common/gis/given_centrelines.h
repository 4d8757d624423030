// Centrelines that are features of their own.
#ifndef TILEMEND_COMMON_GIS_GIVEN_CENTRELINES_H_
#define TILEMEND_COMMON_GIS_GIVEN_CENTRELINES_H_

#include <stop_token>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "common/gis/area_file.h"
#include "common/mesh/polygon_index.h"

namespace tilemend {

// Whether more than half of the points are inside.
bool MostLiesIn(const PolygonIndex& polygon, const std::vector<Point2>& points);

// Gives each of the lines to the area of water in the file that most of its points are in, of equal ones the first. Of
// lines that are in none there is a warning. kInvalidArgument with `name`: two for one area. kCancelled once `stop` is
// requested. Cost for n areas: O(n log n), and PolygonIndex::Contains for each point of a line in each area near it.
absl::Status GiveCentrelines(std::vector<VectorFeature> features, const std::string& name, const std::stop_token& stop,
                             WaterFile& file);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_GIS_GIVEN_CENTRELINES_H_
