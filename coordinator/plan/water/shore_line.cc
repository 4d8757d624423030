#include "coordinator/plan/water/shore_line.h"

#include <algorithm>
#include <map>
#include <utility>

#include "common/mesh/disjoint_sets.h"
#include "coordinator/plan/water/hole_groups.h"

namespace tilemend {
namespace {

class ShoreLineBuilder {
 public:
  explicit ShoreLineBuilder(const Plan& plan) : plan_(plan) {}

  void Add(const RimSegment& s) {
    if (s.seam) return;
    const int32_t from = Take(s.from);
    line_.edges.push_back({from, Take(s.to)});
  }
  ShoreLine Line() && { return std::move(line_); }

 private:
  int32_t Take(int32_t v) {
    const auto [it, fresh] = number_.try_emplace(v, static_cast<int32_t>(line_.points.size()));
    if (fresh) {
      const PlanVertex& vertex = plan_.vertices[v];
      line_.points.push_back(vertex.position);
      line_.kinds.push_back(vertex.index >= 0 && !vertex.on_object ? ShorePoint::kGround : ShorePoint::kOther);
      line_.vertices.push_back(v);
    }
    return it->second;
  }

  const Plan& plan_;
  std::map<int32_t, int32_t> number_;  // of vertices of the plan
  ShoreLine line_;
};

}  // namespace

ShoreLine ShoreLineOf(const Plan& plan, const std::vector<int32_t>& holes) {
  ShoreLineBuilder builder(plan);
  for (const int32_t h : holes) {
    for (const RimSegment& s : plan.holes[h].segments) builder.Add(s);
  }
  return std::move(builder).Line();
}

ShoreLine WholeShoreLineOf(const Plan& plan, const std::vector<int32_t>& holes) {
  ShoreLineBuilder builder(plan);
  for (const int32_t h : holes) ForRimSegments(plan.holes[h], [&](const RimSegment& s) { builder.Add(s); });
  return std::move(builder).Line();
}

std::vector<std::vector<int32_t>> GroundBesideObjects(std::span<const Point3> points, std::span<const ShorePoint> kinds,
                                                      std::span<const DirectedEdge> edges) {
  const auto is_ground = [&](int32_t v) { return kinds[v] == ShorePoint::kGround; };
  DisjointSets objects(static_cast<int32_t>(points.size()));
  for (const DirectedEdge& e : edges) {
    if (!is_ground(e.from) && !is_ground(e.to)) objects.Join(e.from, e.to);
  }
  std::map<int32_t, std::vector<int32_t>> beside;
  for (const DirectedEdge& e : edges) {
    if (is_ground(e.from) == is_ground(e.to)) continue;
    beside[objects.LowestOf(is_ground(e.from) ? e.to : e.from)].push_back(is_ground(e.from) ? e.from : e.to);
  }
  std::vector<std::vector<int32_t>> result;
  for (auto& [object, ground] : beside) {
    std::sort(ground.begin(), ground.end(),
              [&](int32_t a, int32_t b) { return std::pair(points[a].z(), a) < std::pair(points[b].z(), b); });
    ground.erase(std::unique(ground.begin(), ground.end()), ground.end());
    result.push_back(std::move(ground));
  }
  return result;
}

std::vector<GroundLink> LinkGround(std::span<const ShorePoint> kinds, std::span<const DirectedEdge> edges,
                                   const std::vector<std::vector<int32_t>>& beside_objects) {
  std::vector<GroundLink> links;
  for (const DirectedEdge& e : edges) {
    const bool both = kinds[e.from] == ShorePoint::kGround && kinds[e.to] == ShorePoint::kGround;
    if (both) links.push_back({e.from, e.to, false});
  }
  for (const std::vector<int32_t>& ground : beside_objects) {
    for (size_t i = 1; i < ground.size(); ++i) links.push_back({ground[0], ground[i], true});
  }
  return links;
}

}  // namespace tilemend
