// What GDAL gives of a layer, checked, in the coordinates of the file.
#ifndef TILEMEND_COMMON_GIS_RAW_FEATURES_H_
#define TILEMEND_COMMON_GIS_RAW_FEATURES_H_

#include <ogrsf_frmts.h>

#include <string>
#include <vector>

#include "common/gis/vector_file.h"

namespace tilemend {

struct RawFeatures {
  std::vector<VectorFeature> features;
  std::vector<std::string> warnings;
};

// How the features of a layer are taken.
struct LayerRules {
  VectorUse use = VectorUse::kWater;
  bool is_drawing = false;      // closed lines are polygons, and there are no other lines
  bool needs_geometry = false;  // a feature without one is refused: GDAL leaves out what it cannot read of GeoJSON
};

// The features of a layer; `prefix` stands before their labels. A polygon that is not valid has outlines that cross, or
// parts that lie over each other. It is repaired, with a warning that says where: what any part surrounds is inside.
// Features that are no polygon and no line are left out, with a warning that counts them. So are those of holes.geojson
// that are no water. Those of one body there that say the same are one feature. Throws BadVectors.
RawFeatures RawFeaturesOf(OGRLayer& layer, const std::string& prefix, const LayerRules& rules);

// Warnings of properties that polygons have in vain: their names are near one that has an effect (property_names.h),
// which the polygon does not have. One warning for each name, with the first polygon.
std::vector<std::string> NearMisses(OGRLayer& layer, const std::string& prefix);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_GIS_RAW_FEATURES_H_
