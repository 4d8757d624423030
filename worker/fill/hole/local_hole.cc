#include "worker/fill/hole/local_hole.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <unordered_map>

#include "common/mesh/rounding.h"

namespace tilemend {
namespace {

using Eigen::Vector3d;

void FindBoundary(LocalHole& hole) {
  for (const RegionSegment& s : hole.segments) hole.boundary.push_back(Undirected(s.from, s.to));
  std::sort(hole.boundary.begin(), hole.boundary.end());
}

// Where no size is given: the mean length of the segments there.
void FindSizes(LocalHole& hole) {
  std::vector<double> sum(hole.vertices.size(), 0), count(hole.vertices.size(), 0);
  for (const RegionSegment& s : hole.segments) {
    for (const int32_t v : {s.from, s.to}) {
      sum[v] += (hole.positions[s.to] - hole.positions[s.from]).norm();
      count[v] += 1;
    }
  }
  for (size_t v = 0; v < hole.vertices.size(); ++v) {
    const double given = hole.vertices[v] >= 0 ? hole.cell->vertices[hole.vertices[v]].size : 0;
    hole.sizes.push_back(given > 0 ? given : sum[v] / count[v]);
  }
}

RimLoop LoopOver(const LocalHole& hole, std::vector<int32_t> vertices) {
  RimLoop loop{std::move(vertices), {}, {}};
  for (int32_t i = 0; i < loop.size(); ++i) {
    loop.positions.push_back(hole.positions[loop.vertices[i]]);
    loop.outside.push_back(hole.NormalBeside(loop.vertices[i], loop.vertices[(i + 1) % loop.size()]));
  }
  return loop;
}

bool HasFold(const LocalHole& hole, int32_t v) {
  if (hole.vertices[v] < 0) return true;
  const std::vector<int32_t>& around = hole.band->At(hole.vertices[v]);
  return std::any_of(around.begin(), around.end(), [&](int32_t t) {
    const Vector3d n = hole.band->Normal(t);
    return n.dot(hole.normals[v]) < kSamePartCosine * n.norm();
  });
}

// A hole in a facade faces sideways, even if it reaches the ground.
bool FacesUp(const Vector3d& area) {
  constexpr double kFacesUp = 0.2;  // cosine; as closed holes of a plan (closed_loops.cc)
  return area.z() > kFacesUp * area.norm();
}

}  // namespace

bool LocalHole::MayJoin(int32_t a, int32_t b) const {
  return a != b && !std::binary_search(boundary.begin(), boundary.end(), Undirected(a, b)) &&
         TrianglesBeside(a, b) == 0;
}

int LocalHole::TrianglesBeside(int32_t a, int32_t b) const {
  return vertices[a] < 0 || vertices[b] < 0 ? 0 : band->CountEdge(vertices[a], vertices[b]);
}

Vector3d LocalHole::NormalBeside(int32_t from, int32_t to) const {
  if (vertices[from] < 0 || vertices[to] < 0) return Vector3d::Zero();
  return band->UnitNormalBeside(vertices[from], vertices[to]);
}

Vector3d LocalHole::VectorArea() const {
  Vector3d sum = Vector3d::Zero();
  for (const RegionSegment& s : segments) {
    sum += (positions[s.from] - positions[0]).cross(positions[s.to] - positions[0]);
  }
  return sum / 2;
}

std::optional<double> LocalHole::WaterLevelAt(const Point2& p) const {
  if (!level || river.stations.empty()) return level;
  return LevelAt(river, p, cell->lattice_step);
}

Point3 LocalHole::Storable(const Point3& p) const {
  return RoundedTo(cell->float32 ? NumberType::kFloat32 : NumberType::kFloat64,
                   RoundedToLattice(p, cell->lattice_step));
}

LocalHole NumberVertices(const CellHoles& cell, const CellBand& band, std::span<const RimSegment> segments,
                         std::span<const RimSegment> inner_edges) {
  LocalHole hole;
  hole.cell = &cell;
  hole.band = &band;
  std::unordered_map<int32_t, int32_t> number;
  const auto local = [&](int32_t v) {
    const auto [it, fresh] = number.try_emplace(v, hole.size());
    if (fresh) {
      hole.vertices.push_back(v);
      hole.positions.push_back(cell.vertices[v].position);
      hole.has_equation.push_back(true);
    }
    return it->second;
  };
  for (const RimSegment& s : segments) {
    const int32_t from = local(s.from), to = local(s.to);
    hole.segments.push_back({from, to});
    if (s.seam) hole.has_equation[from] = hole.has_equation[to] = false;
  }
  for (const RimSegment& s : inner_edges) {
    const int32_t from = local(s.from), to = local(s.to);
    hole.inner_edges.insert(hole.inner_edges.end(), {{from, to}, {to, from}});
    hole.has_equation[from] = hole.has_equation[to] = false;
  }
  FindBoundary(hole);
  FindSizes(hole);
  const auto is_on_object = [&](int32_t v) { return cell.vertices[v].on_object; };
  if (std::ranges::any_of(hole.vertices, is_on_object)) {
    for (const int32_t v : hole.vertices) hole.on_object.push_back(is_on_object(v));
  }
  if (std::ranges::any_of(hole.vertices, [&](int32_t v) { return cell.vertices[v].ground.has_value(); })) {
    for (const int32_t v : hole.vertices) hole.ground.push_back(cell.vertices[v].ground);
  }
  return hole;
}

// An edge that boundaries pass twice has two vertices that they pass twice.
std::vector<VertexPair> FreeEdgesOf(const LocalHole& local, const CellHole& hole) {
  std::vector<VertexPair> edges;
  if (!hole.own_outline) return edges;
  for (size_t i = 0; i < hole.segments.size(); ++i) {
    const RimSegment& s = hole.segments[i];
    const auto [from, to] = local.segments[i];
    const bool is_passed_once = local.band->Passes(s.from) == 1 || local.band->Passes(s.to) == 1;
    if (s.seam && is_passed_once && local.TrianglesBeside(from, to) == 0) edges.push_back(Undirected(from, to));
  }
  std::ranges::sort(edges);
  return edges;
}

LocalHole MakeLocalHole(const CellHoles& cell, const CellBand& band, const CellHole& hole) {
  LocalHole local = NumberVertices(cell, band, hole.segments, hole.inner_edges);
  local.open = hole.open;
  local.slope = hole.slope;
  local.tension = hole.tension;
  local.walls = hole.walls;
  local.level = hole.level;
  local.river = hole.river;
  local.in_ground = hole.in_ground && FacesUp(local.VectorArea());
  local.own_outline = hole.own_outline;
  local.free_edges = FreeEdgesOf(local, hole);
  local.normals.assign(local.vertices.size(), Vector3d::Zero());
  if (hole.open) return local;
  for (std::vector<int32_t>& loop : LoopsOf(local.segments)) local.loops.push_back(LoopOver(local, std::move(loop)));
  std::vector<bool> found(local.vertices.size(), false);
  for (const RimLoop& loop : local.loops) {
    const std::vector<Vector3d> normals = EvenNormals(loop);
    for (int32_t i = 0; i < loop.size(); ++i) {
      if (!found[loop.vertices[i]]) local.normals[loop.vertices[i]] = normals[i];
      found[loop.vertices[i]] = true;
    }
  }
  return local;
}

HolePart MakePart(const LocalHole& hole, std::span<const Point3> new_points, const PartBoundary& boundary) {
  HolePart part;
  LocalHole& local = part.hole;
  local.cell = hole.cell;
  local.band = hole.band;
  std::map<int32_t, int32_t> number;
  std::vector<std::vector<int32_t>> loops;
  for (const std::vector<PartCorner>& corners : boundary) {
    std::vector<int32_t>& loop = loops.emplace_back();
    for (const PartCorner& c : corners) {
      const auto [it, fresh] = number.try_emplace(c.vertex, local.size());
      if (fresh) {
        const bool is_new = c.vertex >= hole.size();
        part.vertices.push_back(c.vertex);
        local.vertices.push_back(is_new ? -1 : hole.vertices[c.vertex]);
        local.positions.push_back(is_new ? new_points[c.vertex - hole.size()] : hole.positions[c.vertex]);
        local.normals.push_back(c.normal);
        local.has_equation.push_back(true);
      }
      if (c.ends_crease) local.has_equation[it->second] = false;
      loop.push_back(it->second);
    }
    for (size_t i = 0; i < loop.size(); ++i) local.segments.push_back({loop[i], loop[(i + 1) % loop.size()]});
  }
  FindBoundary(local);
  FindSizes(local);
  for (std::vector<int32_t>& loop : loops) local.loops.push_back(LoopOver(local, std::move(loop)));
  FreeAtFolds(local);
  return part;
}

void FreeAtFolds(LocalHole& hole) {
  for (int32_t v = 0; v < hole.size(); ++v) {
    if (HasFold(hole, v)) hole.has_equation[v] = false;
  }
}

BandTriangles BandAt(const LocalHole& hole, const std::vector<bool>& chosen, int32_t first) {
  std::unordered_map<int32_t, int32_t> number;
  std::vector<int32_t> used;
  for (int32_t v = 0; v < hole.size(); ++v) {
    if (hole.vertices[v] < 0) continue;
    number.emplace(hole.vertices[v], v);
    const std::vector<int32_t>& around = hole.band->At(hole.vertices[v]);
    if (chosen[v]) used.insert(used.end(), around.begin(), around.end());
  }
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  BandTriangles band;
  for (const int32_t t : used) {
    Triangle& out = band.triangles.emplace_back();
    for (int k = 0; k < 3; ++k) {
      const int32_t v = hole.cell->band.triangles[t][k];
      const auto [it, fresh] = number.try_emplace(v, first + static_cast<int32_t>(band.others.size()));
      if (fresh) band.others.push_back(v);
      out[k] = it->second;
    }
  }
  return band;
}

}  // namespace tilemend
