#include "coordinator/plan/make_cell_holes.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <unordered_map>

#include "common/mesh/position_index.h"
#include "common/mesh/rounding.h"
#include "coordinator/plan/overlap/reached_holes.h"

namespace tilemend {
namespace {

constexpr double kBandStep = 0x1p-10;  // metres: bands are coded so
// By which a point of a band, rounded to that or to a place in 2^28 of their extent, may be off what it stands for.
constexpr double kBandSlack = 4 * kBandStep, kBandSlackShare = 0x1p-26;

bool HasSeam(const std::vector<RimSegment>& segments) {
  return std::any_of(segments.begin(), segments.end(), [](const RimSegment& s) { return s.seam; });
}

// Where the other tiles have triangles.
std::vector<Eigen::AlignedBox3d> PlacesOfOthers(const PlanInput& input, CellId tile, const std::set<CellId>& around) {
  std::vector<Eigen::AlignedBox3d> places;
  for (const CellId cell : around) {
    const auto other = input.cells.find(cell);
    if (cell == tile || other == input.cells.end()) continue;
    const StoredRecord& record = other->second;
    if (record == nullptr || record->vertex_count == 0) continue;
    const Point3 slack = Point3::Constant(kBandSlack) + kBandSlackShare * (record->hi - record->lo);
    places.emplace_back(record->lo - slack, record->hi + slack);
  }
  return places;
}

// A vertex of the result, and the cluster that it was first made for.
struct Made {
  int32_t vertex, cluster;
};

std::set<CellId> CellsAround(const Plan& plan, const std::vector<int32_t>& holes) {
  std::set<CellId> cells;
  for (const int32_t h : holes) {
    const CellId c = plan.holes[h].cell;
    for (int dr = -1; dr <= 1; ++dr) {
      for (int dc = -1; dc <= 1; ++dc) cells.insert({c.col + dc, c.row + dr});
    }
  }
  return cells;
}

// The height at a place of a surface that is known at a vertex.
double GoingOn(const Plan& plan, const GroundSurface& surface, int32_t source, const Point3& at) {
  return surface.height + surface.slope.dot((at - plan.vertices[source].position).head<2>());
}

// Where the surface passes, of an original that it need not meet. Beyond the grid line the surface goes on from where
// the boundary crosses it.
std::optional<double> GroundUnder(const Plan& plan, const SeamHeights& heights, int32_t plan_vertex, int32_t cluster) {
  const auto ground = heights.ground.find({cluster, plan_vertex});
  if (ground != heights.ground.end()) return ground->second.height;
  const PlanVertex& p = plan.vertices[plan_vertex];
  if (p.ground) return *p.ground;
  if (p.follows < 0) return std::nullopt;
  const auto beside = heights.ground.find({cluster, p.follows});
  if (beside != heights.ground.end()) return GoingOn(plan, beside->second, p.follows, p.position);
  const auto height = heights.height.find(p.follows);
  const auto slope = heights.slope.find(p.follows);
  if (height == heights.height.end() || slope == heights.slope.end()) return plan.vertices[p.follows].ground;
  return GoingOn(plan, {height->second, slope->second.slope}, p.follows, p.position);
}

// Of a seam vertex, if it is settled. Off the grid line the surface goes on with its slope.
std::optional<double> HeightOf(const Plan& plan, const SeamHeights& heights, int32_t plan_vertex, int32_t cluster) {
  const PlanVertex& p = plan.vertices[plan_vertex];
  const int32_t source = p.follows >= 0 ? p.follows : plan_vertex;
  const PlanVertex& s = plan.vertices[source];
  if (p.on_neighbour && p.on_object) return s.position.z();
  if (const auto own = heights.height.find(plan_vertex); own != heights.height.end()) return own->second;
  // Where the neighbour has surface the fill ends at its vertex, also if the surface of the cluster passes elsewhere.
  if (p.on_neighbour && s.index >= 0) return s.position.z();
  if (const auto ground = heights.ground.find({cluster, source}); ground != heights.ground.end()) {
    return RoundedToLattice(GoingOn(plan, ground->second, source, p.position), plan.lattice_step);
  }
  if (s.index >= 0 || s.height_known) return s.position.z();
  const auto height = heights.height.find(source);
  if (height == heights.height.end()) return std::nullopt;
  const auto slope = heights.slope.find(source);
  const GroundSurface surface{height->second, slope == heights.slope.end() ? Point2(0, 0) : slope->second.slope};
  return RoundedToLattice(GoingOn(plan, surface, source, p.position), plan.lattice_step);
}

class CellHolesBuilder {
 public:
  CellHolesBuilder(const Plan& plan, const PlanInput& input, const SeamHeights& heights)
      : plan_(plan), input_(input), heights_(heights) {}

