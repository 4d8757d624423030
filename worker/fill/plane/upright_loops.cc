#include "worker/fill/plane/upright_loops.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <span>
#include <utility>

#include "common/mesh/box_tree.h"
#include "common/mesh/edge_loops.h"
#include "common/mesh/rounding.h"
#include "common/mesh/triangle_shape.h"
#include "worker/fill/space/height_over.h"
#include "worker/fill/space/patch_edit.h"
#include "worker/fill/space/space_fill.h"

namespace tilemend {
namespace {

// Vertices of a loop that is closed: its triangulation takes the cube of its length.
constexpr size_t kLongestUprightLoop = 60;
constexpr double kLevelArea = 0.5;  // cosine to the vertical

// Whether a loop of segments is a hole in upright surface.
bool IsUpright(const LocalHole& hole, std::span<const int32_t> loop) {
  if (loop.size() < 3 || loop.size() > kLongestUprightLoop) return false;
  Eigen::Vector3d area = Eigen::Vector3d::Zero();
  for (size_t i = 0; i < loop.size(); ++i) {
    const int32_t from = loop[i], to = loop[(i + 1) % loop.size()];
    if (hole.TrianglesBeside(from, to) != 1) return false;
    area += TwiceVectorArea(SpaceTriangle{hole.positions[loop[0]], hole.positions[from], hole.positions[to]});
  }
  // Ground that it touches in a vertex is none of the facade's.
  const auto in_ground =
      std::ranges::count_if(loop, [&](int32_t v) { return hole.on_object.empty() || !hole.on_object[v]; });
  if (in_ground > 1) return false;
  return std::abs(area.z()) < kLevelArea * area.norm();
}

// The hole without some of its segments.
HolePart RestOf(const CellHole& cell_hole, const LocalHole& hole, const std::set<VertexPair>& closed) {
  CellHole rest = cell_hole;
  rest.segments.clear();
  for (size_t k = 0; k < cell_hole.segments.size(); ++k) {
    const RegionSegment& s = hole.segments[k];
    if (!closed.contains({s.from, s.to})) rest.segments.push_back(cell_hole.segments[k]);
  }
  std::map<int32_t, int32_t> number;  // in the hole, of the cell's vertices
  for (int32_t v = 0; v < hole.size(); ++v) number[hole.vertices[v]] = v;
  HolePart part{MakeLocalHole(*hole.cell, *hole.band, rest), {}};
  for (const int32_t v : part.hole.vertices) part.vertices.push_back(number.at(v));
  return part;
}

}  // namespace

std::optional<UprightLoops> CloseUprightLoops(const CellHole& cell_hole, const LocalHole& hole, CrossingCheck& check) {
  std::vector<std::vector<int32_t>> upright;
  for (const std::vector<int32_t>& loop : LoopsOf(hole.segments)) {
    for (std::vector<int32_t>& part : CutWhereItTouches<int32_t>(loop)) {
      if (IsUpright(hole, part)) upright.push_back(std::move(part));
    }
  }
  if (upright.empty()) return std::nullopt;
  CrossingIndex taken(check.Surface());
  std::set<VertexPair> closed, used;
  UprightLoops result;
  for (const std::vector<int32_t>& loop : upright) {
    const std::vector<Triangle> triangles = TriangulateInSpace(hole, loop, used, taken);
    for (const Triangle& t : triangles) {
      taken.Add({hole.positions[t[0]], hole.positions[t[1]], hole.positions[t[2]]});
      for (int k = 0; k < 3; ++k) used.insert(Undirected(t[k], t[(k + 1) % 3]));
    }
    for (size_t i = 0; !triangles.empty() && i < loop.size(); ++i)
      closed.insert({loop[i], loop[(i + 1) % loop.size()]});
    result.triangles.insert(result.triangles.end(), triangles.begin(), triangles.end());
  }
  if (result.triangles.empty()) return std::nullopt;
  result.rest = RestOf(cell_hole, hole, closed);
  return result;
}

void TakeHeights(const LocalHole& hole, const LocalPatch& from, LocalPatch& patch) {
  std::vector<SpaceTriangle> ground;
  double lowest = 0, highest = 0;
  for (const Triangle& t : from.triangles) {
    const SpaceTriangle placed = InSpace(hole, from, t);
    const auto area = TwiceVectorArea(placed);
    if (area.z() <= kFacesUp * area.norm()) continue;
    ground.push_back(placed);
    for (const Point3& p : placed) {
      lowest = std::min(lowest, p.z());
      highest = std::max(highest, p.z());
    }
  }
  const BoxTree tree = TreeOver(ground);
  for (Point3& p : patch.new_points) {
    const Eigen::AlignedBox3d upright{Point3(p.x(), p.y(), lowest), Point3(p.x(), p.y(), highest)};
    tree.AnyMeeting(upright, [&](int32_t t) {
      const double height = HeightOver(ground[t], p);
      if (!std::isfinite(height)) return false;
      p.z() = RoundedToLattice(p.z() + height, hole.cell->lattice_step);
      return true;
    });
  }
}

}  // namespace tilemend
