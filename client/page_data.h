// What report.html shows, as JSON for its script.
#ifndef TILEMEND_CLIENT_PAGE_DATA_H_
#define TILEMEND_CLIENT_PAGE_DATA_H_

#include <nlohmann/json.hpp>
#include <string>

#include "client/page_pictures.h"
#include "common/grid/scene.h"

namespace tilemend {

// The members of the report that the page shows, the options that are not the defaults, the state of each cell, and the
// pictures as base64. The `scene` gives the cells without a hole; if it is null, only the cells in the report are
// shown. The form is declared in web/src/data.ts. Linear.
nlohmann::ordered_json PageData(const nlohmann::ordered_json& report, const Scene* scene, const PagePictures& pictures);

// per_hole of the report as CSV: one line a hole. Quoted as AcceptanceCsv.
std::string HolesCsv(const nlohmann::ordered_json& report);

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_PAGE_DATA_H_
