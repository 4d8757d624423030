// The properties of a feature that have an effect (property_names.h).
#ifndef TILEMEND_COMMON_GIS_FEATURE_PROPERTIES_H_
#define TILEMEND_COMMON_GIS_FEATURE_PROPERTIES_H_

#include <ogrsf_frmts.h>

#include <string>

#include "common/gis/vector_file.h"

namespace tilemend {

// The index of a property that has a value, or -1. Null and blank text are none: formats without null have that.
int FieldOf(const OGRFeature& feature, const char* name);

// A name out of the file as messages show it: on one line, and no more than 100 columns of it.
std::string ShownName(const std::string& name);

// "feature 3 (Pond)", with `prefix` before it.
std::string LabelOf(const OGRFeature& feature, const std::string& prefix);

// Sets all members of `to` that are properties, but not its centreline. Values of `water` and `clear` may be a boolean,
// 0 or 1, or a word as in dBase (true, yes, t, y and their opposites). Values of `level_m` and `clear_height` may be a
// number or text ("3.25", "3.25 m"). The kind is "lake" or "river". In text, case and blanks around do not matter.
// Throws BadVectors with the feature's label.
void SetProperties(const OGRFeature& feature, VectorFeature& to);

// Of a reviewed hole: sets its decision ("accept", "water", "ground" or "open"), the number of the hole, and its level,
// as above. The cluster of holes becomes its body. Throws BadVectors with the feature's label.
void SetDecision(const OGRFeature& feature, VectorFeature& to);

// The property `centreline`: a GeoJSON LineString or its coordinates, or WKT; empty if there is none. Throws BadVectors
// with `place`.
std::vector<Point2> CentrelineOf(const OGRFeature& feature, const std::string& place);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_GIS_FEATURE_PROPERTIES_H_
