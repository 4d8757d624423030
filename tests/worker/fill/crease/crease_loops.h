// The loops of a hole as creases are sought in them.
#ifndef TILEMEND_TESTS_WORKER_FILL_CREASE_CREASE_LOOPS_H_
#define TILEMEND_TESTS_WORKER_FILL_CREASE_CREASE_LOOPS_H_

#include <vector>

#include "common/records/cell_holes.h"
#include "worker/fill/hole/local_hole.h"

namespace tilemend {

inline std::vector<RimLoop> LoopsOf(const CellHoles& work) {
  return MakeLocalHole(work, CellBand(work), work.holes[0]).loops;
}

}  // namespace tilemend

#endif  // TILEMEND_TESTS_WORKER_FILL_CREASE_CREASE_LOOPS_H_
