// The surfaces that holes can be filled with.
#ifndef TILEMEND_COMMON_RECORDS_SURFACE_H_
#define TILEMEND_COMMON_RECORDS_SURFACE_H_

#include <cstdint>
#include <optional>
#include <string_view>

namespace tilemend {

// How the heights inside a patch are found: the surface that bends least, or Wang 2021, eq. 1 to 4.
enum class Surface { kThinPlate, kWang };

inline constexpr Surface kDefaultSurface = Surface::kThinPlate;

// Where new vertices lie on a grid line inside a hole.
enum class SeamPoints {
  kProjected,  // opposite the boundary points of the two cells beside it (Wang 2021, 3.3, figure 8)
  kSpaced,     // as far apart as the triangles there will be large
};

// How open holes become closed ones along grid lines.
enum class Closure {
  kBuffers,  // with buffer zones on both sides of the line (Wang 2021, 3.3, figure 7)
  kLine,     // along the line alone
};

// What Wang 2021 leaves open.
struct WangOptions {
  double seam_smoothing = 0.5;  // [0, 1]: gamma of eq. 5
  double seam_buffer = 3;       // [1, 100]: how far eq. 5 and 6 reach on either side of a seam, in edges of the seam
  int32_t longest_loop = 400;   // [3, 2000]: boundary vertices; longer loops are cut before they are triangulated
  int32_t fairing_steps = 10;   // [0, 1000]: of the fairing by eq. 4
  bool adjust = true;           // eq. 1; false: for tests alone
  SeamPoints seam_points = SeamPoints::kProjected;
  Closure closure = Closure::kBuffers;
};

inline constexpr int32_t kShortestLongestLoop = 3, kLongestLongestLoop = 2000;
inline constexpr int32_t kMostFairingSteps = 1000;

// "projected" or "spaced", as flags, jobs and reports say it.
constexpr const char* SeamPointsName(SeamPoints points) {
  return points == SeamPoints::kProjected ? "projected" : "spaced";
}

// Those of that name; nothing for any other text.
constexpr std::optional<SeamPoints> SeamPointsNamed(std::string_view name) {
  for (const SeamPoints points : {SeamPoints::kProjected, SeamPoints::kSpaced}) {
    if (name == SeamPointsName(points)) return points;
  }
  return std::nullopt;
}

// "buffers" or "line", as flags, jobs and reports say it.
constexpr const char* ClosureName(Closure closure) { return closure == Closure::kBuffers ? "buffers" : "line"; }

// That of that name; nothing for any other text.
constexpr std::optional<Closure> ClosureNamed(std::string_view name) {
  for (const Closure closure : {Closure::kBuffers, Closure::kLine}) {
    if (name == ClosureName(closure)) return closure;
  }
  return std::nullopt;
}

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
