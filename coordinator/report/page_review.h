// The review queue of the pages: the fills to decide on, with the polygons that decisions name.
#ifndef TILEMEND_COORDINATOR_REPORT_PAGE_REVIEW_H_
#define TILEMEND_COORDINATOR_REPORT_PAGE_REVIEW_H_

#include <cstddef>
#include <nlohmann/json.hpp>
#include <stop_token>
#include <string>

#include "absl/status/statusor.h"
#include "common/grid/scene.h"

namespace tilemend {

// Fills of less doubt are not in the page's queue: it holds the outline of each.
inline constexpr size_t kMostReviewItems = 1000;

// As JSON for the page (web/src/data.ts). `holes` is the text of holes.geojson.
//   count     of all fills with a doubt
//   items     those of the most doubt, as the report's `review` has them
//   z         the height of their levels' zero; null without `scene`
//   crs       of `holes`
//   outlines  base64 of gzip of an object: by hole number of the item a list of {hole, cluster, geometry}, one of each
//             of its holes that has a polygon
//   decided   count of `earlier`
//   earlier   the same of a list: the features of decisions that were made before, as they were made. The next file
//             has them too
// kInvalidArgument if `holes` is no GeoJSON, kCancelled after a stop. Cost: linear; features of other holes are dropped
// as they are read.
absl::StatusOr<nlohmann::ordered_json> PageReview(const nlohmann::ordered_json& report, const std::string& holes,
                                                  const Scene* scene, const std::stop_token& stop = {});

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_REPORT_PAGE_REVIEW_H_
