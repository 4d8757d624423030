#include "common/mesh/triangulation/segments.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace tilemend::internal {

SegmentInserter::SegmentInserter(DelaunayMesh& mesh)
    : mesh_(mesh),
      triangle_of_(mesh.points.size(), -1),
      degree_(mesh.points.size(), 0),
      removed_at_(mesh.triangles.size(), 0) {
  for (size_t t = 0; t < mesh_.triangles.size(); ++t) {
    Touch(static_cast<int32_t>(t));
    for (int32_t v : mesh_.triangles[t].corner) {
      if (v >= 0) ++degree_[v];
    }
  }
}

void SegmentInserter::Touch(int32_t triangle) {
  const MeshTriangle& t = mesh_.triangles[triangle];
  if (t.IsGhost()) return;
  for (int32_t v : t.corner) triangle_of_[v] = triangle;
}

void SegmentInserter::Constrain(int32_t half_edge) {
  const int32_t other = mesh_.Twin(half_edge);
  mesh_.triangles[half_edge >> 2].flags |= 1u << (half_edge & 3);
  mesh_.triangles[other >> 2].flags |= 1u << (other & 3);
}

// Turns once around a: finds the edge that the ray towards b crosses or the vertex that it meets.
SegmentInserter::Departure SegmentInserter::Leave(int32_t a, int32_t b) const {
  const Point32 pa = mesh_.points[a], pb = mesh_.points[b];
  const int32_t start = triangle_of_[a];
  int32_t t = start;
  do {
    const MeshTriangle& triangle = mesh_.triangles[t];
    const int k = triangle.corner[0] == a ? 0 : triangle.corner[1] == a ? 1 : 2;
    const int32_t u = triangle.corner[Next(k)], w = triangle.corner[Previous(k)];
    if (u == b) return {-1, u, 4 * t + Previous(k)};
    if (u >= 0) {
      const int64_t turn = Turn(pa, pb, mesh_.points[u]);
      if (turn == 0 && Dot(pa, pb, mesh_.points[u]) > 0) return {-1, u, 4 * t + Previous(k)};
      if (turn < 0 && w >= 0 && Turn(pa, pb, mesh_.points[w]) > 0) return {4 * t + k, -1, -1};
    }
    t = triangle.twin[Next(k)] >> 2;  // across the edge from w to a
  } while (t != start);
  return {};
}

std::optional<SegmentInserter::Obstacle> SegmentInserter::Insert(int32_t a, int32_t b) {
  // A pinch may join thousands of segments; turning around it for each would take quadratic time.
  if (degree_[a] > degree_[b]) std::swap(a, b);
  const Departure departure = Leave(a, b);
  if (departure.vertex == b) {
    Constrain(departure.spoke);
    return std::nullopt;
  }
  if (departure.vertex >= 0) return Obstacle{true, departure.vertex, -1};
  Require(departure.half_edge >= 0, "segment ends are vertices of the triangulation");
  if (auto obstacle = March(a, b, departure.half_edge)) return obstacle;
  CollectLooseEdges(a, b);
  free_ = removed_;
  todo_.clear();
  FillSide(left_, true);
  FillSide(right_, false);
  Join();
  MakeDelaunay();
  return std::nullopt;
}

// Follows the segment from a; `half_edge` is the first edge that it crosses, its origin on the right, its target on the
// left. Fills removed_ and the chains of vertices on either side, ends included.
std::optional<SegmentInserter::Obstacle> SegmentInserter::March(int32_t a, int32_t b, int32_t half_edge) {
  const Point32 pa = mesh_.points[a], pb = mesh_.points[b];
  removed_.assign(1, half_edge >> 2);
  right_ = {a, mesh_.Origin(half_edge)};
  left_ = {a, mesh_.Target(half_edge)};
  while (true) {
    if (mesh_.IsConstrained(half_edge)) return Obstacle{false, mesh_.Origin(half_edge), mesh_.Target(half_edge)};
    const int32_t across = mesh_.Twin(half_edge);
    const int32_t apex = mesh_.Apex(across);
    removed_.push_back(across >> 2);
    if (apex == b) break;
    const int64_t turn = Turn(pa, pb, mesh_.points[apex]);
    if (turn == 0) return Obstacle{true, apex, -1};
    // Seen from the new triangle the crossed edge runs from the left vertex to the right one, then comes the apex.
    if (turn > 0) {
      left_.push_back(apex);
      half_edge = (across & ~3) + Next(across & 3);
    } else {
      right_.push_back(apex);
      half_edge = (across & ~3) + Previous(across & 3);
    }
  }
  left_.push_back(b);
  right_.push_back(b);
  return std::nullopt;
}

