#include "common/mesh/triangulation/region_triangulation.h"

#include <algorithm>
#include <numeric>
#include <unordered_set>
#include <utility>

#include "common/mesh/triangulation/delaunay.h"
#include "common/mesh/triangulation/insertion_order.h"
#include "common/mesh/triangulation/segments.h"

namespace tilemend {
namespace internal {
namespace {

using Kind = RegionConflict::Kind;

constexpr size_t kMostConflicts = 64;
// A walk that takes more steps goes round in circles, or a long way round a wall.
constexpr int64_t kLongestWalk = 1000;

// Inserts `indices` of mesh.points into an empty mesh, with ghosts. Returns false, and leaves the mesh empty, if all
// lie on one line. Points at the place of an earlier one are left out and listed as pairs (earlier, later).
bool InsertAll(DelaunayMesh& mesh, std::vector<int32_t> indices, std::vector<std::pair<int32_t, int32_t>>& coincident) {
  SortForInsertion(mesh.points, indices);
  const auto& points = mesh.points;
  const int32_t a = indices[0];
  const auto b = std::find_if(indices.begin(), indices.end(), [&](int32_t i) { return points[i] != points[a]; });
  if (b == indices.end()) return false;
  const auto c = std::find_if(b, indices.end(), [&](int32_t i) { return Turn(points[a], points[*b], points[i]) != 0; });
  if (c == indices.end()) return false;
  const std::array<int32_t, 3> first = {a, *b, *c};
  if (Turn(points[a], points[*b], points[*c]) > 0) {
    mesh.Start(a, *b, *c);
  } else {
    mesh.Start(a, *c, *b);
  }
  mesh.triangles.reserve(2 * indices.size() + 2);
  int32_t near = 0;
  for (int32_t i : indices) {
    if (i == first[0] || i == first[1] || i == first[2]) continue;
    const Location where = mesh.Locate(points[i], near);
    if (where.kind == Location::Kind::kOnVertex) {
      const int32_t other = mesh.triangles[where.triangle].corner[where.k];
      coincident.emplace_back(std::min(i, other), std::max(i, other));
      continue;
    }
    mesh.FindCavity(points[i], where);
    for (int32_t t : mesh.FillCavity(i)) {
      if (!mesh.triangles[t].IsGhost()) near = t;
    }
  }
  return true;
}

class RegionBuilder {
 public:
  RegionBuilder(std::span<const LatticePoint> points, std::span<const RegionSegment> segments);
  RegionMesh Build(const std::function<bool()>& is_cancelled) &&;

 private:
  void FindDegenerateSegments();
  void ReportCollinear();
  void InsertSegments(const std::function<bool()>& is_cancelled);
  void FindHalfEdges();
  void ColourParts();
  void FindInside();
  void LocateFreePoints();
  void CutOut();
  void InsertFreePoints();

  void Report(Kind kind, int32_t first, int32_t second) {
    if (region_.conflicts.size() < kMostConflicts) region_.conflicts.push_back({kind, first, second});
  }
  // The lowest segment from u to v, or -1.
  int32_t Find(int32_t u, int32_t v) const;

