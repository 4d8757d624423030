#include "coordinator/plan/hole/hole_regions.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <numeric>
#include <set>
#include <unordered_map>
#include <utility>

#include "coordinator/plan/hole/region_shape.h"

namespace tilemend {
namespace {

// A loop is the outline of a detached piece, and no hole in it, if it runs the wrong way round by this much: the cosine
// between its vector area and the normals along it. A hole gives about +1, a flat piece -1, the open end of a dome
// something near 0.
constexpr double kOuterRim = -0.3;
// A closed hole is filled over the plane if the surface along it faces up by this much.
constexpr double kFacesUp = 0.2;
// So many normals of a wall do not point up by chance.
constexpr int kTellingEdges = 8;
// A piece that lies in a hole faces the way of the hole by this much.
constexpr double kFacesAlike = 0.2;
// No surface is taken to rise from the rim of a hole more steeply than this.
constexpr double kSteepestRise = 3;

constexpr char kFolds[] = "its boundary crosses itself seen from above, so it cannot be filled as heights";
constexpr char kUnbounded[] =
    "it reaches the rim of the area, which is not known: name the area's cells in scene.json to fill it";

struct ClosedLoop {
  std::vector<RimSegment> segments;
  Eigen::Vector3d vector_area{0, 0, 0};
  Eigen::Vector3d normal{0, 0, 0};  // mean along the loop
  bool faces_up = false;
  bool outer_rim = false;
};

class HoleFinder {
 public:
  HoleFinder(const CellBoundary& boundary, const std::set<CellId>& area, const CutLines& lines, const Rim& rim,
             const std::vector<Point3>& position)
      : boundary_(boundary), area_(area), lines_(lines), rim_(rim), position_(position) {}

  RegionResult Run() {
    FindOpen(WithoutDoubled(boundary_.open), true);
    FindClosed();
    return std::move(result_);
  }

 private:
  // Without segments that are there both ways, where two seams or a seam and the rim pass over the same vertices:
  // nothing lies between, and the cells beyond close on each other.
  static std::vector<BoundarySegment> WithoutDoubled(const std::vector<BoundarySegment>& open) {
    std::set<std::pair<int32_t, int32_t>> directed;
    for (const BoundarySegment& s : open) directed.insert({s.segment.from, s.segment.to});
    std::vector<BoundarySegment> single;
    std::copy_if(open.begin(), open.end(), std::back_inserter(single), [&](const BoundarySegment& s) {
      return !directed.contains({s.segment.to, s.segment.from});
    });
    return single;
  }

  // Holes of the open segments; if they cross somewhere, each connected group on its own, so that a bad hole fails
  // alone.
  void FindOpen(const std::vector<BoundarySegment>& open, bool may_split) {
    if (open.empty()) return;
    std::vector<RimSegment> segments;
    for (const BoundarySegment& s : open) segments.push_back(s.segment);
    PlanarRegions regions = FindPlanarRegions(segments, position_);
    if (!regions.triangulation.conflicts.empty()) {
      const auto groups = may_split ? Groups(open) : std::vector<std::vector<BoundarySegment>>{};
      if (groups.size() > 1) {
        for (const auto& group : groups) FindOpen(group, false);
      } else {
        const bool crossing =
            std::any_of(regions.triangulation.conflicts.begin(), regions.triangulation.conflicts.end(),
                        [](const RegionConflict& c) { return c.kind != RegionConflict::Kind::kInsideOut; });
        if (crossing && boundary_.seam_failure.empty() && IsBalanced(open)) {
          AddFolded(open);
          return;
        }
        AddFailedOpen(open, crossing ? kFolds : boundary_.seam_failure.empty() ? kUnbounded : boundary_.seam_failure);
      }
      return;
    }
    std::vector<std::vector<BoundarySegment>> parts(regions.area.size());
    for (size_t i = 0; i < open.size(); ++i) {
      const int32_t triangle = regions.triangulation.segment_triangle[i];
      parts[regions.triangulation.component[triangle]].push_back(open[i]);
    }
    for (size_t c = 0; c < parts.size(); ++c) {
      open_places_.emplace_back(open_regions_.size(), static_cast<int32_t>(c));
      open_holes_.push_back(result_.holes.size());
      AddOpen(parts[c], regions.area[c]);
    }
    open_regions_.push_back(std::move(regions));
  }

