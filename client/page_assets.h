// The script and the style of report.html, as they are built from web/.
#ifndef TILEMEND_CLIENT_PAGE_ASSETS_H_
#define TILEMEND_CLIENT_PAGE_ASSETS_H_

#include <string_view>

namespace tilemend {

std::string_view PageScript();  // web/dist/report.js
std::string_view PageStyle();   // web/dist/report.css

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_PAGE_ASSETS_H_