  CellHoles Build(const std::vector<int32_t>& holes, bool with_band, bool own_regions) {
    result_.cell = plan_.holes[holes.front()].cell;
    result_.lattice_step = plan_.lattice_step;
    result_.upright = plan_.upright;
    result_.float32 = NumberTypeOf(result_.cell);
    IndexOwnVertices();
    for (const int32_t h : holes) {
      const auto& regions = plan_.holes[h].own_regions;
      if (!own_regions || regions.empty()) {
        AddHole(h, plan_.holes[h].segments);
      } else {
        for (const std::vector<RimSegment>& region : regions) {
          AddHole(h, region);
          result_.holes.back().own_outline = true;
        }
        AddInnerEdges(plan_.holes[h]);
      }
    }
    // Between objects the surface need not meet the rim: its height is asked for everywhere.
    if (!own_regions && std::ranges::any_of(result_.vertices, &RimVertex::on_object)) {
      for (const auto& [plan_vertex, made] : made_) result_.vertices[made.vertex].seam_vertex = plan_vertex;
    }
    if (with_band && !own_regions) AddPlaces(holes);
    if (with_band) {
      for (const RimVertex& v : result_.vertices) result_.band.points.push_back(v.position);
      const std::set<CellId> around = CellsAround(plan_, holes);
      for (const CellId tile : around) AddBand(tile, PlacesOfOthers(input_, tile, around));
    }
    return std::move(result_);
  }

 private:
  StoredRecord RecordOf(CellId cell) const {
    const auto it = input_.cells.find(cell);
    return it == input_.cells.end() ? StoredRecord() : it->second;
  }

  // A cell without a tile takes the number type of the scene.
  bool NumberTypeOf(CellId cell) const {
    const StoredRecord own = RecordOf(cell);
    return own != nullptr ? own->float32 : plan_.float32;
  }

  void IndexOwnVertices() {
    const StoredRecord stored = RecordOf(result_.cell);
    if (stored == nullptr) return;
    const auto own = stored.Outline();
    const std::span<const int32_t> of = VerticesOf(plan_, result_.cell);
    for (size_t i = 0; i < of.size(); ++i)
      if (of[i] >= 0) own_index_.emplace(of[i], own->vertices[i].index);
  }

  int32_t Vertex(int32_t plan_vertex, int32_t cluster) {
    const auto number = static_cast<int32_t>(result_.vertices.size());
    const auto [it, fresh] = made_.try_emplace(plan_vertex, Made{number, cluster});
    if (!fresh) {
      // Of two clusters that touch here, each has its own surface.
      RimVertex& shared = result_.vertices[it->second.vertex];
      if (!shared.on_object && it->second.cluster != cluster) shared.ground.reset();
      return it->second.vertex;
    }
    const PlanVertex& p = plan_.vertices[plan_vertex];
    RimVertex v;
    v.tile = p.tile;
    v.index = p.index;
    v.position = p.position;
    v.centroid_height = p.centroid_height;
    v.size = p.size;
    v.lines = p.lines;
    v.on_object = p.on_object;
    v.on_ground = p.on_ground;
    if (const auto own = own_index_.find(plan_vertex); own != own_index_.end()) {
      v.tile = result_.cell;
      v.index = own->second;
    }
    if (p.on_object) v.seam_vertex = plan_vertex;
    if (p.on_object || (p.index >= 0 && heights_.walls.contains(cluster))) {
      v.ground = GroundUnder(plan_, heights_, plan_vertex, cluster);
    }
    if (p.index < 0) {
      v.seam_vertex = plan_vertex;
      const std::optional<double> height = HeightOf(plan_, heights_, plan_vertex, cluster);
      v.height_known = height.has_value();
      if (height) v.position.z() = *height;
      if (!heights_.height.contains(plan_vertex)) v.follows = p.follows;
    }
    result_.vertices.push_back(v);
    return number;
  }

  void AddHole(int32_t h, const std::vector<RimSegment>& segments) {
    const PlannedHole& planned = plan_.holes[h];
    CellHole hole;
    hole.id = h;
    hole.open = planned.kind != HoleKind::kClosed || (!planned.own_regions.empty() && HasSeam(segments));
    if (const auto it = heights_.tension.find(planned.cluster); it != heights_.tension.end()) hole.tension = it->second;
    if (const auto it = heights_.walls.find(planned.cluster); it != heights_.walls.end()) hole.walls = it->second;
    hole.slope = planned.slope;
    hole.in_ground = planned.standing == Standing::kInGround;
    if (planned.water >= 0) {
      hole.level = plan_.water[planned.water].level;
      hole.river = plan_.water[planned.water].river;
    }
    for (const RimSegment& s : segments) {
      const int32_t from = Vertex(s.from, planned.cluster);
      const int32_t to = Vertex(s.to, planned.cluster);
      hole.segments.push_back({from, to, s.seam});
      if (!s.seam) continue;
      SetSeamVertex(result_.vertices[from], planned.cluster, s.from);
      SetSeamVertex(result_.vertices[to], planned.cluster, s.to);
    }
    result_.holes.push_back(std::move(hole));
  }