  // Whether as many segments end at every vertex as begin there, so that they form loops.
  static bool IsBalanced(const std::vector<BoundarySegment>& open) {
    std::unordered_map<int32_t, int32_t> balance;
    for (const BoundarySegment& s : open) {
      ++balance[s.segment.from];
      --balance[s.segment.to];
    }
    return std::all_of(balance.begin(), balance.end(), [](const auto& b) { return b.second == 0; });
  }

  // A hole whose boundary crosses itself seen from above: the filler cuts the folds off. Its area is that of the
  // boundary's projection.
  void AddFolded(const std::vector<BoundarySegment>& part) {
    PlannedHole hole = NewOpen(part);
    hole.projects = false;
    hole.area = std::abs(VectorArea(hole.segments, position_).z());
    result_.holes.push_back(std::move(hole));
  }

  // Connected groups of segments, by shared vertices, in order of their first segment.
  static std::vector<std::vector<BoundarySegment>> Groups(const std::vector<BoundarySegment>& open) {
    std::unordered_map<int32_t, size_t> last_at;
    std::vector<size_t> parent(open.size());
    std::iota(parent.begin(), parent.end(), size_t{0});
    const auto find = [&](size_t i) {
      while (parent[i] != i) i = parent[i] = parent[parent[i]];
      return i;
    };
    for (size_t i = 0; i < open.size(); ++i) {
      for (const int32_t v : {open[i].segment.from, open[i].segment.to}) {
        const auto [it, fresh] = last_at.try_emplace(v, i);
        if (fresh) continue;
        const size_t a = find(i), b = find(it->second);
        parent[std::max(a, b)] = std::min(a, b);
      }
    }
    std::vector<std::vector<BoundarySegment>> groups;
    std::unordered_map<size_t, size_t> group_of;
    for (size_t i = 0; i < open.size(); ++i) {
      const auto [it, fresh] = group_of.try_emplace(find(i), groups.size());
      if (fresh) groups.emplace_back();
      groups[it->second].push_back(open[i]);
    }
    return groups;
  }

  PlannedHole NewHole(std::vector<RimSegment> segments) const {
    PlannedHole hole;
    hole.cell = boundary_.cell;
    Point2 sum{0, 0};
    for (const RimSegment& s : segments) {
      sum += position_[s.from].head<2>();
      if (s.seam) continue;
      hole.perimeter += (position_[s.to] - position_[s.from]).norm();
      ++hole.boundary_vertices;
    }
    hole.centre = sum / static_cast<double>(segments.size());
    hole.segments = std::move(segments);
    return hole;
  }

  PlannedHole NewOpen(const std::vector<BoundarySegment>& part) const {
    std::vector<RimSegment> segments;
    bool external = false;
    for (const BoundarySegment& s : part) {
      segments.push_back(s.segment);
      external |= s.side >= 0 && !area_.contains(s.across);
    }
    PlannedHole hole = NewHole(std::move(segments));
    hole.kind = external ? HoleKind::kOpenII : HoleKind::kOpenI;
    hole.type = ClassifyOpen(part, boundary_.cell, boundary_.has_surface, lines_, position_);
    return hole;
  }

  void AddOpen(const std::vector<BoundarySegment>& part, double area) {
    PlannedHole hole = NewOpen(part);
    hole.area = area;
    result_.holes.push_back(std::move(hole));
  }

  void AddFailedOpen(const std::vector<BoundarySegment>& part, const std::string& reason) {
    PlannedHole hole = NewOpen(part);
    hole.projects = false;
    hole.failure = reason;
    result_.holes.push_back(std::move(hole));
  }

