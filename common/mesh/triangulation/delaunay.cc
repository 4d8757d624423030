#include "common/mesh/triangulation/delaunay.h"

#include <cstdio>
#include <cstdlib>

namespace tilemend::internal {

void Require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "precondition violated: %s\n", what);
  std::abort();
}

void DelaunayMesh::Start(int32_t a, int32_t b, int32_t c) {
  triangles.resize(4);
  triangles[0].corner = {a, b, c};
  const std::array<int32_t, 3> corners = {a, b, c};
  for (int k = 0; k < 3; ++k) {
    // Ghost k + 1 lies across edge k and has the ghost at corner 2, so its edge 2 is that edge reversed.
    triangles[k + 1].corner = {corners[Previous(k)], corners[Next(k)], kGhost};
    Link(k, 4 * (k + 1) + 2);
  }
  // Around the hull, the ghost across edge k ends where the ghost across edge k-1 begins.
  for (int k = 0; k < 3; ++k) Link(4 * (k + 1) + 0, 4 * (Previous(k) + 1) + 1);
}

Location DelaunayMesh::Locate(Point32 p, int32_t start, int64_t step_limit) {
  int32_t t = start;
  int came = -1;
  for (int64_t step = 0; step < step_limit; ++step) {
    const MeshTriangle& triangle = triangles[t];
    if (triangle.IsGhost()) return {Location::Kind::kInside, t, 0};
    random_ = random_ * 1664525u + 1013904223u;
    int k = static_cast<int>((random_ >> 16) % 3);
    int zeros = 0, last_zero = 0, zero_sum = 0, exit = -1;
    for (int i = 0; i < 3; ++i, k = Next(k)) {
      if (k == came) continue;
      const int64_t turn = Turn(points[triangle.corner[Next(k)]], points[triangle.corner[Previous(k)]], p);
      if (turn < 0) {
        exit = k;
        break;
      }
      if (turn == 0) {
        ++zeros;
        last_zero = k;
        zero_sum += k;
      }
    }
    if (exit < 0) {
      if (zeros == 0) return {Location::Kind::kInside, t, 0};
      if (zeros == 1) return {Location::Kind::kOnEdge, t, last_zero};
      return {Location::Kind::kOnVertex, t, 3 - zero_sum};
    }
    const int32_t across = triangle.twin[exit];
    if (across < 0) return {Location::Kind::kBlocked, t, exit};
    t = across >> 2;
    came = across & 3;
  }
  return {Location::Kind::kBlocked, t, -1};
}

bool DelaunayMesh::InConflict(const MeshTriangle& t, Point32 p) const {
  if (!t.IsGhost()) {
    return InCircleDeterminant(points[t.corner[0]], points[t.corner[1]], points[t.corner[2]], p) > 0;
  }
  // A ghost's circle is the open half-plane beyond its hull edge.
  const int k = t.corner[0] < 0 ? 0 : t.corner[1] < 0 ? 1 : 2;
  return Turn(points[t.corner[Next(k)]], points[t.corner[Previous(k)]], p) > 0;
}

// Depth-first over the dual tree, children in counter-clockwise order, so that the rim comes out in order. A triangle
// in conflict that is entered across an edge facing p has p on the inner side of its two other edges: p lies in the cap
// of its circle beyond the edge, and both other edges' lines leave the circle at the cap's ends. So the cavity is
// star-shaped, each triangle is entered once, and walls hide what p does not see.
void DelaunayMesh::FindCavity(Point32 p, const Location& where) {
  cavity_.assign(1, where.triangle);
  rim_.clear();
  stack_.clear();
  const int32_t first = 4 * where.triangle;
  if (where.kind == Location::Kind::kOnEdge) {
    const int32_t across = Twin(first + where.k);
    cavity_.push_back(across >> 2);
    stack_.push_back((across & ~3) + Previous(across & 3));
    stack_.push_back((across & ~3) + Next(across & 3));
    stack_.push_back(first + Previous(where.k));
    stack_.push_back(first + Next(where.k));
  } else {
    for (int k : {2, 1, 0}) stack_.push_back(first + k);
  }
  while (!stack_.empty()) {
    const int32_t e = stack_.back();
    stack_.pop_back();
    const int32_t across = Twin(e);
    if (across >= 0 && InConflict(triangles[across >> 2], p)) {
      cavity_.push_back(across >> 2);
      stack_.push_back((across & ~3) + Previous(across & 3));
      stack_.push_back((across & ~3) + Next(across & 3));
    } else {
      rim_.push_back(e);
    }
  }
}

std::span<const int32_t> DelaunayMesh::FillCavity(int32_t vertex) {
  rim_edges_.clear();
  for (int32_t e : rim_) rim_edges_.push_back({Origin(e), Target(e), Twin(e)});
  const int32_t tag = triangles[cavity_[0]].tag;
  star_ = cavity_;
  while (star_.size() < rim_edges_.size()) {
    star_.push_back(static_cast<int32_t>(triangles.size()));
    triangles.emplace_back();
  }
  const size_t n = star_.size();
  int32_t before = star_[n - 1];
  for (size_t i = 0; i < n; ++i) {
    const RimEdge& edge = rim_edges_[i];
    MeshTriangle& t = triangles[star_[i]];
    t.corner = {edge.from, edge.to, vertex};
    t.flags = 0;
    t.tag = tag;
    t.twin = {4 * star_[i + 1 < n ? i + 1 : 0] + 1, 4 * before, edge.outer};
    if (edge.outer >= 0) triangles[edge.outer >> 2].twin[edge.outer & 3] = 4 * star_[i] + 2;
    before = star_[i];
  }
  return star_;
}

void DelaunayMesh::Flip(int32_t half_edge) {
  const int32_t other = Twin(half_edge);
  const int32_t t = half_edge >> 2, u = other >> 2;
  const int k = half_edge & 3, j = other & 3;
  MeshTriangle& near = triangles[t];
  MeshTriangle& far = triangles[u];
  // near = (p, a, b), far = (q, b, a) become (p, a, q), (q, b, p); bp and aq change sides.
  const uint32_t bp = (near.flags >> Next(k)) & 1, aq = (far.flags >> Next(j)) & 1;
  const int32_t outside_bp = near.twin[Next(k)], outside_aq = far.twin[Next(j)];
  near.corner[Previous(k)] = far.corner[j];
  far.corner[Previous(j)] = near.corner[k];
  near.flags = (near.flags & ~(1u << k) & ~(1u << Next(k))) | aq << k;
  far.flags = (far.flags & ~(1u << j) & ~(1u << Next(j))) | bp << j;
  Link(4 * t + k, outside_aq);
  Link(4 * u + j, outside_bp);
  Link(4 * t + Next(k), 4 * u + Next(j));
}

bool DelaunayMesh::IsIllegal(int32_t half_edge) const {
  const int32_t other = Twin(half_edge);
  if (other < 0) return false;
  const MeshTriangle& near = triangles[half_edge >> 2];
  const MeshTriangle& far = triangles[other >> 2];
  if (near.IsGhost() || far.IsGhost()) return false;
  return InConflict(near, points[far.corner[other & 3]]);
}

}  // namespace tilemend::internal
