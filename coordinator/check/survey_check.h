// Whether a survey record can be that of a tile.
#ifndef TILEMEND_COORDINATOR_CHECK_SURVEY_CHECK_H_
#define TILEMEND_COORDINATOR_CHECK_SURVEY_CHECK_H_

#include <cstdint>
#include <string_view>

#include "absl/status/status.h"
#include "common/records/survey_record.h"

namespace tilemend {

// kInvalidArgument, saying what is wrong first, unless the record agrees with itself and with its file:
//  - the tile has at most `most` vertices and at most `most` triangles (MostOf); other counts are no larger;
//  - boundary vertices are vertices of the tile within its bounds, each once, each at an edge; pieces are numbered as
//    they appear;
//  - boundary edges are there once, and each is in one triangle of the band, in its direction; an edge between boundary
//    vertices that one triangle of the band has is a boundary edge;
//  - without edges that have three triangles, an even number of boundary edges meets at each vertex.
// So no edge of the boundary can be left out or made up alone. A whole loop can, together with its band. O(n log n).
absl::Status CheckSurvey(const SurveyRecord& record, int64_t most);

// How many vertices, and how many triangles, the tile at `path` of `file_bytes` can have: one a byte in PLY and OBJ. A
// tree of files (OSGB, 3D Tiles) may have any number: it may be compressed, and nodes may share a mesh.
int64_t MostOf(std::string_view path, int64_t file_bytes);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_CHECK_SURVEY_CHECK_H_
