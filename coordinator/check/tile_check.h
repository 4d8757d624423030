// Whether a survey record is that of a tile.
#ifndef TILEMEND_COORDINATOR_CHECK_TILE_CHECK_H_
#define TILEMEND_COORDINATOR_CHECK_TILE_CHECK_H_

#include <cstdint>

#include "absl/status/status.h"
#include "common/mesh/tri_mesh.h"
#include "common/records/survey_record.h"

namespace tilemend {

// kInvalidArgument, saying what is wrong first, unless
//  - the record has the tile's counts of vertices and triangles, its number type and its bounds;
//  - boundary vertices are the lowest vertices of the tile at their positions;
//  - boundary edges are the edges of the tile that one triangle has, all of them. (Not told of a tile with triangles
//    that have two corners at one position: what their edges are is the survey's choice.)
// `key` is a random number that no worker knows. Precondition: CheckSurvey. Linear; a tile whose edges have three
// triangles, or a record that is wrong, takes O(n log n).
absl::Status CheckAgainstTile(const SurveyRecord& record, const TriMesh& tile, bool float32, uint64_t key);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_CHECK_TILE_CHECK_H_