  void FindClosed() {
    std::vector<ClosedLoop> holes, outlines;
    for (const std::vector<RimSegment>& loop : boundary_.closed_loops) {
      ClosedLoop c;
      c.segments = loop;
      c.vector_area = VectorArea(loop, position_);
      for (const RimSegment& s : loop) c.normal += rim_.points[s.from].normal.normalized();
      if (c.normal.norm() > 0) c.normal.normalize();
      c.faces_up = c.normal.z() > kFacesUp;
      const double along = c.vector_area.dot(c.normal), up = c.vector_area.z();
      c.outer_rim = along < kOuterRim * c.vector_area.norm();
      // Of heights, however steep, the way around seen from above tells a hole from an outline. Along few edges of a
      // rough wall all normals may point up by chance.
      const bool many = static_cast<int>(loop.size()) >= kTellingEdges;
      const bool doubtful = c.outer_rim != (up < 0) && (many || std::abs(up) > std::abs(along));
      if ((!c.faces_up || doubtful) && BoundsHeights(c)) {
        c.faces_up = true;
        if (doubtful) c.outer_rim = up < 0;
      }
      (c.outer_rim ? outlines : holes).push_back(std::move(c));
    }
    std::vector<PlanarRegions> regions(holes.size());
    std::vector<std::vector<std::vector<RimSegment>>> islands(holes.size());
    for (size_t i = 0; i < holes.size(); ++i) {
      if (holes[i].faces_up && holes[i].vector_area.z() > 0) {
        regions[i] = FindPlanarRegions(holes[i].segments, position_);
      }
    }
    for (const ClosedLoop& outline : outlines) Place(outline, holes, regions, islands);
    for (size_t i = 0; i < holes.size(); ++i) AddClosed(holes[i], regions[i], islands[i]);
  }

  // Whether the surface along a loop faces up, and the loop does not cross itself seen from above.
  bool BoundsHeights(const ClosedLoop& loop) const {
    if (std::any_of(loop.segments.begin(), loop.segments.end(),
                    [&](const RimSegment& s) { return rim_.points[s.from].normal.z() <= 0; })) {
      return false;
    }
    std::vector<RimSegment> around = loop.segments;
    if (loop.vector_area.z() < 0) {
      for (RimSegment& s : around) std::swap(s.from, s.to);
    }
    return FindPlanarRegions(around, position_).triangulation.conflicts.empty();
  }

  // Makes the outline of a piece an island of the hole that it lies in; without one it is an outer rim.
  void Place(const ClosedLoop& outline, const std::vector<ClosedLoop>& holes, std::vector<PlanarRegions>& closed,
             std::vector<std::vector<std::vector<RimSegment>>>& islands) {
    const Point2 p = position_[outline.segments[0].from].head<2>();
    if (outline.faces_up) {
      for (size_t i = 0; i < open_places_.size(); ++i) {
        if (!Contains(open_regions_[open_places_[i].first], open_places_[i].second, p, position_)) continue;
        PlannedHole& hole = result_.holes[open_holes_[i]];
        hole.segments.insert(hole.segments.end(), outline.segments.begin(), outline.segments.end());
        hole.area += outline.vector_area.z();  // negative
        return;
      }
      for (size_t i = 0; i < closed.size(); ++i) {
        if (!closed[i].triangulation.triangles.empty() && Contains(closed[i], 0, p, position_)) {
          islands[i].push_back(outline.segments);
          return;
        }
      }
    }
    for (size_t i = 0; i < closed.size(); ++i) {
      if (!LiesIn(outline, holes[i])) continue;
      islands[i].push_back(outline.segments);
      closed[i] = {};  // with the piece it does not project
      return;
    }
    ++result_.outer_rims;
    result_.left.push_back({boundary_.cell, "the outline of a detached piece of surface, not a hole in it", -1,
                            static_cast<int64_t>(outline.segments.size()), false});
  }

