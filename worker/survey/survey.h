// Survey of one tile: its boundary edges and the band of triangles around them.
#ifndef TILEMEND_WORKER_SURVEY_SURVEY_H_
#define TILEMEND_WORKER_SURVEY_SURVEY_H_

#include "common/mesh/mesh_view.h"
#include "common/records/survey_record.h"

namespace tilemend {

// Whether SurveyRecord::piece_areas, edge_after and repeated_edges are wanted. The first takes one more look at every
// triangle, the others the cost of a sort for a mesh without boundary. With kYes faces that disagree about the front
// are surveyed as if they were turned (turned_triangles). With kNo, as tiles are surveyed, edges may be double
// (welded_edges.h).
enum class PieceAreas { kYes, kNo };

// Finds the boundary edges of `mesh` on welded positions: edges that exactly one triangle with area has. Texture seams,
// which double vertices, are no boundary. Where copies of triangles lie on the boundary, the mesh is surveyed as if it
// had each triangle once (copied_triangles).
//
// Source: Wang 2021, 3.1, without a half-edge structure of the whole tile. One pass over the triangles shows which
// vertices are inside: their outgoing and incoming edges cancel. Only the others are looked at. Cost: linear in
// vertices and triangles, three passes. Pure; safe from any thread.
SurveyRecord SurveyTile(const MeshView& mesh, bool float32, PieceAreas areas = PieceAreas::kYes);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_SURVEY_SURVEY_H_
