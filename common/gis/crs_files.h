// Files that the text of a CRS names, which PROJ would open wherever they lie.
#ifndef TILEMEND_COMMON_GIS_CRS_FILES_H_
#define TILEMEND_COMMON_GIS_CRS_FILES_H_

#include <string>

namespace tilemend {

// The first part of a PROJ string or of WKT that names a file: "nadgrids=/etc/passwd"; "" if none does. The value
// "@null" is no file: programs write it for a datum without a shift. "init=epsg:" is a code of EPSG. Cost O(text).
std::string FileNamedIn(const std::string& crs);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_GIS_CRS_FILES_H_
