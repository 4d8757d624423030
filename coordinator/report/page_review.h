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
// Of the outlines of other fills, together. Packed, each takes some 9 bytes: a page is at most 5 MB longer, and a
// browser unpacks 12 MB.
inline constexpr size_t kMostOutlinePositions = 500'000;

// How many fills wait for a decision: the rows of the report's `review`. 0 if it has none.
size_t FillsToDecideOn(const nlohmann::ordered_json& report);

// As JSON for the page (web/src/data.ts). `holes` is the text of holes.geojson.
//   count     FillsToDecideOn
//   items     those of the most doubt, as the report's `review` has them
//   z         the height of their levels' zero; null without `scene`
//   crs       of `holes`
//   scene     that `holes` is of (scene_member.h); null if it does not say
//   outlines  base64 of gzip of an object: by hole number of the item a list of {hole, cluster, geometry}, one of each
//             of its holes that has a polygon
//   others    the same of an object: by number of another hole with a fill its {hole, cluster, geometry}. Of holes that
//             the page lists (kMostListedHoles), those of one cluster together, the largest first, while their
//             positions are at most kMostOutlinePositions
//   without_outline
//             numbers of the other holes with a fill that the page lists and of whose cluster none is in `others`: they
//             cannot be decided on
//   decided   count of `earlier`
//   earlier   the same of a list: the features of decisions that were made before, as they were made. The next file
//             has them too
// kInvalidArgument if `holes` is no GeoJSON, kCancelled after a stop. Cost: linear; features of other holes are dropped
// as they are read.
absl::StatusOr<nlohmann::ordered_json> PageReview(const nlohmann::ordered_json& report, const std::string& holes,
                                                  const Scene* scene, const std::stop_token& stop = {});

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_REPORT_PAGE_REVIEW_H_
