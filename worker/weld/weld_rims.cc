#include "worker/weld/weld_rims.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "common/mesh/box_tree.h"
#include "common/mesh/segment_distance.h"
#include "worker/survey/survey.h"
#include "worker/weld/welding_mesh.h"

namespace tilemend {
namespace {

using Eigen::AlignedBox3d;

// A vertex lies beside an edge within this share of the shorter of the edge and the boundary edges at the vertex.
constexpr double kBeside = 0.5;

std::vector<int32_t> VerticesOf(const SurveyRecord& record) {
  std::vector<int32_t> vertices;
  for (const BoundaryVertex& v : record.vertices) vertices.push_back(v.index);
  return vertices;
}

class Welder {
 public:
  Welder(const TriMesh& mesh, const SurveyRecord& record, std::span<const int32_t> face_of, double tolerance,
         bool may_split)
      : tolerance_(tolerance), may_split_(may_split), mesh_(mesh, VerticesOf(record), face_of) {
    const std::vector<int32_t>& places = mesh_.boundary();
    for (const int32_t p : places) reach_[p] = tolerance;
    for (const BoundaryEdge& e : record.edges) {
      const double length = (record.vertices[e.to].position - record.vertices[e.from].position).norm();
      for (const int32_t v : {e.from, e.to}) {
        const auto [it, fresh] = shortest_.try_emplace(places[v], length);
        it->second = std::min(it->second, length);
        reach_[places[v]] = std::min(reach_[places[v]], it->second);
      }
    }
  }

  Weld Run() {
    MergePairs();
    SplitEdges();
    Weld weld;
    weld.triangles = mesh_.triangles();
    for (const int32_t p : mesh_.boundary()) {
      const int32_t stays = mesh_.StaysAs(p);
      if (stays != p) record_.welded.push_back({mesh_.VertexAt(p), mesh_.VertexAt(stays), Distance(p, stays)});
    }
    std::ranges::sort(record_.welded, {}, &WeldedVertex::vertex);
    std::ranges::stable_sort(record_.refused, {}, &RefusedWeld::distance);
    weld.record = std::move(record_);
    return weld;
  }

 private:
  struct Pair {
    double distance;
    int32_t a, b;  // places
  };

  double Distance(int32_t a, int32_t b) const { return (mesh_.PositionOf(a) - mesh_.PositionOf(b)).norm(); }

  AlignedBox3d BoxAround(int32_t place, double reach) const {
    const Point3 &p = mesh_.PositionOf(place), r = Point3::Constant(reach);
    return {p - r, p + r};
  }

  std::vector<Pair> FindPairs() const {
    const std::vector<int32_t>& places = mesh_.boundary();
    std::vector<AlignedBox3d> boxes;
    for (const int32_t p : places) boxes.push_back(BoxAround(p, 0));
    const BoxTree tree(boxes);
    std::vector<Pair> pairs;
    for (const int32_t a : places) {
      tree.AnyMeeting(BoxAround(a, reach_.at(a)), [&](int32_t i) {
        const int32_t b = places[i];
        const double distance = Distance(a, b);
        if (a < b && distance <= std::min(reach_.at(a), reach_.at(b))) pairs.push_back({distance, a, b});
        return false;
      });
    }
    std::ranges::sort(pairs, {}, [](const Pair& p) { return std::tuple(p.distance, p.a, p.b); });
    return pairs;
  }

  // Null if they were merged.
  const char* Merge(int32_t a, int32_t b) {
    const int32_t keep = std::min(a, b), gone = std::max(a, b);
    for (const int32_t member : mesh_.MembersOf(gone)) {
      if (Distance(member, keep) > tolerance_) return "the vertex that stays would be beyond the tolerance";
    }
    const char* fault = mesh_.MergeFault(keep, gone);
    if (fault == nullptr) mesh_.Merge(keep, gone);
    return fault;
  }

  // What is refused is tried again once others are merged.
  void MergePairs() {
    std::vector<Pair> pairs = FindPairs();
    std::vector<const char*> faults;
    for (bool merged = true; merged;) {
      merged = false;
      faults.clear();
      std::vector<Pair> refused;
      for (const Pair& pair : pairs) {
        const int32_t a = mesh_.StaysAs(pair.a), b = mesh_.StaysAs(pair.b);
        if (a == b) continue;
        if (const char* fault = Merge(a, b)) {
          faults.push_back(fault);
          refused.push_back(pair);
        } else {
          merged = true;
        }
      }
      pairs = std::move(refused);
    }
    for (size_t i = 0; i < pairs.size(); ++i) {
      if (mesh_.StaysAs(pairs[i].a) == mesh_.StaysAs(pairs[i].b)) continue;
      record_.refused.push_back(
          {{mesh_.VertexAt(pairs[i].a), mesh_.VertexAt(pairs[i].b)}, pairs[i].distance, faults[i]});
    }
  }

