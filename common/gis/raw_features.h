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

struct RawFeatures {
  std::vector<VectorFeature> features;
  std::vector<std::string> warnings;
};

enum class Crossings { kRepair, kRefuse };

// A name out of the file as messages show it: on one line, and no more than 100 columns of it.
std::string ShownName(const std::string& name);

// The features of a layer; `prefix` stands before their labels. A polygon that is not valid (outlines that cross, parts
// that lie over each other) is repaired, with a warning that says where: what any part surrounds is inside. With
// kRefuse outlines that cross are not. Throws BadVectors.
RawFeatures RawFeaturesOf(OGRLayer& layer, const std::string& prefix, Crossings crossings);

// Warnings of properties that polygons have in vain: their names are near one that has an effect (property_names.h),
// which the polygon does not have. One warning for each name, with the first polygon.
std::vector<std::string> NearMisses(OGRLayer& layer, const std::string& prefix);

// All polygons as one. Throws BadVectors if there is a line, or no polygon.
VectorFeature Unite(const std::vector<VectorFeature>& features);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_GIS_RAW_FEATURES_H_
