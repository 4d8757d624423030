#include "coordinator/plan/overlap/merge_parts.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "common/mesh/disjoint_sets.h"
#include "coordinator/plan/hole/hole_types.h"

namespace tilemend {
namespace {

class Merger {
 public:
  Merger(const PlanInput& input, const TileParts& parts, Plan& plan) : input_(input), parts_(parts), plan_(plan) {
    for (const auto& [cell, record] : input.cells) {
      const CellId low{cell.col * parts.columns, cell.row * parts.rows};
      const CellId high{low.col + parts.columns - 1, low.row + parts.rows - 1};
      lines_.coordinate[{cell, kWest}] = parts.line.at({low, kWest});
      lines_.coordinate[{cell, kSouth}] = parts.line.at({low, kSouth});
      lines_.coordinate[{cell, kEast}] = parts.line.at({high, kEast});
      lines_.coordinate[{cell, kNorth}] = parts.line.at({high, kNorth});
    }
    for (const PlanVertex& v : plan.vertices) position_.push_back(v.position);
  }

  void Run() {
    MergeHoles();
    for (PlanVertex& v : plan_.vertices) v.tile = parts_.TileOf(v.tile);
    for (Seam& seam : plan_.seams) seam.a = parts_.TileOf(seam.a), seam.b = parts_.TileOf(seam.b);
    for (LeftOpen& left : plan_.left) left.cell = parts_.TileOf(left.cell);
    MergeVertices();
  }

 private:
  void MergeHoles() {
    const std::vector<int32_t> group = Groups();
    std::vector<PlannedHole> merged;
    std::vector<int32_t> count;
    for (size_t h = 0; h < group.size(); ++h) {
      PlannedHole& hole = plan_.holes[h];
      if (group[h] == static_cast<int32_t>(merged.size())) {
        hole.cell = parts_.TileOf(hole.cell);
        merged.push_back(std::move(hole));
        count.push_back(1);
      } else {
        Add(hole, merged[group[h]]);
        ++count[group[h]];
      }
    }
    for (size_t g = 0; g < merged.size(); ++g) {
      merged[g].centre /= count[g];
      if (merged[g].kind != HoleKind::kClosed) Classify(merged[g]);
    }
    std::stable_sort(merged.begin(), merged.end(),
                     [](const PlannedHole& a, const PlannedHole& b) { return a.cell < b.cell; });
    plan_.holes = std::move(merged);
  }

  // Holes of one tile with a seam between them are one.
  std::vector<int32_t> Groups() const {
    DisjointSets sets(static_cast<int32_t>(plan_.holes.size()));
    std::map<std::pair<int32_t, int32_t>, int32_t> hole_of;
    for (size_t h = 0; h < plan_.holes.size(); ++h) {
      if (!plan_.holes[h].failure.empty()) continue;
      const auto number = static_cast<int32_t>(h);
      for (const RimSegment& s : plan_.holes[h].segments) {
        if (!s.seam) continue;
        hole_of[{s.from, s.to}] = number;
        const auto other = hole_of.find({s.to, s.from});
        if (other == hole_of.end()) continue;
        if (parts_.TileOf(plan_.holes[other->second].cell) == parts_.TileOf(plan_.holes[h].cell)) {
          sets.Join(number, other->second);
        }
      }
    }
    return sets.Groups();
  }

  static void Add(PlannedHole& part, PlannedHole& hole) {
    hole.centre += part.centre;
    hole.area += part.area;
    hole.perimeter += part.perimeter;
    hole.boundary_vertices += part.boundary_vertices;
    hole.projects &= part.projects;
    if (part.kind == HoleKind::kOpenII) hole.kind = HoleKind::kOpenII;
    hole.segments.insert(hole.segments.end(), part.segments.begin(), part.segments.end());
    std::move(part.own_regions.begin(), part.own_regions.end(), std::back_inserter(hole.own_regions));
  }

  // By the tile's own sides. A hole that reaches none of them is closed.
  void Classify(PlannedHole& hole) const {
    std::vector<BoundarySegment> boundary;
    bool open = false;
    for (const RimSegment& s : hole.segments) {
      BoundarySegment b{s, -1, {}};
      for (const Side side : kSides) {
        const double line = lines_.At(hole.cell, side);
        if (position_[s.from][AxisOf(side)] != line || position_[s.to][AxisOf(side)] != line) continue;
        b.side = side;
        b.across = Across(hole.cell, side);
        open = true;
      }
      boundary.push_back(b);
    }
    if (!open) {
      hole.kind = HoleKind::kClosed;
      hole.type = HoleType::kNone;
      hole.single = SingleType::kSimple;
      return;
    }
    const SurveyRecord* record = input_.cells.at(hole.cell);
    const bool has_surface = record != nullptr && record->triangle_count > 0;
    hole.type = ClassifyOpen(boundary, hole.cell, has_surface, lines_, position_);
  }

  void MergeVertices() {
    std::map<CellId, std::vector<int32_t>> of_tiles;
    for (const auto& [part, vertices] : plan_.vertex_of_boundary) {
      const CellId cell = parts_.TileOf(part);
      std::vector<int32_t>& of_tile = of_tiles[cell];
      of_tile.resize(input_.cells.at(cell)->vertices.size(), -1);
      const std::vector<int32_t>& vertex_of = parts_.vertex_of.at(part);
      for (size_t v = 0; v < vertices.size(); ++v) of_tile[vertex_of[v]] = vertices[v];
    }
    plan_.vertex_of_boundary = std::move(of_tiles);
  }

  const PlanInput& input_;
  const TileParts& parts_;
  Plan& plan_;
  GridLines lines_;  // of the tiles
  std::vector<Point3> position_;
};

}  // namespace

void MergeParts(const PlanInput& input, const TileParts& parts, Plan& plan) {
  if (!parts.whole()) Merger(input, parts, plan).Run();
}

}  // namespace tilemend
