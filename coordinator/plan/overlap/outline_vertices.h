// New vertices on the outline of a tile that reaches over its grid lines.
#ifndef TILEMEND_COORDINATOR_PLAN_OVERLAP_OUTLINE_VERTICES_H_
#define TILEMEND_COORDINATOR_PLAN_OVERLAP_OUTLINE_VERTICES_H_

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "coordinator/plan/overlap/outline_walk.h"
#include "coordinator/plan/types/cell_side.h"
#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// A vertex of the plan on a grid line, level with a place on the tile's own outline.
struct VertexOnLine {
  double place = 0;
  int32_t vertex = 0;
  std::vector<Side> sides;
  bool on_rim = false;  // the neighbour's surface bounds the hole there
};

// New vertices on a tile's outline, with the surface of vertices on the grid lines that they follow.
class OutlineVertices {
 public:
  OutlineVertices(CellId cell, const Outline& outline, Plan& plan) : cell_(cell), outline_(outline), plan_(plan) {}

  // Level with one on a grid line, or two; always the same one.
  int32_t Beside(const VertexOnLine& line) {
    const auto [it, fresh] = beside_.try_emplace(line.vertex, 0);
    if (!fresh) return it->second;
    Point3 position = plan_.vertices[line.vertex].position;
    uint8_t lines = 0;
    for (const Side s : line.sides) {
      position[AxisOf(s)] = outline_.side[s];
      lines |= LineOf(s);
    }
    it->second = Add(line.vertex, position, lines);
    plan_.vertices[it->second].on_neighbour = line.on_rim;
    return it->second;
  }

  int32_t AtCorner(int corner, int32_t source) {
    const Point2 at = outline_.CornerAt(corner);
    return Add(source, {at.x(), at.y(), plan_.vertices[source].position.z()}, 3);
  }

  // At the place where the way from a chain that ends off the outline, at that of a piece, comes to it.
  std::optional<int32_t> Ahead(int32_t end, double place, int32_t source) {
    const Point3& from = plan_.vertices[end].position;
    if (outline_.SideAt(from)) return std::nullopt;
    const auto [at, side] = outline_.At(place);
    return Add(source, {at.x(), at.y(), from.z()}, LineOf(side));
  }

 private:
  static uint8_t LineOf(Side side) { return AxisOf(side) == 0 ? 1 : 2; }

  int32_t Add(int32_t source, const Point3& position, uint8_t lines) {
    PlanVertex v = plan_.vertices[source];
    v.tile = cell_;
    v.index = -1;
    v.follows = source;
    v.position = position;
    v.lines = lines;
    plan_.vertices.push_back(v);
    return static_cast<int32_t>(plan_.vertices.size()) - 1;
  }

  const CellId cell_;
  const Outline& outline_;
  Plan& plan_;
  std::unordered_map<int32_t, int32_t> beside_;  // plan vertex on a grid line -> on the outline
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_OVERLAP_OUTLINE_VERTICES_H_
