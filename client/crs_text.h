// A CRS as people name it.
#ifndef TILEMEND_CLIENT_CRS_TEXT_H_
#define TILEMEND_CLIENT_CRS_TEXT_H_

#include <string>
#include <string_view>

namespace tilemend {

// "ETRS89 / UTM zone 32N (EPSG:25832)" of WKT 1 or 2: its name and, if it has one, its code. Any other text as it is.
// Printable. Cost: linear in the text.
std::string CrsText(std::string_view crs);

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_CRS_TEXT_H_
