// The page of the coordinator, as it is built from web/, compressed by gzip.
#ifndef TILEMEND_COORDINATOR_WEB_PAGE_ASSETS_H_
#define TILEMEND_COORDINATOR_WEB_PAGE_ASSETS_H_

#include <string_view>

namespace tilemend {

std::string_view ConsoleScript();  // web/dist/console.js
std::string_view ConsoleStyle();   // web/dist/console.css
std::string_view DracoDecoder();   // web/dist/draco_decoder.js

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_WEB_PAGE_ASSETS_H_
