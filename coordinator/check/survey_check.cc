#include "coordinator/check/survey_check.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <vector>

#include "common/util/tile_files.h"

namespace tilemend {
namespace {

// Of band points, which are rounded to a lattice of at most this step and a place in 2^28 of their largest extent.
constexpr double kRounding = 1e-2;  // metres
constexpr double kRoundingShare = 0x1p-27;

absl::Status Wrong(const char* what) { return absl::InvalidArgumentError(what); }

absl::Status CheckCounts(const SurveyRecord& record, int64_t most) {
  const auto fits = [](int64_t count, int64_t end) { return count >= 0 && count <= end; };
  const bool ok = fits(record.vertex_count, most) && fits(record.triangle_count, most) &&
                  fits(record.doubled_vertices, record.vertex_count) &&
                  fits(record.degenerate_triangles, record.triangle_count) &&
                  fits(record.nonmanifold_edges, record.triangle_count) &&
                  fits(static_cast<int64_t>(record.vertices.size()), record.vertex_count) &&
                  fits(static_cast<int64_t>(record.band.points.size()), record.vertex_count) &&
                  fits(static_cast<int64_t>(record.band.triangles.size()), record.triangle_count);
  if (!ok) return Wrong("counts that do not fit each other or the file");
  const bool has_bounds =
      record.lo.allFinite() && record.hi.allFinite() && (record.lo.array() <= record.hi.array()).all();
  return has_bounds == (record.vertex_count > 0) ? absl::OkStatus() : Wrong("bounds that are none");
}

absl::Status CheckVertices(const SurveyRecord& record) {
  std::vector<int32_t> indices;
  for (const BoundaryVertex& v : record.vertices) {
    indices.push_back(v.index);
    const bool inside =
        (v.position.array() >= record.lo.array()).all() && (v.position.array() <= record.hi.array()).all();
    const bool near = v.centroid_height >= record.lo.z() - kRounding && v.centroid_height <= record.hi.z() + kRounding;
    if (!inside || !near) return Wrong("a boundary vertex outside the bounds of the tile");
    if (!v.normal.allFinite() || v.normal.norm() > 1 + 1e-3) return Wrong("a normal that is none");
  }
  std::sort(indices.begin(), indices.end());
  const bool once = std::adjacent_find(indices.begin(), indices.end()) == indices.end();
  return once ? absl::OkStatus() : Wrong("a boundary vertex twice");
}

absl::Status CheckPieces(const SurveyRecord& record) {
  int32_t pieces = 0;
  for (const BoundaryEdge& e : record.edges) {
    if (e.piece < 0 || e.piece > pieces) return Wrong("pieces that are not numbered as they appear");
    pieces = std::max(pieces, e.piece + 1);
  }
  return absl::OkStatus();
}

uint64_t EdgeKey(int32_t from, int32_t to) {
  return static_cast<uint64_t>(static_cast<uint32_t>(from)) << 32 | static_cast<uint32_t>(to);
}

// Edges between boundary vertices, directed as triangles of the band have them, sorted.
struct BandEdges {
  std::vector<uint64_t> single;   // in exactly one triangle: the boundary has them all
  std::vector<uint64_t> doubled;  // in two that have them the same way, each once: it may have them twice
};

BandEdges EdgesOfBand(const SurveyRecord& record) {
  struct Use {
    uint64_t edge;  // the lower end first
    bool back;
    bool operator<(const Use& other) const { return edge < other.edge; }
  };
  const auto n = static_cast<int32_t>(record.vertices.size());
  std::vector<Use> uses;
  for (const Triangle& t : record.band.triangles) {
    for (int k = 0; k < 3; ++k) {
      const int32_t from = t[k], to = t[(k + 1) % 3];
      if (from < n && to < n) uses.push_back({EdgeKey(std::min(from, to), std::max(from, to)), from > to});
    }
  }
  std::sort(uses.begin(), uses.end());
  BandEdges edges;
  for (size_t i = 0, j = 0; i < uses.size(); i = j) {
    int64_t back = 0;
    for (; j < uses.size() && uses[j].edge == uses[i].edge; ++j) back += uses[j].back ? 1 : -1;
    const uint64_t edge = back > 0 ? uses[i].edge << 32 | uses[i].edge >> 32 : uses[i].edge;
    if (j - i == 1) edges.single.push_back(edge);
    if (j - i == 2 && back != 0) edges.doubled.push_back(edge);
  }
  std::sort(edges.single.begin(), edges.single.end());
  std::sort(edges.doubled.begin(), edges.doubled.end());
  return edges;
}

absl::Status CheckEdges(const SurveyRecord& record) {
  std::vector<uint64_t> edges;
  std::vector<int32_t> degree(record.vertices.size(), 0);
  for (const BoundaryEdge& e : record.edges) {
    edges.push_back(EdgeKey(e.from, e.to));
    ++degree[e.from];
    ++degree[e.to];
  }
  std::sort(edges.begin(), edges.end());
  const BandEdges of_band = EdgesOfBand(record);
  std::vector<uint64_t> more, twice;
  std::ranges::set_difference(edges, of_band.single, std::back_inserter(more));
  for (size_t i = 0; i + 1 < more.size() && more[i] == more[i + 1]; i += 2) twice.push_back(more[i]);
  const bool has_single = more.size() + of_band.single.size() == edges.size();
  const bool is_once = std::ranges::adjacent_find(twice) == twice.end();
  if (!has_single || 2 * twice.size() != more.size() || !is_once || !std::ranges::includes(of_band.doubled, twice)) {
    return Wrong("boundary edges that are not those of the band");
  }
  if (std::count(degree.begin(), degree.end(), 0) > 0) return Wrong("a boundary vertex without an edge");
  const bool even = std::all_of(degree.begin(), degree.end(), [](int32_t d) { return d % 2 == 0; });
  return even || record.nonmanifold_edges > 0 ? absl::OkStatus() : Wrong("a boundary that ends");
}

absl::Status CheckBand(const SurveyRecord& record) {
  const Point3 slack = Point3::Constant(kRounding + kRoundingShare * (record.hi - record.lo).maxCoeff());
  for (const Point3& p : record.band.points) {
    const bool inside =
        (p.array() >= (record.lo - slack).array()).all() && (p.array() <= (record.hi + slack).array()).all();
    if (!inside) return Wrong("a vertex of the band outside the bounds of the tile");
  }
  return absl::OkStatus();
}

}  // namespace

absl::Status CheckSurvey(const SurveyRecord& record, int64_t most) {
  absl::Status status = CheckCounts(record, most);
  if (status.ok()) status = CheckVertices(record);
  if (status.ok()) status = CheckPieces(record);
  if (status.ok()) status = CheckEdges(record);
  return status.ok() ? CheckBand(record) : status;
}

int64_t MostOf(std::string_view path, int64_t file_bytes) {
  constexpr int64_t kMostNumbered = std::numeric_limits<int32_t>::max() / 2;
  return IsTileTree(path) ? kMostNumbered : std::min(file_bytes, kMostNumbered);
}

}  // namespace tilemend