  std::span<const RegionSegment> segments_;
  RegionMesh region_;
  DelaunayMesh& mesh_ = region_.mesh;
  std::vector<bool> used_;             // per point: a segment ends there
  std::vector<bool> skip_;             // per segment: reported already
  std::vector<int32_t> sorted_;        // segments by (from, to, index)
  std::vector<int32_t> first_from_;    // per point: in sorted_, the first segment from it
  std::vector<int32_t> half_edge_of_;  // per segment: the half-edge that has it, in the triangle on its left
  std::vector<int32_t> part_;          // per triangle: the part of the plane between segments it belongs to
  struct FreePoint {
    int32_t point;
    int32_t triangle;
  };
  std::vector<FreePoint> free_points_;  // those inside, in the order of insertion
  std::vector<int32_t> inside_claim_;   // per part: a segment that has it on the left, or -1
};

RegionBuilder::RegionBuilder(std::span<const LatticePoint> points, std::span<const RegionSegment> segments)
    : segments_(segments),
      used_(points.size(), false),
      skip_(segments.size(), false),
      sorted_(segments.size()),
      first_from_(points.size() + 1, 0) {
  const auto count = static_cast<int32_t>(points.size());
  mesh_.points.reserve(points.size());
  for (const LatticePoint& p : points) {
    Require(std::abs(p.x) < kCoordinateBound && std::abs(p.y) < kCoordinateBound, "lattice coordinates below 2^29");
    mesh_.points.push_back(Narrow(p));
  }
  for (const RegionSegment& s : segments_) {
    Require(s.from >= 0 && s.from < count && s.to >= 0 && s.to < count, "segment ends are points");
    used_[s.from] = used_[s.to] = true;
    ++first_from_[s.from + 1];
  }
  std::partial_sum(first_from_.begin(), first_from_.end(), first_from_.begin());
  std::vector<int32_t> next(first_from_.begin(), first_from_.end() - 1);
  for (size_t s = 0; s < segments_.size(); ++s) sorted_[next[segments_[s].from]++] = static_cast<int32_t>(s);
  for (int32_t v = 0; v < count; ++v) {
    std::sort(sorted_.begin() + first_from_[v], sorted_.begin() + first_from_[v + 1],
              [&](int32_t a, int32_t b) { return std::pair(segments_[a].to, a) < std::pair(segments_[b].to, b); });
  }
}

int32_t RegionBuilder::Find(int32_t u, int32_t v) const {
  const auto begin = sorted_.begin() + first_from_[u], end = sorted_.begin() + first_from_[u + 1];
  const auto it = std::lower_bound(begin, end, v, [&](int32_t s, int32_t to) { return segments_[s].to < to; });
  return it == end || segments_[*it].to != v ? -1 : *it;
}

RegionMesh RegionBuilder::Build(const std::function<bool()>& is_cancelled) && {
  std::vector<int32_t> indices;
  for (size_t i = 0; i < used_.size(); ++i) {
    if (used_[i]) indices.push_back(static_cast<int32_t>(i));
  }
  if (!indices.empty()) {
    FindDegenerateSegments();
    std::vector<std::pair<int32_t, int32_t>> coincident;
    const bool spans_plane = InsertAll(mesh_, indices, coincident);
    std::sort(coincident.begin(), coincident.end());
    for (const auto& [first, second] : coincident) Report(Kind::kCoincidentPoints, first, second);
    if (!spans_plane) ReportCollinear();
    if (spans_plane) InsertSegments(is_cancelled);
    if (region_.conflicts.empty()) FindHalfEdges();
    if (region_.conflicts.empty()) ColourParts();
    if (region_.conflicts.empty()) FindInside();
  }
  if (!region_.conflicts.empty()) {
    mesh_.triangles.clear();
  } else if (!indices.empty()) {
    LocateFreePoints();
    CutOut();
    InsertFreePoints();
  }
  return std::move(region_);
}

void RegionBuilder::FindDegenerateSegments() {
  for (size_t i = 0; i < segments_.size(); ++i) {
    const auto s = static_cast<int32_t>(i);
    const int32_t lowest = Find(segments_[s].from, segments_[s].to);
    skip_[s] = segments_[s].from == segments_[s].to || lowest != s;
    if (skip_[s]) Report(Kind::kDegenerate, lowest, s);
  }
}

// All points lie on one line, so nothing has an inside. Says which points coincide or lie on segments; if none do, that
// the segments have no two sides.
void RegionBuilder::ReportCollinear() {
  std::vector<int32_t> along;
  for (size_t i = 0; i < used_.size(); ++i) {
    if (used_[i]) along.push_back(static_cast<int32_t>(i));
  }
  const auto key = [&](int32_t i) { return std::pair(mesh_.points[i].x, mesh_.points[i].y); };
  std::sort(along.begin(), along.end(),
            [&](int32_t a, int32_t b) { return std::pair(key(a), a) < std::pair(key(b), b); });
  std::vector<size_t> rank(used_.size());
  for (size_t i = 0; i < along.size(); ++i) {
    rank[along[i]] = i;
    if (i > 0 && key(along[i]) == key(along[i - 1])) Report(Kind::kCoincidentPoints, along[i - 1], along[i]);
  }
  for (size_t s = 0; s < segments_.size() && region_.conflicts.size() < kMostConflicts; ++s) {
    const auto [lo, hi] = std::minmax(rank[segments_[s].from], rank[segments_[s].to]);
    for (size_t i = lo + 1; i < hi && region_.conflicts.size() < kMostConflicts; ++i) {
      if (key(along[i]) == key(along[lo]) || key(along[i]) == key(along[hi])) continue;
      Report(Kind::kPointOnSegment, static_cast<int32_t>(s), along[i]);
    }
  }
  if (!region_.conflicts.empty()) return;
  for (size_t s = 0; s < segments_.size(); ++s) Report(Kind::kInsideOut, static_cast<int32_t>(s), -1);
}

void RegionBuilder::InsertSegments(const std::function<bool()>& is_cancelled) {
  std::vector<bool> present(used_.size(), false);
  for (const MeshTriangle& t : mesh_.triangles) {
    for (int32_t v : t.corner) {
      if (v >= 0) present[v] = true;
    }
  }
  SegmentInserter inserter(mesh_);
  for (size_t i = 0; i < segments_.size() && region_.conflicts.size() < kMostConflicts; ++i) {
    const auto s = static_cast<int32_t>(i);
    const RegionSegment segment = segments_[s];
    if (skip_[s] || !present[segment.from] || !present[segment.to]) continue;
    if (is_cancelled && is_cancelled()) return Report(Kind::kCancelled, s, s);
    const auto obstacle = inserter.Insert(segment.from, segment.to);
    if (!obstacle) continue;
    if (obstacle->is_point) {
      Report(Kind::kPointOnSegment, s, obstacle->a);
    } else {
      const int32_t there = Find(obstacle->a, obstacle->b), back = Find(obstacle->b, obstacle->a);
      Report(Kind::kCrossing, there < 0 || (back >= 0 && back < there) ? back : there, s);
    }
  }
}

void RegionBuilder::FindHalfEdges() {
  half_edge_of_.assign(segments_.size(), -1);
  for (size_t t = 0; t < mesh_.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const auto e = static_cast<int32_t>(4 * t + k);
      if (!mesh_.IsConstrained(e)) continue;
      const int32_t s = Find(mesh_.Origin(e), mesh_.Target(e));
      if (s >= 0) half_edge_of_[s] = e;
    }
  }
}

// Numbers the parts of the plane that the segments separate: first those left of segments, in their order. What lies
// right of a segment only is outside and needs no number.
void RegionBuilder::ColourParts() {
  part_.assign(mesh_.triangles.size(), -1);
  std::vector<int32_t> stack;
  const auto flood = [&](int32_t seed, int32_t part) {
    part_[seed] = part;
    stack.push_back(seed);
    while (!stack.empty()) {
      const int32_t t = stack.back();
      stack.pop_back();
      for (int k = 0; k < 3; ++k) {
        const int32_t next = mesh_.triangles[t].twin[k] >> 2;
        if (mesh_.IsConstrained(4 * t + k) || part_[next] >= 0) continue;
        part_[next] = part;
        stack.push_back(next);
      }
    }
  };
  for (size_t s = 0; s < segments_.size(); ++s) {
    const int32_t t = half_edge_of_[s] >> 2;
    if (part_[t] >= 0) continue;
    inside_claim_.push_back(static_cast<int32_t>(s));
    flood(t, region_.component_count++);
  }
}

// A part left of one segment must not be right of another without a segment the other way, nor reach infinity.
void RegionBuilder::FindInside() {
  std::vector<bool> infinite(region_.component_count, false);
  for (size_t t = 0; t < mesh_.triangles.size(); ++t) {
    if (mesh_.triangles[t].IsGhost() && part_[t] >= 0) infinite[part_[t]] = true;
  }
  for (size_t s = 0; s < segments_.size(); ++s) {
    const int32_t left = part_[half_edge_of_[s] >> 2], right = part_[mesh_.Twin(half_edge_of_[s]) >> 2];
    const bool both_ways = Find(segments_[s].to, segments_[s].from) >= 0;
    if (infinite[left]) {
      Report(Kind::kInsideOut, static_cast<int32_t>(s), -1);
    } else if (right >= 0 && !infinite[right] && !both_ways) {
      Report(Kind::kInsideOut, static_cast<int32_t>(s), inside_claim_[right]);
    }
  }
}

bool Contains(const DelaunayMesh& mesh, const MeshTriangle& t, Point32 p) {
  if (t.IsGhost()) return false;
  for (int k = 0; k < 3; ++k) {
    if (Turn(mesh.points[t.corner[Next(k)]], mesh.points[t.corner[Previous(k)]], p) < 0) return false;
  }
  return true;
}

// Spreads from `near` over the triangles that no wall parts from it until one contains p; -1 if none does. The cost
// grows with the triangles that are nearer than the one that is found.
int32_t SearchAround(const DelaunayMesh& mesh, Point32 p, int32_t near) {
  std::vector<int32_t> queue = {near};
  std::unordered_set<int32_t> seen = {near};
  for (size_t head = 0; head < queue.size(); ++head) {
    const MeshTriangle& t = mesh.triangles[queue[head]];
    if (Contains(mesh, t, p)) return queue[head];
    for (const int32_t twin : t.twin) {
      if (twin >= 0 && seen.insert(twin >> 2).second) queue.push_back(twin >> 2);
    }
  }
  return -1;
}

// Walks from `near`; searches around it if walls or a long way round stop the walk.
Location LocateSurely(DelaunayMesh& mesh, Point32 p, int32_t near) {
  const Location where = mesh.Locate(p, near, 1000 + static_cast<int64_t>(mesh.triangles.size()));
  if (where.kind != Location::Kind::kBlocked) return where;
  const int32_t found = SearchAround(mesh, p, near);
  return found < 0 ? where : mesh.Locate(p, found);
}

// Finds the inside triangle of each free point while the mesh still covers the plane, where no wall stops a walk.
void RegionBuilder::LocateFreePoints() {
  std::vector<int32_t> indices;
  for (size_t i = 0; i < used_.size(); ++i) {
    if (!used_[i]) indices.push_back(static_cast<int32_t>(i));
  }
  SortForInsertion(mesh_.points, indices);
  int32_t near = 0;
  while (mesh_.triangles[near].IsGhost()) ++near;
  for (int32_t i : indices) {
    const Location where = LocateSurely(mesh_, mesh_.points[i], near);
    if (mesh_.triangles[where.triangle].IsGhost()) continue;
    near = where.triangle;
    if (where.kind == Location::Kind::kOnVertex) continue;
    if (where.kind == Location::Kind::kOnEdge && mesh_.IsConstrained(4 * where.triangle + where.k)) continue;
    if (part_[where.triangle] >= 0) free_points_.push_back({i, where.triangle});
  }
}

// Keeps the parts that are inside, with walls for their segments.
void RegionBuilder::CutOut() {
  std::vector<int32_t> place(mesh_.triangles.size(), -1);
  int32_t count = 0;
  for (size_t t = 0; t < place.size(); ++t) {
    if (part_[t] >= 0) place[t] = count++;
  }
  std::vector<MeshTriangle> kept(count);
  for (size_t t = 0; t < place.size(); ++t) {
    if (place[t] < 0) continue;
    MeshTriangle& triangle = kept[place[t]];
    triangle.corner = mesh_.triangles[t].corner;
    triangle.tag = part_[t];
    for (int k = 0; k < 3; ++k) {
      const int32_t e = static_cast<int32_t>(4 * t) + k, twin = mesh_.Twin(e);
      triangle.twin[k] =
          mesh_.IsConstrained(e) ? ~Find(mesh_.Origin(e), mesh_.Target(e)) : 4 * place[twin >> 2] + (twin & 3);
    }
  }
  mesh_.triangles = std::move(kept);
  for (FreePoint& free : free_points_) free.triangle = place[free.triangle];
}

// The last point's triangles are near, mostly with no wall between. The triangle found before the cut may have been
// replaced since; its slot then holds one that lies in what was its circle.
void RegionBuilder::InsertFreePoints() {
  int32_t last = -1;
  for (const FreePoint& free : free_points_) {
    const Point32 p = mesh_.points[free.point];
    const bool joined = last >= 0 && mesh_.triangles[last].tag == mesh_.triangles[free.triangle].tag;
    Location where = mesh_.Locate(p, joined ? last : free.triangle, kLongestWalk);
    if (where.kind == Location::Kind::kBlocked) where = LocateSurely(mesh_, p, free.triangle);
    if (where.kind != Location::Kind::kInside && where.kind != Location::Kind::kOnEdge) continue;  // coincides
    mesh_.FindCavity(p, where);
    last = mesh_.FillCavity(free.point).front();
  }
}

}  // namespace

RegionMesh BuildRegionMesh(std::span<const LatticePoint> points, std::span<const RegionSegment> segments,
                           const std::function<bool()>& is_cancelled) {
  return RegionBuilder(points, segments).Build(is_cancelled);
}

RegionTriangulation ExportRegion(const RegionMesh& region, size_t segment_count) {
  RegionTriangulation result;
  result.conflicts = region.conflicts;
  if (!result.conflicts.empty()) return result;
  const auto& triangles = region.mesh.triangles;
  result.component_count = region.component_count;
  result.triangles.reserve(triangles.size());
  result.neighbors.reserve(triangles.size());
  result.component.reserve(triangles.size());
  result.segment_triangle.assign(segment_count, -1);
  for (size_t t = 0; t < triangles.size(); ++t) {
    const MeshTriangle& triangle = triangles[t];
    result.triangles.push_back(triangle.corner);
    result.component.push_back(triangle.tag);
    auto& neighbors = result.neighbors.emplace_back();
    for (int k = 0; k < 3; ++k) {
      neighbors[k] = triangle.twin[k] < 0 ? -1 : triangle.twin[k] >> 2;
      if (triangle.twin[k] < 0) result.segment_triangle[~triangle.twin[k]] = static_cast<int32_t>(t);
    }
  }
  return result;
}

}  // namespace internal

RegionTriangulation TriangulateRegion(std::span<const LatticePoint> points, std::span<const RegionSegment> segments,
                                      const std::function<bool()>& is_cancelled) {
  return internal::ExportRegion(internal::BuildRegionMesh(points, segments, is_cancelled), segments.size());
}

}  // namespace tilemend
