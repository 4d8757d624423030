// The properties of a polygon of water or of a reviewed hole, and names that are likely meant for one of them.
#ifndef TILEMEND_COMMON_GIS_PROPERTY_NAMES_H_
#define TILEMEND_COMMON_GIS_PROPERTY_NAMES_H_

#include <string_view>

namespace tilemend {

inline constexpr char kWaterProperty[] = "water";
inline constexpr char kLevelProperty[] = "level_m";
inline constexpr char kCentrelineProperty[] = "centreline";
inline constexpr char kKindProperty[] = "kind";
inline constexpr char kClearProperty[] = "clear";
inline constexpr char kClearHeightProperty[] = "clear_height";
inline constexpr char kShortClearHeight[] = "clear_heig";  // the same in a shapefile, whose names have ten letters

// Of a reviewed hole.
inline constexpr char kDecisionProperty[] = "decision";

// Of holes.geojson: the number of the hole, and of the water that it is part of.
inline constexpr char kHoleProperty[] = "hole";
inline constexpr char kBodyProperty[] = "body";
// Of a level that nobody gave: the same again, and its standard deviation. Who changes level_m gives a level.
inline constexpr char kEstimateProperty[] = "estimate_m";
inline constexpr char kSigmaProperty[] = "sigma_m";
// Who said that it is water, kByRim or a polygon, and what it was taken for then.
inline constexpr char kDecidedByProperty[] = "decided_by";
inline constexpr char kByRim[] = "rim";
inline constexpr char kByArea[] = "area";
inline constexpr char kTakenForProperty[] = "taken_for";
inline constexpr char kClusterProperty[] = "cluster";  // open holes that are one, over several cells

// The one of these that a property of another name is likely meant for, "" if none. It has the same letters but for
// case and what is between them ("Centre Line"), or is another word for it ("elevation"). Or one letter in four of it
// is put in, taken out or changed ("watr"). Files from a GIS have dozens of other properties: "layer" is not near
// "water".
std::string_view PropertyMeantBy(std::string_view name);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_GIS_PROPERTY_NAMES_H_
