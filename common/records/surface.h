// The surfaces that holes can be filled with.
#ifndef TILEMEND_COMMON_RECORDS_SURFACE_H_
#define TILEMEND_COMMON_RECORDS_SURFACE_H_

#include <optional>
#include <string_view>

namespace tilemend {

// How the heights inside a patch are found: the surface that bends least, or Wang 2021, eq. 1 to 4.
enum class Surface { kThinPlate, kWang };

inline constexpr Surface kDefaultSurface = Surface::kThinPlate;

// Gamma of Wang 2021, eq. 5, where none is given.
inline constexpr double kSeamSmoothing = 0.5;

// "thin-plate" or "wang", as flags, jobs and reports say it.
constexpr const char* SurfaceName(Surface surface) { return surface == Surface::kThinPlate ? "thin-plate" : "wang"; }

// The surface of that name; nothing for any other text.
constexpr std::optional<Surface> SurfaceNamed(std::string_view name) {
  for (const Surface surface : {Surface::kThinPlate, Surface::kWang}) {
    if (name == SurfaceName(surface)) return surface;
  }
  return std::nullopt;
}

}  // namespace tilemend

#endif  // TILEMEND_COMMON_RECORDS_SURFACE_H_
