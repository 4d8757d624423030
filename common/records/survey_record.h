// What the survey of one tile tells: everything that planning and filling need to know of it.
#ifndef TILEMEND_COMMON_RECORDS_SURVEY_RECORD_H_
#define TILEMEND_COMMON_RECORDS_SURVEY_RECORD_H_

#include <cstdint>
#include <optional>
#include <vector>

#include "common/mesh/tri_mesh.h"
#include "common/records/ground_raster.h"
#include "common/util/colour.h"

namespace tilemend {

// A vertex of a boundary edge. Vertices of the tile at one position are one boundary vertex (texture seams double
// them).
struct BoundaryVertex {
  int32_t index = 0;  // in the tile: the lowest at this position
  Point3 position{0, 0, 0};
  Eigen::Vector3d normal{0, 0,
                         1};   // unit, area-weighted mean of the triangles at the vertex; zero if they have no area
  double centroid_height = 0;  // mean height of the centroids of the triangles at the vertex (Wang 3.3, figure 8b)
};

// A boundary edge, directed as its triangle is: surface on the left, hole (or outside) on the right.
struct BoundaryEdge {
  int32_t from = 0;  // into SurveyRecord::vertices
  int32_t to = 0;
  int32_t piece = 0;  // of surface that hangs together by its edges: those at the boundary, from 0
};

// What of a record stays in memory when the rest does not.
struct SurveySummary {
  int64_t vertex_count = 0;
  int64_t triangle_count = 0;
  int64_t doubled_vertices = 0;      // near the boundary: further vertices at one position
  int64_t degenerate_triangles = 0;  // two corners at one position
  int64_t nonmanifold_edges = 0;     // with three or more triangles
  bool float32 = true;               // the tile's number type
  Point3 lo{0, 0, 0}, hi{0, 0, 0};   // bounds; lo > hi in x when there is no vertex
};

// The record of one tile. Size is linear in the tile's boundary, not in the tile.
struct SurveyRecord : SurveySummary {
  std::vector<BoundaryVertex> vertices;
  std::vector<BoundaryEdge> edges;

  // The area of each piece of surface that has boundary edges, by BoundaryEdge::piece. Not sent: single meshes alone
  // are told by it.
  std::vector<double> piece_areas;

  // For each edge the one that leaves its end around the same fan of triangles; -1: none alone does. Not sent, as
  // above.
  std::vector<int32_t> edge_after;

  // The triangles within two rings of the boundary. The first vertices.size() points are the boundary vertices, in
  // order.
  TriMesh band;

  // The triangles of a mesh that has each more than once, but for the first of each: it was surveyed without them. Not
  // sent, as above.
  int64_t copied_triangles = 0;

  // Edges that would be boundary if each of several triangles with the same corners, such as a face and its back, were
  // there once. Not sent, as above.
  int64_t repeated_edges = 0;

  // Faces of a mesh that are turned the other way than most around them: it was surveyed as if they were not. Not sent,
  // as above.
  int64_t turned_triangles = 0;

  // Edges of two faces that are turned opposite ways, at which no turning of faces helps. Not sent, as above.
  int64_t disagreeing_edges = 0;

  // What the surface looks like at the boundary vertices; empty: the tile has no colours.
  std::vector<std::optional<Rgb>> colours;

  // The lowest surface (worker/ground/lowest_surface.h), where it was asked for. Sent, but not decoded by FromProto and
  // not stored: the coordinator passes it on as it comes.
  GroundRaster lowest;
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_RECORDS_SURVEY_RECORD_H_
