#include "coordinator/plan/overlap/joint_ground.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
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

VertexGround OfNearest(const Point3& place, const SurveyRecord& own, const RimGround& rim) {
  const auto distance = [&](const BoundaryVertex& v) { return (v.position - place).head<2>().squaredNorm(); };
  const auto nearest = std::ranges::min_element(own.vertices, {}, distance);
  return nearest == own.vertices.end() ? VertexGround() : Of(rim, static_cast<int32_t>(nearest - own.vertices.begin()));
}

// Of a new vertex, which these edges pass.
VertexGround OfNew(const Point3& place, const SurveyRecord& own, const std::vector<int32_t>& through,
                   const RimGround& rim) {
  if (through.empty()) return OfNearest(place, own, rim);
  OnEdge best;
  for (const int32_t e : through) {
    const OnEdge here = At(place, own, own.edges[e], rim);
    if (here.off < best.off) best = here;
  }
  return best.value;
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
    rim.side = known->second.side;
    rim.around = known->second.around;
    for (size_t v = 0; v < record.vertices.size(); ++v) {
      const bool is_new = v >= own.vertices.size();
      const VertexGround value =
          is_new ? OfNew(record.vertices[v].position, own, through[v - own.vertices.size()], known->second)
                 : Of(known->second, static_cast<int32_t>(v));
      rim.on_object.push_back(value.on_object);
      rim.ground.push_back(value.ground);
    }
  }
  return result;
}

}  // namespace tilemend
