#include "common/assemble/fill_level.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <iterator>
#include <map>
#include <numeric>
#include <unordered_map>
#include <utility>

#include "common/assemble/finest_patch.h"
#include "common/assemble/level_outline.h"
#include "common/assemble/level_region.h"
#include "common/assemble/plan_view.h"
#include "common/mesh/clear_area.h"
#include "common/mesh/triangulation/region_triangulation.h"
#include "common/mesh/winding/wound_region.h"

namespace tilemend {
namespace {

// The strip along a rim in which water may rise to it, as a share of the level's edges.
constexpr double kStripOfRim = 0.0625;

class LevelFiller {
 public:
  LevelFiller(const TriMesh& level, const TriMesh& finest, const FilePatch& patch, const TriMesh& cleared)
      : level_(level),
        patch_(patch),
        cleared_(cleared),
        outline_(level, finest, patch, cleared),
        finest_patch_(outline_.finest_patch()),
        on_patch_(outline_.on_patch()),
        on_cleared_(outline_.on_cleared()),
        edge_(outline_.edge()),
        region_(outline_.region()),
        nearest_(patch.new_points),
        nearest_cleared_(cleared.points) {}

  LevelFill Run() {
    const std::vector<RegionBoundary> boundaries = outline_.Boundaries();
    if (boundaries.empty()) return {{}, outline_.open()};
    const std::vector<int32_t> free = FreePoints(boundaries);
    for (const RegionBoundary& boundary : boundaries) {
      const RegionTriangulation mesh =
          region_.Triangulated(boundary, boundaries.size() > 1 ? Near(boundary, free) : free);
      const std::vector<bool> is_wanted = WantedComponents(mesh);
      for (size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (is_wanted[mesh.component[t]]) AddTriangle(mesh.triangles[t]);
      }
    }
    return {Finish(), outline_.open()};
  }

 private:
  bool HasCleared() const { return !cleared_.triangles.empty(); }

  // Inserted in the region: vertices of the finest patch at the level's spacing, and along the rim what keeps the
  // surface as it is there. Beyond the patch the surface is as it was before it was cleared.
  std::vector<int32_t> FreePoints(const std::vector<RegionBoundary>& boundaries) {
    const double rim = finest_patch_.rim_edge();
    VertexThinning thinning(rim > 0 ? std::max(1.0, edge_ / rim) : 1, edge_);
    free_first_ = static_cast<int32_t>(region_.points().size());
    for (const RegionBoundary& boundary : boundaries) {
      for (const DirectedEdge& s : boundary) {
        thinning.Take(region_.At(s.from), rim);
        AddBesideRim(s);
      }
    }
    if (HasCleared()) AddRimOfPatch(thinning);
    for (size_t i = 0; i < patch_.new_points.size(); ++i) {
      const Point3& p = patch_.new_points[i];
      if (thinning.Take(p.head<2>(), finest_patch_.EdgeAt(i))) AddFree(p, static_cast<int32_t>(i));
    }
    for (const Point3& p : cleared_.points) {
      if (!on_patch_.Covers(p.head<2>()) && thinning.Take(p.head<2>(), 0)) AddFree(p, -1);
    }
    std::vector<int32_t> points(free_.size());
    std::iota(points.begin(), points.end(), free_first_);
    return points;
  }

  // Those of `points` in the box of a boundary.
  std::vector<int32_t> Near(const RegionBoundary& boundary, const std::vector<int32_t>& points) const {
    Eigen::AlignedBox2d box;
    for (const DirectedEdge& s : boundary) box.extend(region_.At(s.from));
    std::vector<int32_t> near;
    std::copy_if(points.begin(), points.end(), std::back_inserter(near),
                 [&](int32_t v) { return box.contains(region_.At(v)); });
    return near;
  }

  void AddFree(const Point3& p, int32_t source) {
    region_.Add(p.head<2>());
    free_.push_back({p.z(), source});
  }

  // Water is level up to its rim: two vertices beside each edge of the rim. What was cleared may reach further than the
  // water does.
  void AddBesideRim(const DirectedEdge& s) {
    const Point2 a = region_.At(s.from), b = region_.At(s.to), along = b - a;
    const int32_t nearest = nearest_.Of((a + b) / 2);
    if (nearest < 0 || !finest_patch_.IsLevelAt(static_cast<size_t>(nearest)) || along.norm() == 0) return;
    const Point2 inward = kStripOfRim * edge_ * Point2(-along.y(), along.x()).normalized();
    for (const Point2& end : {a, b}) {
      const Point2 p = end + inward;
      if (on_cleared_.Covers(p) && !on_patch_.Covers(p)) continue;
      AddFree({p.x(), p.y(), patch_.new_points[static_cast<size_t>(nearest)].z()}, nearest);
    }
  }

  // A cleared triangle may reach beyond the finest patch: there the patch ends in the region, at vertices of its rim.
  void AddRimOfPatch(VertexThinning& thinning) {
    for (const RegionLoop& loop : LoopsBetween(outline_.footprint(), {})) {
      const RegionLoop rim = Spaced(loop);
      for (const DirectedEdge& s : SegmentsOf({rim})) {
        if (!on_cleared_.Covers(region_.At(s.from)) || !on_cleared_.Covers(region_.At(s.to))) continue;
        for (const int32_t v : {s.from, s.to}) {
          thinning.Take(region_.At(v), 0);
          if (const Point3* place = outline_.PlaceOf(v)) AddFree(*place, -1);
        }
        AddBesideRim(s);
      }
    }
  }

