#include "worker/survey/survey.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <utility>

#include "common/mesh/disjoint_sets.h"
#include "common/mesh/position_index.h"
#include "common/mesh/triangle_copies.h"
#include "common/mesh/triangle_shape.h"
#include "worker/survey/orient_faces.h"
#include "worker/survey/welded_edges.h"

namespace tilemend {
namespace {

constexpr int32_t kNone = -1;

// A mesh in the types of a TriMesh. Passes over all of it take `const auto& mesh`: a MeshView asks for its types at
// each row, which would make the survey of a tile 5 to 10 % slower.
struct PlainMesh {
  std::span<const Point3> points;
  std::span<const Triangle> triangles;
  operator MeshView() const { return {PointRows(points), TriangleRows(triangles)}; }  // NOLINT: as a span
};

uint64_t Mix(uint64_t x) {  // splitmix64's finaliser: a bijection
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

// Marks the vertices at which outgoing and incoming edges do not cancel. Every end of an edge that is not in exactly
// one triangle each way is marked: a vertex with one unmatched edge cannot cancel, as Mix is a bijection, and one with
// several cancels with probability 2^-64.
std::vector<uint8_t> MarkUnbalancedVertices(const auto& mesh) {
  struct Vertex {
    uint64_t key, balance;
  };
  std::vector<Vertex> vertices(mesh.points.size());
  for (size_t v = 0; v < vertices.size(); ++v) vertices[v] = {Mix(v + 1), 0};
  for (const Triangle& t : mesh.triangles) {
    Vertex &a = vertices[t[0]], &b = vertices[t[1]], &c = vertices[t[2]];
    a.balance += b.key - c.key;
    b.balance += c.key - a.key;
    c.balance += a.key - b.key;
  }
  std::vector<uint8_t> marked(vertices.size());
  for (size_t v = 0; v < marked.size(); ++v) marked[v] = vertices[v].balance != 0;
  return marked;
}

// The marked vertices welded by position. weld[v] is a number from 0 for each position that a marked vertex has, for
// every vertex there (marked or not), else kNone.
struct Weld {
  std::vector<int32_t> weld;
  std::vector<int32_t> first;  // lowest vertex of each position
  int64_t doubled = 0;
};

// Tells of most positions at once that they are not among those that were added.
class PositionFilter {
 public:
  void Add(const Point3& p) { has_[PlaceOf(p)] = 1; }
  bool MayHave(const Point3& p) const { return has_[PlaceOf(p)] != 0; }

 private:
  static constexpr int kBits = 17;  // a byte each: together they fit into a processor's own cache

  static size_t PlaceOf(const Point3& p) {  // + 0.0 turns -0.0 into 0.0
    const uint64_t x = std::bit_cast<uint64_t>(p.x() + 0.0), y = std::bit_cast<uint64_t>(p.y() + 0.0);
    return (x * 0x9e3779b97f4a7c15ULL ^ y * 0xbf58476d1ce4e5b9ULL) >> (64 - kBits);
  }

  std::vector<uint8_t> has_ = std::vector<uint8_t>(size_t{1} << kBits, 0);
};

Weld WeldMarked(const auto& mesh, const std::vector<uint8_t>& marked) {
  Weld result;
  result.weld.assign(mesh.points.size(), kNone);
  PositionIndex index;
  PositionFilter filter;
  for (size_t v = 0; v < marked.size(); ++v) {
    if (!marked[v]) continue;
    index.Insert(mesh.points[v]);
    filter.Add(mesh.points[v]);
  }
  result.first.assign(index.size(), kNone);
  for (size_t v = 0; v < marked.size(); ++v) {
    if (!filter.MayHave(mesh.points[v])) continue;
    const int32_t id = index.Find(mesh.points[v]);
    if (id == kNone) continue;
    result.weld[v] = id;
    if (result.first[id] == kNone) {
      result.first[id] = static_cast<int32_t>(v);
    } else {
      ++result.doubled;
    }
  }
  return result;
}

// The triangles with a welded corner.
std::vector<int32_t> TrianglesAtWelds(const auto& mesh, const std::vector<int32_t>& weld) {
  std::vector<int32_t> at_weld;
  int32_t i = 0;
  for (const Triangle& t : mesh.triangles) {
    // kNone is all ones: one comparison for the three.
    if ((weld[t[0]] & weld[t[1]] & weld[t[2]]) != kNone) at_weld.push_back(i);
    ++i;
  }
  return at_weld;
}

// Numbers the ends of the edges in order of appearance and stores them as the record's boundary. Returns, for each
// vertex of the mesh, its boundary vertex or kNone.
std::vector<int32_t> StoreBoundary(const MeshView& mesh, const Weld& weld, const std::vector<HalfEdge>& edges,
                                   SurveyRecord& record) {
  std::vector<int32_t> number(weld.first.size(), kNone);
  const auto vertex = [&](int32_t w) {
    if (number[w] == kNone) {
      number[w] = static_cast<int32_t>(record.vertices.size());
      BoundaryVertex v;
      v.index = weld.first[w];
      v.position = mesh.points[v.index];
      record.vertices.push_back(v);
    }
    return number[w];
  };
  record.edges.reserve(edges.size());
  for (const HalfEdge& e : edges) {
    const int32_t from = vertex(e.from);
    const int32_t to = vertex(e.to);
    record.edges.push_back({from, to});
  }
  std::vector<int32_t> boundary(mesh.points.size(), kNone);
  for (size_t v = 0; v < boundary.size(); ++v) {
    if (weld.weld[v] != kNone) boundary[v] = number[weld.weld[v]];
  }
  return boundary;
}

// Of the triangles at one welded vertex: the fan that each is in. Those of a fan share edges at the vertex.
std::map<int32_t, int32_t> FansAt(const MeshView& mesh, const Weld& weld, int32_t vertex,
                                  const std::vector<int32_t>& triangles) {
  DisjointSets sets(static_cast<int32_t>(triangles.size()));
  std::map<std::pair<bool, int32_t>, int32_t> last_with;  // by the edge's other end: welded or not
  for (size_t i = 0; i < triangles.size(); ++i) {
    for (const int32_t v : mesh.triangles[triangles[i]]) {
      const int32_t w = weld.weld[v];
      if (w == vertex) continue;
      const auto [it, fresh] = last_with.try_emplace({w != kNone, w != kNone ? w : v}, static_cast<int32_t>(i));
      if (!fresh) sets.Join(it->second, static_cast<int32_t>(i));
    }
  }
  const std::vector<int32_t> groups = sets.Groups();
  std::map<int32_t, int32_t> fan_of;
  for (size_t i = 0; i < triangles.size(); ++i) fan_of[triangles[i]] = groups[i];
  return fan_of;
}

// For the boundary edges that end where several do: which leaves that vertex around the same fan.
void StoreEdgesAfter(const MeshView& mesh, const Weld& weld, const std::vector<int32_t>& at_weld,
                     const std::vector<HalfEdge>& edges, SurveyRecord& record) {
  struct Vertex {
    std::vector<int32_t> arriving, leaving, triangles;
  };
  record.edge_after.assign(edges.size(), kNone);
  std::vector<int32_t> leaving(weld.first.size(), 0);
  for (const HalfEdge& e : edges) ++leaving[e.from];
  std::map<int32_t, Vertex> shared;
  for (size_t e = 0; e < edges.size(); ++e) {
    if (leaving[edges[e].from] > 1) shared[edges[e].from].leaving.push_back(static_cast<int32_t>(e));
    if (leaving[edges[e].to] > 1) shared[edges[e].to].arriving.push_back(static_cast<int32_t>(e));
  }
  if (shared.empty()) return;
  for (const int32_t t : at_weld) {
    for (const int32_t v : mesh.triangles[t]) {
      const auto at = shared.find(weld.weld[v]);
      if (at != shared.end()) at->second.triangles.push_back(t);
    }
  }
  for (const auto& [w, vertex] : shared) {
    const std::map<int32_t, int32_t> fan_of = FansAt(mesh, weld, w, vertex.triangles);
    std::map<int32_t, std::pair<std::vector<int32_t>, std::vector<int32_t>>> fans;
    for (const int32_t e : vertex.arriving) fans[fan_of.at(edges[e].triangle)].first.push_back(e);
    for (const int32_t e : vertex.leaving) fans[fan_of.at(edges[e].triangle)].second.push_back(e);
    for (const auto& [fan, ends] : fans) {
      if (ends.first.size() == 1 && ends.second.size() == 1) record.edge_after[ends.first[0]] = ends.second[0];
    }
  }
}

// The triangles at the boundary vertices and one more ring.
void StoreBand(const auto& mesh, const std::vector<int32_t>& boundary, const std::vector<int32_t>& at_weld,
               SurveyRecord& record) {
  std::vector<uint8_t> near(mesh.points.size(), 0);
  const auto at_boundary = [&](const Triangle& t) {
    return boundary[t[0]] != kNone || boundary[t[1]] != kNone || boundary[t[2]] != kNone;
  };
  for (const int32_t i : at_weld) {
    const Triangle& t = mesh.triangles[i];
    if (at_boundary(t)) near[t[0]] = near[t[1]] = near[t[2]] = 1;
  }
  for (const BoundaryVertex& v : record.vertices) record.band.points.push_back(v.position);
  std::vector<int32_t> number = boundary;
  for (const Triangle& t : mesh.triangles) {
    if (!(near[t[0]] | near[t[1]] | near[t[2]])) continue;
    Triangle out;
    for (int k = 0; k < 3; ++k) {
      int32_t& n = number[t[k]];
      if (n == kNone) {
        n = static_cast<int32_t>(record.band.points.size());
        record.band.points.push_back(mesh.points[t[k]]);
      }
      out[k] = n;
    }
    if (out[0] != out[1] && out[1] != out[2] && out[0] != out[2]) record.band.triangles.push_back(out);
  }
}

// Normals and centroid heights of the boundary vertices, from the band.
void StoreVertexFigures(SurveyRecord& record) {
  std::vector<int32_t> count(record.vertices.size(), 0);
  for (BoundaryVertex& v : record.vertices) v.normal.setZero();
  const auto& points = record.band.points;
  for (const Triangle& t : record.band.triangles) {
    const Eigen::Vector3d normal = TwiceVectorArea(points, t);
    const double height = (points[t[0]].z() + points[t[1]].z() + points[t[2]].z()) / 3;
    for (const int32_t corner : t) {
      if (corner >= static_cast<int32_t>(record.vertices.size())) continue;
      record.vertices[corner].normal += normal;
      record.vertices[corner].centroid_height += height;
      ++count[corner];
    }
  }
  for (size_t i = 0; i < count.size(); ++i) {
    BoundaryVertex& v = record.vertices[i];
    const double length = v.normal.norm();
    v.normal = length > 0 ? Eigen::Vector3d(v.normal / length) : Eigen::Vector3d::Zero();
    v.centroid_height = count[i] > 0 ? v.centroid_height / count[i] : v.position.z();
  }
}

// Calls `use` with each triangle and the thing that stands for it among the joined ones: a vertex without weld, or a
// number of its own from `vertices` on for each of `at_weld`.
void ForThings(const auto& mesh, const std::vector<int32_t>& at_weld, const auto& use) {
  size_t next = 0;
  const auto vertices = static_cast<int32_t>(mesh.points.size());
  for (size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle& t = mesh.triangles[i];
    const bool welded = next < at_weld.size() && at_weld[next] == static_cast<int32_t>(i);
    use(t, welded ? vertices + static_cast<int32_t>(next++) : t[0]);
  }
}

// The area of each of `count` pieces, which are numbered by the lowest thing of their group.
std::vector<double> AreasOfPieces(const auto& mesh, const std::vector<int32_t>& at_weld,
                                  const std::vector<int32_t>& number, int32_t count, DisjointSets& sets) {
  std::vector<double> areas(count, 0);
  int32_t current = kNone;  // its sum is kept at hand
  double sum = 0;
  const auto change_to = [&](int32_t piece) {
    if (current != kNone) areas[current] = sum;
    current = piece;
    if (current != kNone) sum = areas[current];
  };
  ForThings(mesh, at_weld, [&](const Triangle& t, int32_t thing) {
    const int32_t piece = number[sets.LowestOf(thing)];
    if (piece != current) change_to(piece);
    if (piece != kNone) sum += TwiceVectorArea(mesh.points, t).norm() / 2;
  });
  change_to(kNone);
  return areas;
}

// The piece of surface of each boundary edge. Away from welded vertices triangles are of one piece when they share a
// vertex; at those, when they share an edge.
void StorePieces(const auto& mesh, const Weld& weld, const std::vector<int32_t>& at_weld, const WeldedEdges& edges,
                 PieceAreas areas, SurveyRecord& record) {
  const auto vertices = static_cast<int32_t>(mesh.points.size());
  const int32_t things = vertices + static_cast<int32_t>(at_weld.size());
  DisjointSets sets(things);
  ForThings(mesh, at_weld, [&](const Triangle& t, int32_t thing) {
    if (thing < vertices) {
      sets.Join(thing, t[1]);
      sets.Join(thing, t[2]);
      return;
    }
    for (const int32_t v : t) {
      if (weld.weld[v] == kNone) sets.Join(thing, v);
    }
  });
  const auto of_triangle = [&](int32_t t) {
    return vertices + static_cast<int32_t>(std::lower_bound(at_weld.begin(), at_weld.end(), t) - at_weld.begin());
  };
  for (const auto& [a, b] : edges.across) sets.Join(of_triangle(a), of_triangle(b));
  std::vector<int32_t> number(things, kNone);  // of the piece, by its lowest thing
  int32_t pieces = 0;
  for (size_t e = 0; e < edges.boundary.size(); ++e) {
    int32_t& piece = number[sets.LowestOf(of_triangle(edges.boundary[e].triangle))];
    if (piece == kNone) piece = pieces++;
    record.edges[e].piece = piece;
  }
  if (areas == PieceAreas::kYes) record.piece_areas = AreasOfPieces(mesh, at_weld, number, pieces, sets);
}

// A surface that is there twice, front and back, balances everywhere.
void CountRepeatedEdges(const MeshView& mesh, SurveyRecord& record) {
  SurveyRecord again;
  const Weld weld = WeldMarked(mesh, std::vector<uint8_t>(mesh.points.size(), 1));
  FindWeldedEdges(mesh, weld.weld, TrianglesAtWelds(mesh, weld.weld), DoubleEdges::kNone, again);
  record.repeated_edges = again.repeated_edges;
}

// Each triangle once, if all are there more than once with the same corners in the same order around.
std::optional<std::vector<Triangle>> OfOneLayer(const MeshView& mesh) {
  std::vector<Triangle> once;
  PositionIndex index;
  std::vector<int32_t> number;
  for (const Point3& p : mesh.points) number.push_back(index.Insert(p));
  std::map<Triangle, int> count;
  for (const Triangle& t : mesh.triangles) {
    Triangle corners = {number[t[0]], number[t[1]], number[t[2]]};
    std::rotate(corners.begin(), std::ranges::min_element(corners), corners.end());
    if (++count[corners] == 1) once.push_back(t);
  }
  const bool all = std::ranges::all_of(count, [](const auto& of_one) { return of_one.second > 1; });
  return all ? std::optional(std::move(once)) : std::nullopt;
}

SurveyRecord SurveyAsItIs(const auto& mesh, bool float32, PieceAreas areas) {
  SurveyRecord record;
  record.float32 = float32;
  record.vertex_count = static_cast<int64_t>(mesh.points.size());
  record.triangle_count = static_cast<int64_t>(mesh.triangles.size());
  Point3 lo = Point3::Constant(std::numeric_limits<double>::infinity()), hi = -lo;
  for (const Point3& p : mesh.points) {
    for (int k = 0; k < 3; ++k) {
      lo[k] = std::min(lo[k], p[k]);
      hi[k] = std::max(hi[k], p[k]);
    }
  }
  record.lo = lo;
  record.hi = hi;
  const std::vector<uint8_t> marked = MarkUnbalancedVertices(mesh);
  const Weld weld = WeldMarked(mesh, marked);
  record.doubled_vertices = weld.doubled;
  const std::vector<int32_t> at_weld = TrianglesAtWelds(mesh, weld.weld);
  const DoubleEdges doubles = areas == PieceAreas::kYes ? DoubleEdges::kNone : DoubleEdges::kClose;
  const WeldedEdges edges = FindWeldedEdges(mesh, weld.weld, at_weld, doubles, record);
  const std::vector<int32_t> boundary = StoreBoundary(mesh, weld, edges.boundary, record);
  StoreBand(mesh, boundary, at_weld, record);
  StoreVertexFigures(record);
  StorePieces(mesh, weld, at_weld, edges, areas, record);
  if (areas == PieceAreas::kYes) {
    StoreEdgesAfter(mesh, weld, at_weld, edges.boundary, record);
    if (edges.boundary.empty()) CountRepeatedEdges(mesh, record);
  }
  return record;
}

SurveyRecord SurveyByType(const MeshView& mesh, bool float32, PieceAreas areas) {
  const auto points = mesh.points.AsSpan();
  const auto triangles = mesh.triangles.AsSpan();
  return points && triangles ? SurveyAsItIs(PlainMesh{*points, *triangles}, float32, areas)
                             : SurveyAsItIs(mesh, float32, areas);
}

}  // namespace

SurveyRecord SurveyTile(const MeshView& mesh, bool float32, PieceAreas areas) {
  SurveyRecord record = SurveyByType(mesh, float32, areas);
  const bool one_mesh = areas == PieceAreas::kYes;  // its faces are made to agree, across those that are copied too
  std::optional<std::vector<Triangle>> other;
  if (record.repeated_edges > 0 && one_mesh) other = OfOneLayer(mesh);
  if (!other && (record.repeated_edges > 0 || (one_mesh && record.nonmanifold_edges > 0))) other = WithoutCopies(mesh);
  const int64_t copied = other ? static_cast<int64_t>(mesh.triangles.size()) - std::ssize(*other) : 0;
  const auto survey_other = [&] { return SurveyByType({mesh.points, TriangleRows(*other)}, float32, areas); };
  if (copied > 0) record = survey_other();
  int64_t turned = 0;
  if (one_mesh && record.disagreeing_edges > 0) {
    if (!other) other = mesh.triangles.Copy();
    turned = OrientFaces(mesh.points, *other);
    if (turned > 0) record = survey_other();
  }
  record.triangle_count = static_cast<int64_t>(mesh.triangles.size());
  record.copied_triangles = copied;
  record.turned_triangles = turned;
  return record;
}

}  // namespace tilemend
