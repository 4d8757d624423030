// What the coordinates of a layer are taken for.
#ifndef TILEMEND_COMMON_GIS_COORDINATE_READING_H_
#define TILEMEND_COMMON_GIS_COORDINATE_READING_H_

#include <ogr_spatialref.h>

#include <string>
#include <vector>

#include "common/gis/vector_file.h"

namespace tilemend {

// Puts the features of a layer into the scene's coordinates as ReadVectors says; returns what they were taken for. The
// CRS that the layer names is `named`, or null. Appends warnings. Throws BadVectors.
std::string PlaceInScene(const SceneFrame& frame, const OGRSpatialReference* named,
                         std::vector<VectorFeature>& features, std::vector<std::string>& warnings);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_GIS_COORDINATE_READING_H_