  // Vertices without a segment, where the surface of the cluster is asked for.
  void AddPlaces(const std::vector<int32_t>& holes) {
    for (const int32_t h : holes) {
      const PlannedHole& planned = plan_.holes[h];
      const auto add = [&](const std::vector<RimSegment>& segments) {
        for (const RimSegment& s : segments) {
          for (const int32_t v : {s.from, s.to}) {
            if (IsFarOff(plan_, v)) Vertex(v, planned.cluster);
          }
        }
      };
      std::ranges::for_each(planned.own_regions, add);
      add(planned.inner_edges);
    }
  }

  void AddInnerEdges(const PlannedHole& planned) {
    for (const RimSegment& s : planned.inner_edges) {
      const int32_t from = Vertex(s.from, planned.cluster), to = Vertex(s.to, planned.cluster);
      SetSeamVertex(result_.vertices[from], planned.cluster, s.from);
      SetSeamVertex(result_.vertices[to], planned.cluster, s.to);
      result_.holes.back().inner_edges.push_back({from, to, true});
    }
  }

  // An original vertex at which seams of several clusters end keeps the Laplacian of the first.
  void SetSeamVertex(RimVertex& v, int32_t cluster, int32_t plan_vertex) const {
    v.seam_vertex = plan_vertex;
    const int32_t follows = plan_.vertices[plan_vertex].follows;
    auto it = heights_.laplacian.find({cluster, plan_vertex});
    if (it == heights_.laplacian.end() && follows >= 0) it = heights_.laplacian.find({cluster, follows});
    if (it == heights_.laplacian.end() || v.laplacian_known) return;
    v.laplacian_known = true;
    v.laplacian = it->second;
  }

  void AddBand(CellId tile, const std::vector<Eigen::AlignedBox3d>& others) {
    const StoredRecord stored = RecordOf(tile);
    if (stored == nullptr) return;
    std::vector<int32_t> rim;  // the result's vertex for each boundary vertex of the tile, or -1
    for (const int32_t v : VerticesOf(plan_, tile)) {
      const auto it = made_.find(v);
      rim.push_back(it == made_.end() ? -1 : it->second.vertex);
    }
    if (std::ranges::all_of(rim, [](int32_t v) { return v < 0; })) return;
    const auto record = stored.WithBand();
    std::vector<int32_t> number = rim;  // band point -> the result's
    number.resize(record->band.points.size(), -1);
    for (const Triangle& t : record->band.triangles) {
      const auto is_rim = [&](int32_t v) { return v < std::ssize(rim) && rim[v] >= 0; };
      if (plan_.upright && std::ranges::none_of(t, is_rim)) continue;
      const auto may_have = [&](const Eigen::AlignedBox3d& other) {
        return std::ranges::all_of(t, [&](int32_t v) { return other.contains(record->band.points[v]); });
      };
      if (std::ranges::any_of(others, may_have) && !IsFirst(tile, record->band, t)) continue;
      Triangle out;
      for (int k = 0; k < 3; ++k) {
        int32_t& own = number[t[k]];
        if (own < 0) {
          own = static_cast<int32_t>(result_.band.points.size());
          result_.band.points.push_back(record->band.points[t[k]]);
        }
        out[k] = own;
      }
      result_.band.triangles.push_back(out);
    }
  }

  // Tiles cut from one mesh with a buffer have some triangles in common.
  bool IsFirst(CellId tile, const TriMesh& band, const Triangle& t) {
    std::array<int32_t, 3> places;
    for (int k = 0; k < 3; ++k)
      places[k] = places_.Insert(RoundedToLattice(band.points[t[k]], std::min(kBandStep, plan_.lattice_step)));
    std::sort(places.begin(), places.end());
    return tile_of_.try_emplace(places, tile).first->second == tile;
  }

  const Plan& plan_;
  const PlanInput& input_;
  const SeamHeights& heights_;
  CellHoles result_;
  PositionIndex places_;                              // of the band's points
  std::map<std::array<int32_t, 3>, CellId> tile_of_;  // of each triangle of the band
  std::unordered_map<int32_t, Made> made_;            // by plan vertex
  std::unordered_map<int32_t, int32_t> own_index_;    // plan vertex -> index in the cell's own tile
};

}  // namespace

CellHoles MakeCellHoles(const Plan& plan, const PlanInput& input, const SeamHeights& heights,
                        const std::vector<int32_t>& holes, bool with_band) {
  return CellHolesBuilder(plan, input, heights).Build(holes, with_band, false);
}

CellHoles MakeFillHoles(const Plan& plan, const PlanInput& input, const SeamHeights& heights,
                        const std::vector<int32_t>& holes, bool with_band) {
  return CellHolesBuilder(plan, input, heights).Build(holes, with_band, true);
}

}  // namespace tilemend