void SegmentInserter::AddLoose(int32_t u, int32_t v, int32_t half_edge, bool constrained) {
  loose_.push_back({std::min(u, v), std::max(u, v), half_edge, constrained});
}

// The edges of the removed triangles that stay. An edge with removed triangles on both sides either was crossed, or
// dangles into the cavity; it reappears there if a chain runs along it to and fro.
void SegmentInserter::CollectLooseEdges(int32_t a, int32_t b) {
  ++round_;
  for (int32_t t : removed_) removed_at_[t] = round_;
  loose_.clear();
  for (int32_t t : removed_) {
    for (int k = 0; k < 3; ++k) {
      const int32_t e = 4 * t + k, across = mesh_.Twin(e);
      const bool inside = removed_at_[across >> 2] == round_;
      if (inside && !mesh_.IsConstrained(e)) continue;
      AddLoose(mesh_.Origin(e), mesh_.Target(e), inside ? -1 : across, mesh_.IsConstrained(e));
    }
  }
  AddLoose(a, b, -1, true);
}

// Scans a chain from a to b on one side of the segment, cutting off each corner that bulges away from the segment.
void SegmentInserter::FillSide(const std::vector<int32_t>& chain, bool left) {
  pile_.clear();
  for (int32_t v : chain) {
    while (pile_.size() >= 2) {
      const int32_t u = pile_[pile_.size() - 2], w = pile_.back();
      const int64_t turn = Turn(mesh_.points[u], mesh_.points[w], mesh_.points[v]);
      if (left ? turn >= 0 : turn <= 0) break;
      pile_.pop_back();
      const int32_t t = free_.back();
      free_.pop_back();
      MeshTriangle& triangle = mesh_.triangles[t];
      triangle.corner = left ? std::array{u, v, w} : std::array{u, w, v};
      triangle.flags = 0;
      Touch(t);
      for (int k = 0; k < 3; ++k) {
        AddLoose(triangle.corner[Next(k)], triangle.corner[Previous(k)], 4 * t + k, false);
        todo_.push_back(4 * t + k);
      }
    }
    pile_.push_back(v);
  }
}

// Pairs up the loose half-edges with the same ends.
void SegmentInserter::Join() {
  std::sort(loose_.begin(), loose_.end(), [](const LooseEdge& x, const LooseEdge& y) {
    return std::tie(x.lo, x.hi, x.half_edge) < std::tie(y.lo, y.hi, y.half_edge);
  });
  for (size_t i = 0; i < loose_.size();) {
    size_t j = i;
    bool constrained = false;
    int32_t first = -1, second = -1;
    for (; j < loose_.size() && loose_[j].lo == loose_[i].lo && loose_[j].hi == loose_[i].hi; ++j) {
      constrained |= loose_[j].constrained;
      if (loose_[j].half_edge < 0) continue;
      second = first;
      first = loose_[j].half_edge;
    }
    mesh_.Link(first, second);
    if (constrained) Constrain(first);
    i = j;
  }
}

void SegmentInserter::MakeDelaunay() {
  while (!todo_.empty()) {
    const int32_t e = todo_.back();
    todo_.pop_back();
    if (mesh_.IsConstrained(e) || !mesh_.IsIllegal(e)) continue;
    const int32_t t = e >> 2, u = mesh_.Twin(e) >> 2;
    mesh_.Flip(e);
    Touch(t);
    Touch(u);
    for (int k = 0; k < 3; ++k) {
      todo_.push_back(4 * t + k);
      todo_.push_back(4 * u + k);
    }
  }
}

}  // namespace tilemend::internal
