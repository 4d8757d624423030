#include "coordinator/plan/rim/rim_sizes.h"

#include <algorithm>

namespace tilemend {
namespace {

// Rounding a height by half a step tilts a triangle of this many steps by less than half a degree.
constexpr double kLeastSizeInSteps = 64;
// Of the length of an edge: the least size at its ends. A mean of two edges is below it if one is five times the other.
constexpr double kShareOfLongEdge = 0.6;

// The least size at the end of an edge, by that at its beginning.
double LeastSizeBehind(const Rim& rim, const RimEdge& e, double before) {
  const double length = LengthOf(rim, e);
  return std::max(kShareOfLongEdge * length, before - length);
}

}  // namespace

void RaiseSmallSizes(double lattice_step, Rim& rim) {
  double sum = 0;
  int64_t count = 0;
  for (const RimPoint& p : rim.points) {
    sum += p.size;
    if (p.size > 0) ++count;
  }
  if (count == 0) return;
  const double least = std::min(kLeastSizeInSteps * lattice_step, sum / static_cast<double>(count) / 2);
  for (RimPoint& p : rim.points) p.size = std::max(p.size, least);
}

void RaiseSizesAtShortEdges(Rim& rim) {
  for (const std::vector<int32_t>& loop : rim.loops) {
    const size_t n = loop.size();
    // Twice around, so that the first edges know the last ones; then the other way.
    double least = 0;
    for (size_t i = 0; i < 2 * n; ++i) {
      const RimEdge& e = rim.edges[loop[i % n]];
      least = LeastSizeBehind(rim, e, least);
      rim.points[e.to].size = std::max(rim.points[e.to].size, least);
    }
    least = 0;
    for (size_t i = 2 * n; i-- > 0;) {
      const RimEdge& e = rim.edges[loop[i % n]];
      least = LeastSizeBehind(rim, e, least);
      rim.points[e.from].size = std::max(rim.points[e.from].size, least);
    }
  }
}

}  // namespace tilemend
