#include "worker/papers/published_ways.h"

#include "worker/fill/hole/fill_options.h"
#include "worker/fill/hole/local_hole.h"
#include "worker/papers/front/front_fill.h"
#include "worker/papers/wang/least_area_fill.h"
#include "worker/papers/wang/wang_fill.h"

namespace tilemend {
namespace {

LocalPatch FillByName(const LocalHole& hole, const FillOptions& options, const SurroundingTriangles& surface) {
  if (options.filler != Filler::kMinimumArea) return FillWithFront(hole, options, surface);
  LocalHole free = hole;
  FreeAtFolds(free);
  return FillLeastArea(free, options);
}

}  // namespace

const PublishedWays* AllPublishedWays() {
  static constexpr PublishedWays kWays = {FillAsWang, ShapeAsWang, FillByName};
  return &kWays;
}

}  // namespace tilemend
