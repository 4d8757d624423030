// What GDAL gives of a layer, checked, in the coordinates of the file.
#ifndef TILEMEND_COMMON_GIS_RAW_FEATURES_H_
#define TILEMEND_COMMON_GIS_RAW_FEATURES_H_

#include <ogrsf_frmts.h>

#include <vector>

#include "common/gis/vector_file.h"

namespace tilemend {

// Why a file cannot be read.
struct BadVectors {
  std::string what;
};

// The features of a layer; `prefix` stands before their labels. Throws BadVectors.
std::vector<VectorFeature> RawFeaturesOf(OGRLayer& layer, const std::string& prefix);

// All polygons as one. Throws BadVectors if there is a line, an outline that crosses itself or another one of its
// feature, or no polygon.
VectorFeature Unite(const std::vector<VectorFeature>& features);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_GIS_RAW_FEATURES_H_
