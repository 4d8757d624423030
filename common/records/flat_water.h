// How flat level water is.
#ifndef TILEMEND_COMMON_RECORDS_FLAT_WATER_H_
#define TILEMEND_COMMON_RECORDS_FLAT_WATER_H_

namespace tilemend {

// Metres: surface that is no further off the level of its water is as flat as water has to be.
inline constexpr double kFlatWithin = 0.02;

}  // namespace tilemend

#endif  // TILEMEND_COMMON_RECORDS_FLAT_WATER_H_
