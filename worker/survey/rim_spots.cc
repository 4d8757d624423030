#include "worker/survey/rim_spots.h"

#include <unordered_set>
#include <utility>

#include "common/mesh/edge_key.h"
#include "common/mesh/position_index.h"

namespace tilemend {
namespace {

// For each vertex of the mesh, the boundary vertex at its position, or -1.
std::vector<int32_t> BoundaryVertices(const TriMesh& mesh, const SurveyRecord& record) {
  PositionIndex index;
  for (const BoundaryVertex& v : record.vertices) index.Insert(v.position);  // all different, so in their order
  std::vector<int32_t> boundary;
  boundary.reserve(mesh.points.size());
  for (const Point3& p : mesh.points) boundary.push_back(index.Find(p));
  return boundary;
}

}  // namespace

std::vector<RimSpot> RimSpots(const TriMesh& mesh, const SurveyRecord& record) {
  constexpr double kAtEdge = 0.45, kInside = 0.1;
  const std::vector<int32_t> boundary = BoundaryVertices(mesh, record);
  std::unordered_set<uint64_t> edges;
  for (const BoundaryEdge& e : record.edges) edges.insert(EdgeKey(e.from, e.to));
  std::vector<uint8_t> done(record.vertices.size(), 0);
  std::vector<RimSpot> spots;
  for (size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      int32_t from = boundary[mesh.triangles[t][k]], to = boundary[mesh.triangles[t][(k + 1) % 3]];
      if (record.turned_triangles > 0 && from >= 0 && to >= 0 && edges.contains(EdgeKey(to, from))) std::swap(from, to);
      if (from < 0 || to < 0 || done[from] || !edges.contains(EdgeKey(from, to))) continue;
      done[from] = 1;
      RimSpot spot{from, static_cast<int32_t>(t), {kAtEdge, kAtEdge, kAtEdge}};
      spot.weights[(k + 2) % 3] = kInside;
      spots.push_back(spot);
    }
  }
  return spots;
}

}  // namespace tilemend
