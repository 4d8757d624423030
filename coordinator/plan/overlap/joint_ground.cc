#include "coordinator/plan/overlap/joint_ground.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace tilemend {
namespace {

struct VertexGround {
  bool on_object = false;
  float ground = std::numeric_limits<float>::quiet_NaN();
};

VertexGround Of(const RimGround& rim, int32_t v) {
  if (v >= std::ssize(rim.on_object)) return {};  // a vertex of the area's edge
  return {rim.on_object[v], rim.ground[v]};
}

// At a place on an edge, and how far the edge passes above or below it.
struct OnEdge {
  VertexGround value;
  double off = std::numeric_limits<double>::infinity();
};

OnEdge At(const Point3& place, const SurveyRecord& own, const BoundaryEdge& edge, const RimGround& rim) {
  const Point3 &from = own.vertices[edge.from].position, &to = own.vertices[edge.to].position;
  const Point2 way = (to - from).head<2>();
  const double length = way.squaredNorm();
  const double share = length > 0 ? std::clamp((place - from).head<2>().dot(way) / length, 0.0, 1.0) : 0;
  const VertexGround a = Of(rim, edge.from), b = Of(rim, edge.to);
  OnEdge result{share < 0.5 ? a : b, std::abs(from.z() + share * (to.z() - from.z()) - place.z())};
  if (!std::isnan(a.ground) && !std::isnan(b.ground)) {
    result.value.ground = static_cast<float>(a.ground + share * (b.ground - a.ground));
  } else if (std::isnan(result.value.ground)) {
    result.value.ground = std::isnan(a.ground) ? b.ground : a.ground;
  }
  return result;
}

using Values = std::vector<std::optional<VertexGround>>;  // none: no edge of the tile's own passes

Values OnOwnEdges(const SurveyRecord& record, const SurveyRecord& own, const std::vector<std::vector<int32_t>>& through,
                  const RimGround& rim) {
  Values values;
  for (size_t v = 0; v < own.vertices.size(); ++v) values.emplace_back(Of(rim, static_cast<int32_t>(v)));
  for (size_t v = own.vertices.size(); v < record.vertices.size(); ++v) {
    std::optional<OnEdge> best;
    for (const int32_t e : through[v - own.vertices.size()]) {
      const OnEdge here = At(record.vertices[v].position, own, own.edges[e], rim);
      if (!best || here.off < best->off) best = here;
    }
    values.push_back(best ? std::optional(best->value) : std::nullopt);
  }
  return values;
}

// Where two outlines meet on a grid line: what the vertex before or after it along the boundary has, the nearer one.
Values WithNeighbours(const SurveyRecord& record, const Values& values) {
  Values result = values;
  std::vector<double> nearest(values.size(), std::numeric_limits<double>::infinity());
  for (const BoundaryEdge& e : record.edges) {
    const double length = (record.vertices[e.to].position - record.vertices[e.from].position).head<2>().squaredNorm();
    for (const auto& [v, other] : {std::pair(e.from, e.to), std::pair(e.to, e.from)}) {
      if (values[v] || !values[other] || !(length < nearest[v])) continue;
      nearest[v] = length;
      result[v] = values[other];
    }
  }
  return result;
}

}  // namespace

std::map<CellId, RimGround> JointGround(const JointTiles& joint, const std::map<CellId, RimGround>& rim_ground) {
  std::map<CellId, RimGround> result;
  for (const auto& [cell, record] : joint.records) {
    const auto known = rim_ground.find(cell);
    if (known == rim_ground.end() || !joint.own.contains(cell)) continue;
    const SurveyRecord& own = *joint.own.at(cell);
    const auto& through = joint.edges_through.at(cell);
    RimGround& rim = result[cell];
    for (const auto& value : WithNeighbours(record, OnOwnEdges(record, own, through, known->second))) {
      rim.on_object.push_back(value.value_or(VertexGround()).on_object);
      rim.ground.push_back(value.value_or(VertexGround()).ground);
    }
  }
  return result;
}

}  // namespace tilemend
