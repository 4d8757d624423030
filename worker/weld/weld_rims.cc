#include "worker/weld/weld_rims.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <tuple>
#include <unordered_map>
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
  Welder(const MeshView& mesh, const SurveyRecord& record, std::span<const int32_t> face_of, double tolerance,
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
    const std::span<const int32_t> cut_from = mesh_.CutFrom();
    weld.cut_from.assign(cut_from.begin(), cut_from.end());
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
    const Point3 p = mesh_.PositionOf(place), r = Point3::Constant(reach);
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

  // Where edges that were open at one time lie, and between which places.
  struct EdgeLayer {
    struct Item {
      WeldingMesh::Edge edge;
      int32_t a, b;
    };
    std::vector<Item> items;
    BoxTree tree;
  };

  struct Junction {
    double distance = std::numeric_limits<double>::infinity();
    double off_middle = 0;  // of the edge, in shares of its length
    int32_t place = -1;
    WeldingMesh::Edge edge = {};

    // Of places as near the one in the middle goes first: many on one edge halve it again and again.
    bool operator<(const Junction& other) const {
      return std::tie(distance, off_middle) < std::tie(other.distance, other.off_middle);
    }
  };

  EdgeLayer LayerOf(const std::vector<WeldingMesh::Edge>& edges) const {
    EdgeLayer layer;
    std::vector<AlignedBox3d> boxes;
    for (const WeldingMesh::Edge& edge : edges) {
      const auto [a, b] = mesh_.EndsOf(edge);
      layer.items.push_back({edge, a, b});
      boxes.push_back(AlignedBox3d(mesh_.PositionOf(a)).extend(mesh_.PositionOf(b)));
    }
    layer.tree = BoxTree(boxes);
    return layer;
  }

  // Of a place and an edge that it lies beside; at an infinite distance else.
  Junction JunctionAt(int32_t place, const EdgeLayer::Item& item) const {
    const Point3 p = mesh_.PositionOf(place), from = mesh_.PositionOf(item.a);
    const Eigen::Vector3d way = mesh_.PositionOf(item.b) - from;
    const double along = (p - from).dot(way), squared = way.squaredNorm();
    const double distance = DistanceToSegment(p, from, mesh_.PositionOf(item.b));
    const bool beside = along > 0 && along < squared && distance <= kBeside * std::sqrt(squared);
    return beside ? Junction{distance, std::abs(along / squared - 0.5), place, item.edge} : Junction();
  }

  // How far off edges are that a place may lie beside.
  double ReachToEdges(int32_t place) const { return std::min(tolerance_, kBeside * shortest_.at(place)); }

  // With the nearest edge that a place lies beside, of those that are open and were not refused to it.
  Junction NearestEdge(int32_t place, const std::vector<EdgeLayer>& layers) const {
    Junction best;
    const double reach = ReachToEdges(place);
    for (const EdgeLayer& layer : layers) {
      layer.tree.AnyMeeting(BoxAround(place, reach), [&](int32_t i) {
        const EdgeLayer::Item& item = layer.items[i];
        if (item.a == place || item.b == place) return false;
        const Junction found = JunctionAt(place, item);
        if (!(found.distance <= reach && found < best) || refused_.contains({place, item.a, item.b})) return false;
        if (mesh_.EndsOf(item.edge) == std::pair(item.a, item.b) && mesh_.IsOpen(item.edge)) best = found;
        return false;
      });
    }
    return best;
  }

  using Junctions = std::map<std::pair<int32_t, int>, Junction>;  // by triangle and corner of the edge

  // Of each edge the nearest of the places beside it. Leaves those places alone that lie beside an edge.
  Junctions FindJunctions(std::set<int32_t>& places, const std::vector<EdgeLayer>& layers) const {
    Junctions junctions;
    std::erase_if(places, [&](int32_t place) {
      const Junction found = mesh_.IsAtOpenEdge(place) ? NearestEdge(place, layers) : Junction();
      if (found.place < 0) return true;
      const auto [it, fresh] = junctions.try_emplace({found.edge.triangle, found.edge.corner}, found);
      if (!fresh && found < it->second) it->second = found;
      return false;
    });
    return junctions;
  }

  // Each round splits every edge once at most. They end: a place that has split an edge, or was refused there, lies
  // beside none of its parts. After the first, only places beside edges as they were, or near new ones, are looked at.
  void SplitEdges() {
    std::set<int32_t> places;
    for (const int32_t p : mesh_.boundary()) places.insert(mesh_.StaysAs(p));
    const std::vector<int32_t> all(places.begin(), places.end());
    std::vector<AlignedBox3d> boxes;
    for (const int32_t p : all) boxes.push_back(BoxAround(p, ReachToEdges(p)));
    const BoxTree near(boxes);
    std::vector<EdgeLayer> layers = {LayerOf(mesh_.OpenEdges())};
    for (Junctions junctions = FindJunctions(places, layers); !junctions.empty();
         junctions = FindJunctions(places, layers)) {
      layers.push_back(LayerOf(SplitAll(junctions)));
      for (const EdgeLayer::Item& item : layers.back().items) {
        near.AnyMeeting(AlignedBox3d(mesh_.PositionOf(item.a)).extend(mesh_.PositionOf(item.b)), [&](int32_t i) {
          places.insert(all[i]);
          return false;
        });
      }
    }
  }

  // Splits each edge whose triangle was not split before. The open edges of the halves.
  std::vector<WeldingMesh::Edge> SplitAll(const Junctions& junctions) {
    std::set<int32_t> touched;  // triangles: their edges are others now
    const auto first_new = static_cast<int32_t>(mesh_.triangles().size());
    for (const auto& [key, junction] : junctions) {
      if (touched.insert(key.first).second) SplitAt(junction.edge, junction);
    }
    for (int32_t t = first_new; t < std::ssize(mesh_.triangles()); ++t) touched.insert(t);
    std::vector<WeldingMesh::Edge> open;
    for (const int32_t t : touched) {
      for (int k = 0; k < 3; ++k) {
        if (mesh_.IsOpen({t, k})) open.push_back({t, k});
      }
    }
    return open;
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
  std::unordered_map<int32_t, double> reach_, shortest_;     // by place
  std::set<std::tuple<int32_t, int32_t, int32_t>> refused_;  // a place, and the ends of an edge
  WeldRecord record_;
};

}  // namespace

Weld WeldRims(const MeshView& mesh, std::span<const int32_t> face_of, double tolerance, bool may_split) {
  return Welder(mesh, SurveyTile(mesh, false), face_of, tolerance, may_split).Run();
}

}  // namespace tilemend
