#include "worker/survey/welded_edges.h"

#include <iterator>
#include <map>
#include <set>
#include <span>
#include <tuple>

#include "common/mesh/disjoint_sets.h"

namespace tilemend {
namespace {

constexpr int32_t kNoWeld = -1;

// The edges between welded vertices, of all triangles that have three positions.
std::vector<HalfEdge> HalfEdgesAtWelds(const MeshView& mesh, const std::vector<int32_t>& weld,
                                       const std::vector<int32_t>& at_weld, SurveyRecord& record) {
  std::vector<HalfEdge> edges;
  for (const int32_t i : at_weld) {
    const Triangle& t = mesh.triangles[i];
    const int32_t w[3] = {weld[t[0]], weld[t[1]], weld[t[2]]};
    const int welded = (w[0] != kNoWeld) + (w[1] != kNoWeld) + (w[2] != kNoWeld);
    if (welded < 2) continue;
    const bool flat = (w[0] != kNoWeld && (w[0] == w[1] || w[0] == w[2])) || (w[1] != kNoWeld && w[1] == w[2]);
    if (flat) {
      ++record.degenerate_triangles;
      continue;
    }
    for (int k = 0; k < 3; ++k) {
      const HalfEdge e{w[k], w[(k + 1) % 3], i, k};
      if (e.from != kNoWeld && e.to != kNoWeld) edges.push_back(e);
    }
  }
  return edges;
}

bool AreAtTheSameCorners(const MeshView& mesh, int32_t a, int32_t b) {
  return std::ranges::all_of(mesh.triangles[a], [&](int32_t v) {
    return std::ranges::any_of(mesh.triangles[b], [&](int32_t w) { return mesh.points[v] == mesh.points[w]; });
  });
}

// Whether two triangles that go the same way along an edge lie on each other: on one side of it, facing one way.
bool LieOnEachOther(const MeshView& mesh, const HalfEdge& a, const HalfEdge& b) {
  const auto corner = [&](const HalfEdge& e, int k) {
    return mesh.points[mesh.triangles[e.triangle][(e.place + k) % 3]];
  };
  const auto across = [&](const HalfEdge& e) {
    const Point3 from = corner(e, 0);
    const Eigen::Vector3d along = (corner(e, 1) - from).normalized(), tip = corner(e, 2) - from;
    return Eigen::Vector3d(tip - along.dot(tip) * along);
  };
  const auto normal = [&](const HalfEdge& e) {
    return Eigen::Vector3d(Eigen::Vector3d(corner(e, 1) - corner(e, 0)).cross(corner(e, 2) - corner(e, 0)));
  };
  return across(a).dot(across(b)) > 0 && normal(a).dot(normal(b)) > 0;
}

// Of edges where two triangles lie on each other: those that hang together with a place where the boundary ends.
std::vector<HalfEdge> EdgesThatClose(const std::vector<HalfEdge>& boundary, const std::vector<HalfEdge>& odd) {
  std::map<int32_t, int32_t> number;  // of the vertices at odd edges
  for (const HalfEdge& e : odd) {
    for (const int32_t v : {e.from, e.to}) number.try_emplace(v, static_cast<int32_t>(number.size()));
  }
  std::vector<int32_t> leaving(number.size(), 0);  // boundary edges that begin there, less those that end
  for (const HalfEdge& e : odd.empty() ? std::vector<HalfEdge>() : boundary) {
    if (const auto at = number.find(e.from); at != number.end()) ++leaving[at->second];
    if (const auto at = number.find(e.to); at != number.end()) --leaving[at->second];
  }
  DisjointSets sets(static_cast<int32_t>(number.size()));
  for (const HalfEdge& e : odd) sets.Join(number.at(e.from), number.at(e.to));
  std::set<int32_t> open;
  for (int32_t v = 0; v < std::ssize(leaving); ++v) {
    if (leaving[v] != 0) open.insert(sets.LowestOf(v));
  }
  std::vector<HalfEdge> closing;
  std::ranges::copy_if(odd, std::back_inserter(closing),
                       [&](const HalfEdge& e) { return open.contains(sets.LowestOf(number.at(e.from))); });
  return closing;
}

// In order of their ends, then of the triangles.
void SortByEnds(std::vector<HalfEdge>& edges) {
  struct Entry {
    uint64_t key;
    int32_t order;
  };
  std::vector<Entry> entries;
  entries.reserve(edges.size());
  for (const HalfEdge& e : edges) {
    entries.push_back(
        {static_cast<uint64_t>(e.lo()) << 32 | static_cast<uint32_t>(e.hi()), static_cast<int32_t>(entries.size())});
  }
  std::sort(entries.begin(), entries.end(),
            [](const Entry& a, const Entry& b) { return a.key != b.key ? a.key < b.key : a.order < b.order; });
  std::vector<HalfEdge> sorted;
  sorted.reserve(edges.size());
  for (const Entry& entry : entries) sorted.push_back(edges[entry.order]);
  edges = std::move(sorted);
}

// Sorts the edges of the mesh into the result, edge by edge.
class EdgeSorter {
 public:
  EdgeSorter(const MeshView& mesh, DoubleEdges doubles, SurveyRecord& record)
      : mesh_(mesh), doubles_(doubles), record_(record) {}

  // The triangles at one edge.
  void Take(std::span<const HalfEdge> edge) {
    if (edge.size() == 1) {
      result_.boundary.push_back(edge[0]);
      return;
    }
    bool repeats = true;
    for (const HalfEdge& other : edge.subspan(1)) {
      result_.across.emplace_back(edge[0].triangle, other.triangle);
      repeats = repeats && AreAtTheSameCorners(mesh_, edge[0].triangle, other.triangle);
    }
    record_.repeated_edges += repeats;
    record_.nonmanifold_edges += edge.size() > 2;
    const bool is_same_way = edge.size() == 2 && edge[0].from == edge[1].from;
    const bool lies_double = is_same_way && doubles_ == DoubleEdges::kClose && LieOnEachOther(mesh_, edge[0], edge[1]);
    record_.disagreeing_edges += is_same_way && !lies_double && !repeats;
    if (lies_double) double_.insert(double_.end(), edge.begin(), edge.end());
  }

  WeldedEdges Finish() && {
    const std::vector<HalfEdge> closing = EdgesThatClose(result_.boundary, double_);
    result_.boundary.insert(result_.boundary.end(), closing.begin(), closing.end());
    std::ranges::stable_sort(result_.boundary, {}, [](const HalfEdge& e) { return std::tuple(e.triangle, e.place); });
    return std::move(result_);
  }

 private:
  const MeshView mesh_;
  const DoubleEdges doubles_;
  SurveyRecord& record_;
  WeldedEdges result_;
  std::vector<HalfEdge> double_;
};

}  // namespace

WeldedEdges FindWeldedEdges(const MeshView& mesh, const std::vector<int32_t>& weld, const std::vector<int32_t>& at_weld,
                            DoubleEdges doubles, SurveyRecord& record) {
  std::vector<HalfEdge> edges = HalfEdgesAtWelds(mesh, weld, at_weld, record);
  SortByEnds(edges);
  EdgeSorter sorter(mesh, doubles, record);
  for (size_t i = 0, j = 0; i < edges.size(); i = j) {
    while (j < edges.size() && edges[j].lo() == edges[i].lo() && edges[j].hi() == edges[i].hi()) ++j;
    sorter.Take(std::span(edges).subspan(i, j - i));
  }
  return std::move(sorter).Finish();
}

}  // namespace tilemend
