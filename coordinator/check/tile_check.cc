#include "coordinator/check/tile_check.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "common/mesh/position_index.h"
#include "coordinator/check/mesh_outline.h"

namespace tilemend {
namespace {

absl::Status WrongTile(const char* what) { return absl::InvalidArgumentError(what); }

absl::Status CheckSummary(const SurveyRecord& record, const TriMesh& tile, bool float32) {
  if (record.vertex_count != static_cast<int64_t>(tile.points.size()) ||
      record.triangle_count != static_cast<int64_t>(tile.triangles.size())) {
    return WrongTile("counts that are not the tile's");
  }
  if (record.float32 != float32) return WrongTile("a number type that is not the tile's");
  Point3 lo = Point3::Constant(std::numeric_limits<double>::infinity()), hi = -lo;
  for (const Point3& p : tile.points) {
    lo = lo.cwiseMin(p);
    hi = hi.cwiseMax(p);
  }
  return lo == record.lo && hi == record.hi ? absl::OkStatus() : WrongTile("bounds that are not the tile's");
}

absl::Status CheckVertices(const SurveyRecord& record, const TriMesh& tile) {
  PositionIndex positions;
  std::vector<int32_t> lowest;
  for (const BoundaryVertex& v : record.vertices) {
    positions.Insert(v.position);
    if (static_cast<size_t>(positions.size()) == lowest.size())
      return WrongTile("two boundary vertices at one position");
    lowest.push_back(-1);
  }
  for (size_t v = 0; v < tile.points.size(); ++v) {
    const int32_t position = positions.Find(tile.points[v]);
    if (position >= 0 && lowest[position] < 0) lowest[position] = static_cast<int32_t>(v);
  }
  const bool same = std::equal(record.vertices.begin(), record.vertices.end(), lowest.begin(),
                               [](const BoundaryVertex& v, int32_t index) { return v.index == index; });
  return same ? absl::OkStatus() : WrongTile("boundary vertices that are not the tile's");
}

bool HasOutline(const SurveyRecord& record, const TriMesh& tile, uint64_t key) {
  const OutlineSum of_tile = OutlineSumOf(tile, key);
  uint64_t told = 0;
  for (const BoundaryEdge& e : record.edges) {
    told ^= OutlineSumOfEdge(record.vertices[e.from].position, record.vertices[e.to].position, key);
  }
  if (told == of_tile.sum || of_tile.flat_triangles > 0) return true;
  std::vector<OutlineEdge> edges;
  for (const BoundaryEdge& e : record.edges) {
    edges.emplace_back(std::minmax(record.vertices[e.from].index, record.vertices[e.to].index));
  }
  std::sort(edges.begin(), edges.end());
  return edges == OutlineOf(tile);
}

}  // namespace

absl::Status CheckAgainstTile(const SurveyRecord& record, const TriMesh& tile, bool float32, uint64_t key) {
  absl::Status status = CheckSummary(record, tile, float32);
  if (status.ok()) status = CheckVertices(record, tile);
  if (!status.ok()) return status;
  return HasOutline(record, tile, key) ? absl::OkStatus() : WrongTile("a boundary that is not the tile's");
}

}  // namespace tilemend
