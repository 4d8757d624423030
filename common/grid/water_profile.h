// Which waters are large enough to be levelled without being asked for.
#ifndef TILEMEND_COMMON_GRID_WATER_PROFILE_H_
#define TILEMEND_COMMON_GRID_WATER_PROFILE_H_

#include <algorithm>
#include <iterator>
#include <string_view>

namespace tilemend {

struct WaterProfile {
  const char* name;
  double least_lake;   // m2
  double least_river;  // metres, mean width
  double least_level;  // m2: smaller holes with a level rim are filled like the surface around them
};

// The default first. "usgs" has the thresholds of the USGS Lidar Base Specification 2024, "Hydro-flattening". They are
// ponds and lakes of 2 acres (8,000 m2), rivers 100 feet (30 m) wide.
inline constexpr WaterProfile kWaterProfiles[] = {{"city", 1000, 6, 100}, {"usgs", 8000, 30, 8000}};

// nullptr: there is none of this name.
inline const WaterProfile* WaterProfileNamed(std::string_view name) {
  const auto* found = std::find_if(std::begin(kWaterProfiles), std::end(kWaterProfiles),
                                   [name](const WaterProfile& profile) { return profile.name == name; });
  return found == std::end(kWaterProfiles) ? nullptr : found;
}

}  // namespace tilemend

#endif  // TILEMEND_COMMON_GRID_WATER_PROFILE_H_