  Point3 MiddleOf(const ClosedLoop& loop) const {
    Point3 middle = Point3::Zero();
    for (const RimSegment& s : loop.segments) middle += position_[s.from] / static_cast<double>(loop.segments.size());
    return middle;
  }

  // How far the surface rises inside a hole, along its normal, if it goes on from the rim as it leans there: positive
  // over the corner of a box, negative in a pit.
  double RiseIn(const ClosedLoop& hole) const {
    const Eigen::Vector3d normal = hole.vector_area.normalized();
    const Point3 middle = MiddleOf(hole);
    double slope = 0;
    for (const RimSegment& s : hole.segments) {
      Eigen::Vector3d outward = position_[s.from] - middle;
      outward -= outward.dot(normal) * normal;
      const Eigen::Vector3d& n = rim_.points[s.from].normal;
      const double up = n.dot(normal), out = outward.norm() > 0 ? n.dot(outward.normalized()) : 0;
      if (out != 0) slope += out / std::max(up, std::abs(out) / kSteepestRise);
    }
    slope /= static_cast<double>(hole.segments.size());
    return slope * std::sqrt(hole.vector_area.norm() / std::numbers::pi);
  }

  // Whether a piece lies in a hole: smaller than it, within its boundary seen along its normal, facing the same way,
  // and between the boundary and where the surface that leans in from there would be, give or take an edge's length.
  bool LiesIn(const ClosedLoop& piece, const ClosedLoop& hole) const {
    if (piece.vector_area.norm() >= hole.vector_area.norm()) return false;
    const Point3 p = MiddleOf(piece);
    const Eigen::Vector3d normal = hole.vector_area.normalized();
    if (piece.normal.dot(normal) <= kFacesAlike) return false;
    double angle = 0, edge = 0, below = INFINITY, above = -INFINITY;
    for (const RimSegment& s : hole.segments) {
      const Eigen::Vector3d a = position_[s.from] - p, b = position_[s.to] - p;
      const double off = a.dot(normal);
      const Eigen::Vector3d u = a - off * normal, v = b - b.dot(normal) * normal;
      angle += std::atan2(u.cross(v).dot(normal), u.dot(v));
      edge += (b - a).norm() / static_cast<double>(hole.segments.size());
      below = std::min(below, off);
      above = std::max(above, off);
    }
    const double rise = RiseIn(hole);
    return angle > std::numbers::pi && below + std::min(rise, 0.0) < edge && above + std::max(rise, 0.0) > -edge;
  }

  void AddClosed(const ClosedLoop& loop, const PlanarRegions& regions,
                 const std::vector<std::vector<RimSegment>>& islands) {
    PlannedHole hole = NewHole(loop.segments);
    hole.projects = !regions.triangulation.triangles.empty();
    hole.area = loop.vector_area.norm();
    hole.single = ClassifySingle(loop.segments, islands, position_);
    if (hole.projects) hole.area = std::accumulate(regions.area.begin(), regions.area.end(), 0.0);
    for (const std::vector<RimSegment>& island : islands) {
      hole.segments.insert(hole.segments.end(), island.begin(), island.end());
      const Eigen::Vector3d area = VectorArea(island, position_);
      hole.area -= hole.projects ? -area.z() : area.norm();
    }
    result_.holes.push_back(std::move(hole));
  }

  const CellBoundary& boundary_;
  const std::set<CellId>& area_;
  const CutLines& lines_;
  const Rim& rim_;
  const std::vector<Point3>& position_;
  RegionResult result_;
  std::vector<PlanarRegions> open_regions_;
  std::vector<std::pair<size_t, int32_t>> open_places_;  // regions, component; one for each open hole that has a region
  std::vector<size_t> open_holes_;                       // its place in result_.holes
};

}  // namespace

RegionResult FindHoles(const CellBoundary& boundary, const std::set<CellId>& area, const CutLines& lines,
                       const Rim& rim, const std::vector<Point3>& position) {
  return HoleFinder(boundary, area, lines, rim, position).Run();
}

}  // namespace tilemend