  struct Junction {
    double distance = std::numeric_limits<double>::infinity();
    double off_middle = 0;  // of the edge, in shares of its length
    int32_t place = -1;
    size_t edge = 0;

    // Of places as near the one in the middle goes first: many on one edge halve it again and again.
    bool operator<(const Junction& other) const {
      return std::tie(distance, off_middle) < std::tie(other.distance, other.off_middle);
    }
  };

  // The nearest edge that a place lies beside, of those that were not refused to it.
  Junction NearestEdge(int32_t place, const std::vector<WeldingMesh::Edge>& edges, const BoxTree& tree) const {
    Junction best;
    best.place = place;
    tree.AnyMeeting(BoxAround(place, tolerance_), [&](int32_t i) {
      const auto [a, b] = mesh_.EndsOf(edges[i]);
      if (a == place || b == place || refused_.contains({place, a, b})) return false;
      const Point3 &p = mesh_.PositionOf(place), &from = mesh_.PositionOf(a), way = mesh_.PositionOf(b) - from;
      const double along = (p - from).dot(way), squared = way.squaredNorm();
      const double distance = DistanceToSegment(p, from, mesh_.PositionOf(b));
      const double reach = std::min(tolerance_, kBeside * std::min(std::sqrt(squared), shortest_.at(place)));
      if (!(along > 0 && along < squared && distance <= reach)) return false;
      const Junction found{distance, std::abs(along / squared - 0.5), place, static_cast<size_t>(i)};
      if (found < best) best = found;
      return false;
    });
    return best;
  }

  // Of each edge the nearest place beside it.
  std::map<size_t, Junction> FindJunctions(const std::vector<WeldingMesh::Edge>& edges) const {
    std::vector<AlignedBox3d> boxes;
    std::set<int32_t> places;
    for (const WeldingMesh::Edge& e : edges) {
      const auto [a, b] = mesh_.EndsOf(e);
      AlignedBox3d box(mesh_.PositionOf(a));
      boxes.push_back(box.extend(mesh_.PositionOf(b)));
      places.insert({a, b});
    }
    const BoxTree tree(boxes);
    std::map<size_t, Junction> junctions;
    for (const int32_t place : places) {
      const Junction found = NearestEdge(place, edges, tree);
      if (found.distance > tolerance_) continue;
      const auto [it, fresh] = junctions.try_emplace(found.edge, found);
      if (!fresh && found < it->second) it->second = found;
    }
    return junctions;
  }

  // Each round splits every edge once at most. They end: a place that has split an edge, or was refused there, lies
  // beside none of its parts.
  void SplitEdges() {
    while (true) {
      const std::vector<WeldingMesh::Edge> edges = mesh_.OpenEdges();
      const std::map<size_t, Junction> junctions = FindJunctions(edges);
      if (junctions.empty()) return;
      std::set<int32_t> touched;  // triangles: their edges are others now
      for (const auto& [e, junction] : junctions) {
        if (touched.insert(edges[e].triangle).second) SplitAt(edges[e], junction);
      }
    }
  }

  void SplitAt(const WeldingMesh::Edge& edge, const Junction& junction) {
    const auto [a, b] = mesh_.EndsOf(edge);
    const int32_t vertex = mesh_.VertexAt(junction.place), from = mesh_.VertexAt(a), to = mesh_.VertexAt(b);
    const char* fault = may_split_ ? mesh_.SplitFault(edge, junction.place) : "its face has texture coordinates";
    if (fault == nullptr) {
      mesh_.Split(edge, junction.place);
      record_.split.push_back({vertex, {from, to}, junction.distance});
    } else {
      refused_.insert({junction.place, a, b});
      record_.refused.push_back({{vertex, from, to}, junction.distance, fault});
    }
  }

  const double tolerance_;
  const bool may_split_;
  WeldingMesh mesh_;
  std::map<int32_t, double> reach_, shortest_;               // by place
  std::set<std::tuple<int32_t, int32_t, int32_t>> refused_;  // a place, and the ends of an edge
  WeldRecord record_;
};

}  // namespace

Weld WeldRims(const TriMesh& mesh, std::span<const int32_t> face_of, double tolerance, bool may_split) {
  return Welder(mesh, SurveyTile(mesh, false), face_of, tolerance, may_split).Run();
}

}  // namespace tilemend
