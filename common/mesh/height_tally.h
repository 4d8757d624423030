// How much surface lies at which height inside a polygon, and the height at which it gathers.
#ifndef TILEMEND_COMMON_MESH_HEIGHT_TALLY_H_
#define TILEMEND_COMMON_MESH_HEIGHT_TALLY_H_

#include <cstdint>
#include <map>
#include <optional>

#include "common/mesh/mesh_view.h"
#include "common/mesh/plane_polygon.h"

namespace tilemend {

inline constexpr double kHeightBin = 0x1p-10;  // metres: heights of new vertices are multiples of it

// A sparse histogram: plan area in units of kAreaUnit by height in bins; bin k has the heights that are nearest to k *
// kHeightBin. Whole numbers, so that sums do not depend on their order.
struct HeightTally {
  std::map<int32_t, int64_t> area_of_bin;

  void Add(const HeightTally& other);
};

inline constexpr double kAreaUnit = 1e-6;  // m2

// The bin of a height in metres. Beyond 2,000 km, which no surface is, it is the last one.
int32_t HeightBinOf(double height);

// The triangles with their centroid in the polygon, each with its area seen from above at the height of its centroid.
// Cost as AreasThatClear.
HeightTally TallyHeights(const MeshView& mesh, const PlanePolygon& polygon);

// The half-sample mode (Bickel and Fruehwirth 2006, "On a fast, robust estimator of the mode"), weighted by area. It
// takes the shortest interval that holds half of the area, and of that again, until it is at most 3 cm long. The result
// is the weighted mean of the last one, or nullopt for an empty tally. Level surface keeps its height. Deterministic.
// Cost O(bins log bins).
std::optional<double> HalfSampleMode(const HeightTally& tally);

// The lower half of the area, bin by bin.
HeightTally LowerHalf(const HeightTally& tally);

// How far the heights up to `top` scatter about a level, in metres (whole bins). It is 1.4826 times the distance that
// half of their area lies within: the standard deviation of normal heights. Where no height is up to there it is 0.
// Cost O(bins log bins).
double SpreadAbout(const HeightTally& tally, double level, double top);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_MESH_HEIGHT_TALLY_H_
