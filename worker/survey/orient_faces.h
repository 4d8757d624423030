// Faces that are turned the other way than those beside them.
#ifndef TILEMEND_WORKER_SURVEY_ORIENT_FACES_H_
#define TILEMEND_WORKER_SURVEY_ORIENT_FACES_H_

#include <cstdint>
#include <vector>

#include "common/mesh/mesh_view.h"

namespace tilemend {

// Turns faces so that each piece of surface has one front: that of most of its faces. Faces are of one piece where
// exactly two share an edge, on welded positions. A piece that has one side only, as a Moebius strip, stays as it is.
// Returns the number of turned faces. Cost: O(n log n) in faces.
int64_t OrientFaces(const PointRows& points, std::vector<Triangle>& faces);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_SURVEY_ORIENT_FACES_H_
