// Fills one smooth part of a hole.
#ifndef TILEMEND_WORKER_FILL_CREASE_PART_FILL_H_
#define TILEMEND_WORKER_FILL_CREASE_PART_FILL_H_

#include "worker/fill/hole/fill_options.h"
#include "worker/fill/hole/local_patch.h"

namespace tilemend {

// Over a plane (plane_fill.h) if the surface around the part is not too steep for that, else unrolled
// (unrolled_fill.h). The slope goes on from the surface beside the rim, but not across creases. Not applicable if
// neither can be done.
LocalPatch FillPart(const LocalHole& part, const FillOptions& options);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_CREASE_PART_FILL_H_