  // Points of a loop that are as far from each other along it as the level's edges are long, or a third of the loop.
  RegionLoop Spaced(const RegionLoop& loop) const {
    double length = 0;
    for (const DirectedEdge& s : SegmentsOf({loop})) length += (region_.At(s.to) - region_.At(s.from)).norm();
    const double spacing = std::min(edge_, length / 3);
    RegionLoop spaced;
    double walked = spacing;
    for (const DirectedEdge& s : SegmentsOf({loop})) {
      if (walked >= spacing) {
        spaced.push_back(s.from);
        walked = 0;
      }
      walked += (region_.At(s.to) - region_.At(s.from)).norm();
    }
    return spaced;
  }

  // Components that lie somewhere on the finest patch or where the level was cleared. Others are holes that the level
  // has beside the patch, where the finest level has none.
  std::vector<bool> WantedComponents(const RegionTriangulation& mesh) const {
    std::vector<bool> wanted(static_cast<size_t>(mesh.component_count), false);
    for (size_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto component = static_cast<size_t>(mesh.component[t]);
      if (!wanted[component]) wanted[component] = MeetsPatch(mesh.triangles[t]);
    }
    return wanted;
  }

  bool MeetsPatch(const Triangle& t) const {
    const TrianglePoints points = PointsIn(region_.At(t[0]), region_.At(t[1]), region_.At(t[2]));
    return std::ranges::any_of(points, [&](const Point2& p) { return on_patch_.Covers(p) || on_cleared_.Covers(p); });
  }

  // The number of a point of the region among the level's vertices and the new ones.
  int32_t NumberOf(int32_t v) {
    if (const int32_t of_level = outline_.LevelVertexAt(v); of_level >= 0) return of_level;
    const auto [at, fresh] = number_.emplace(v, static_cast<int32_t>(level_.points.size() + result_.new_points.size()));
    if (!fresh) return at->second;
    const bool is_free = v >= free_first_;
    result_.new_points.push_back(is_free ? AtHeight(v, free_[v - free_first_].height) : OnBoundary(v));
    result_.like.push_back(-1);
    source_.push_back(is_free ? free_[v - free_first_].source : nearest_.Of(region_.At(v)));
    return at->second;
  }

  Point3 AtHeight(int32_t v, double height) const {
    const Point2 p = region_.At(v);
    return {p.x(), p.y(), height};
  }

  // A point of the region's boundary. If no outline has it, with the height of what is near: of the patch, or of what
  // was cleared beyond it; of the patch's rim if the patch has no new vertices.
  Point3 OnBoundary(int32_t v) const {
    if (const Point3* place = outline_.PlaceOf(v)) return *place;
    const Point2 p = region_.At(v), margin(edge_, edge_);
    const int32_t nearest = nearest_.Of(p), cleared = nearest_cleared_.Of(p);
    if (cleared >= 0 && !on_patch_.Meets({p - margin, p + margin})) return AtHeight(v, cleared_.points[cleared].z());
    if (nearest >= 0) return AtHeight(v, patch_.new_points[nearest].z());
    const std::vector<Point3>& places = outline_.places_of_patch();
    return AtHeight(v, places[NearestPosition(places).Of(p)].z());
  }

  void AddTriangle(const Triangle& t) { result_.triangles.push_back({NumberOf(t[0]), NumberOf(t[1]), NumberOf(t[2])}); }

  // The triangles by their materials.
  FilePatch Finish() {
    if (patch_.materials.empty() || result_.triangles.empty()) return std::move(result_);
    std::map<int32_t, std::vector<Triangle>> by_run;
    for (const Triangle& t : result_.triangles) by_run[RunOf(t)].push_back(t);
    result_.triangles.clear();
    for (const auto& [run, triangles] : by_run) {
      result_.materials.push_back(
          {static_cast<int32_t>(result_.triangles.size()), patch_.materials[static_cast<size_t>(run)].material});
      result_.triangles.insert(result_.triangles.end(), triangles.begin(), triangles.end());
    }
    return std::move(result_);
  }

  int32_t RunOf(const Triangle& t) const {
    for (const int32_t v : t) {
      const int64_t fresh = v - static_cast<int64_t>(level_.points.size());
      if (fresh >= 0 && source_[fresh] >= 0) return finest_patch_.RunAt(static_cast<size_t>(source_[fresh]));
    }
    Point2 middle(0, 0);
    for (const int32_t v : t) {
      const int64_t fresh = v - static_cast<int64_t>(level_.points.size());
      middle += (fresh >= 0 ? result_.new_points[fresh] : level_.points[v]).head<2>() / 3;
    }
    const int32_t nearest = nearest_.Of(middle);
    return nearest >= 0 ? finest_patch_.RunAt(static_cast<size_t>(nearest)) : 0;
  }

  // A point inside the region.
  struct FreePoint {
    double height = 0;
    int32_t source = -1;  // the new point of the patch that it is from; -1: none
  };

  const TriMesh& level_;
  const FilePatch& patch_;
  const TriMesh& cleared_;
  LevelOutline outline_;
  const FinestPatch& finest_patch_;
  const PlanView &on_patch_, &on_cleared_;
  const double edge_;  // of the level beside the patch, metres
  LevelRegion& region_;
  const NearestPosition nearest_, nearest_cleared_;
  int32_t free_first_ = 0;  // number of a point of the region
  std::vector<FreePoint> free_;
  std::unordered_map<int32_t, int32_t> number_;
  std::vector<int32_t> source_;  // the new point of the patch that a new point of the level is from; -1: none
  FilePatch result_;
};

}  // namespace

LevelFill FillLevel(const TriMesh& level, const TriMesh& finest, const FilePatch& patch, const TriMesh& cleared) {
  if (patch.triangles.empty() || (level.triangles.empty() && cleared.triangles.empty())) return {};
  return LevelFiller(level, finest, patch, cleared).Run();
}

}  // namespace tilemend
