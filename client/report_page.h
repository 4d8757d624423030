// report.html: the report of an output as one page that needs nothing else.
#ifndef TILEMEND_CLIENT_REPORT_PAGE_H_
#define TILEMEND_CLIENT_REPORT_PAGE_H_

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "absl/status/status.h"

namespace tilemend {

// The page with `data` (page_data.h) in it. Its policy allows no request at all, and no script and style but its own,
// by their SHA-256. No text of the data can end the element that it is in.
std::string ReportPage(const nlohmann::ordered_json& data);

// Writes report.html and holes.csv beside report.json in the folder `out` of an output. With acceptance.json it shows
// that verdict. Pictures need the scene that the report names; without it the page has none, and says why. Errors of
// ReadFile and WriteFileAtomically; kInvalidArgument if report.json is none. Cost: PagePictures, and linear in the
// report.
absl::Status WriteReportPage(const std::string& out);

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_REPORT_PAGE_H_
