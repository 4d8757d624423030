#include "worker/fill/crease/part_fill.h"

#include "worker/fill/hole/facing.h"
#include "worker/fill/plane/plane_fill.h"
#include "worker/fill/space/unrolled_fill.h"

namespace tilemend {

LocalPatch FillPart(const LocalHole& part, const FillOptions& options) {
  if (!IsSteep(part)) {
    LocalPatch patch = FillOverFacingPlane(part, options);
    if (patch.ok()) return patch;
  }
  return FillUnrolled(part, options);
}

}  // namespace tilemend
