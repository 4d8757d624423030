#include "common/assemble/fill_level.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <numeric>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "common/assemble/finest_patch.h"
#include "common/assemble/level_region.h"
#include "common/mesh/bin_grid.h"
#include "common/mesh/triangulation/region_triangulation.h"

namespace tilemend {
namespace {

// The strip along a rim in which water may rise to it, as a share of the level's edges.
constexpr double kStripOfRim = 0.0625;

// The region reaches an edge beyond the finest patch.
constexpr double kReachInEdges = 2;

Eigen::AlignedBox2d BoxOf(const Triangle& t, const std::function<Point3(int32_t)>& point_of) {
  Eigen::AlignedBox2d box;
  for (const int32_t v : t) box.extend(Point2(point_of(v).head<2>()));
  return box;
}

// Finds what lies near the triangles of a patch.
class PatchPlaces {
 public:
  PatchPlaces(const FilePatch& patch, const FinestPatch& finest) {
    for (const Triangle& t : patch.triangles) {
      boxes_.push_back(BoxOf(t, [&](int32_t v) { return finest.At(v); }));
      extent_.extend(boxes_.back());
    }
    const double side = std::max(extent_.sizes().maxCoeff(), 1e-3);
    grid_.emplace(extent_, side / std::sqrt(static_cast<double>(boxes_.size())), static_cast<int32_t>(boxes_.size()),
                  [&](int32_t i) { return boxes_[static_cast<size_t>(i)]; });
  }

  // The triangles of a mesh whose boxes come within `reach` metres of the box of a triangle of the patch.
  std::vector<Triangle> TrianglesNear(const TriMesh& mesh, double reach) const {
    const Point2 margin(reach, reach);
    std::vector<Triangle> near;
    for (const Triangle& t : mesh.triangles) {
      Eigen::AlignedBox2d box = BoxOf(t, [&](int32_t v) { return mesh.points[v]; });
      box = {box.min() - margin, box.max() + margin};
      if (box.intersects(extent_) && Meets(box)) near.push_back(t);
    }
    return near;
  }

 private:
  bool Meets(const Eigen::AlignedBox2d& box) const {
    bool meets = false;
    grid_->ForBins(box, [&](int64_t, std::span<const int32_t> things) {
      for (const int32_t i : things) meets = meets || boxes_[static_cast<size_t>(i)].intersects(box);
    });
    return meets;
  }

  std::vector<Eigen::AlignedBox2d> boxes_;
  Eigen::AlignedBox2d extent_;
  std::optional<BinGrid> grid_;
};

// The median edge of triangles seen from above, metres.
double EdgeOf(const TriMesh& mesh, const std::vector<Triangle>& triangles) {
  std::vector<double> lengths;
  for (const Triangle& t : triangles) {
    for (int k = 0; k < 3; ++k) lengths.push_back((mesh.points[t[k]] - mesh.points[t[(k + 1) % 3]]).head<2>().norm());
  }
  return MedianOf(std::move(lengths));
}

class LevelFiller {
 public:
  LevelFiller(const TriMesh& level, const TriMesh& finest, const FilePatch& patch)
      : level_(level),
        patch_(patch),
        finest_patch_(finest, patch),
        places_(patch, finest_patch_),
        edge_(EdgeBeside(level)),
        level_outline_(OutlineNear(level)),
        finest_outline_(OutlineNear(finest)),
        patch_outline_(SurfaceOutlineOf(patch.triangles, [&](int32_t v) { return finest_patch_.At(v); })),
        region_(Window()),
        nearest_(patch.new_points) {}

  FilePatch Run() {
    const std::vector<DirectedEdge> segments = Region();
    if (segments.empty()) return {};
    const RegionTriangulation mesh = Triangulated(segments, FreePoints(segments));
    std::vector<bool> is_wanted = WantedComponents(mesh);
    for (size_t t = 0; t < mesh.triangles.size(); ++t) {
      if (is_wanted[mesh.component[t]]) AddTriangle(mesh.triangles[t]);
    }
    return Finish();
  }

 private:
  LatticeWindow Window() const {
    Eigen::AlignedBox2d box;
    for (const SurfaceOutline* outline : {&level_outline_, &finest_outline_, &patch_outline_}) {
      for (const Point3& p : outline->positions) box.extend(Point2(p.head<2>()));
    }
    for (const Point3& p : patch_.new_points) box.extend(Point2(p.head<2>()));
    return {box.min(), box.max()};
  }

  // The edges of the level beside the patch are this long, metres.
  double EdgeBeside(const TriMesh& level) const {
    const std::vector<Triangle> beside = places_.TrianglesNear(level, 0);
    return EdgeOf(level, beside.empty() ? level.triangles : beside);
  }

  // Of the surface that matters: what is further away than a few edges cannot be part of the region. The outline of a
  // part of a surface closes as well.
  SurfaceOutline OutlineNear(const TriMesh& mesh) const {
    const std::vector<Triangle> near = places_.TrianglesNear(mesh, kReachInEdges * edge_);
    return SurfaceOutlineOf(near, [&](int32_t v) { return mesh.points[v]; });
  }

  std::vector<DirectedEdge> Region() {
    const int32_t level_first = region_.AddAll(level_outline_);
    patch_first_ = region_.AddAll(patch_outline_);
    const int32_t finest_first = region_.AddAll(finest_outline_);
    footprint_ = region_.Simple(EdgesFrom(patch_outline_, patch_first_));
    if (footprint_.empty()) return {};
    const auto covered = region_.Simple(EdgesFrom(level_outline_, level_first));
    const auto fine = region_.Simple(EdgesFrom(finest_outline_, finest_first));
    const auto either = region_.Either(footprint_, fine);
    const auto near = region_.Both(region_.Grown(footprint_, edge_), either);
    return Thinned(region_.AtFirstPoints(region_.Without(near, covered)));
  }

  bool IsLevelVertex(int32_t v) const { return v < patch_first_; }

  // The region's boundary without those of its own corners that lie closer than the level's edges are long.
  std::vector<DirectedEdge> Thinned(const std::vector<DirectedEdge>& segments) {
    // Loops come one after the other, each from its first segment on.
    std::vector<DirectedEdge> thinned;
    VertexThinning thinning(1, edge_);
    for (size_t i = 0; i < segments.size();) {
      size_t end = i + 1;
      while (end < segments.size() && segments[end].from == segments[end - 1].to) ++end;
      std::vector<int32_t> loop;
      for (size_t s = i; s < end; ++s) {
        const int32_t v = segments[s].from;
        const int32_t before = segments[s == i ? end - 1 : s - 1].from;
        const bool is_end = IsLevelVertex(before) != IsLevelVertex(v) || IsLevelVertex(segments[s].to);
        if (IsLevelVertex(v) || is_end || thinning.Take(region_.At(v), edge_)) loop.push_back(v);
      }
      for (size_t k = 0; loop.size() >= 3 && k < loop.size(); ++k) {
        thinned.push_back({loop[k], loop[(k + 1) % loop.size()]});
      }
      i = end;
    }
    return Triangulated(thinned, {}).conflicts.empty() ? thinned : segments;
  }

  // The region between segments. Of the points that no segment uses only those of `free` are inserted.
  RegionTriangulation Triangulated(const std::vector<DirectedEdge>& segments, const std::vector<int32_t>& free) const {
    std::vector<int32_t> used = free;
    for (const DirectedEdge& s : segments) used.push_back(s.from);
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    const auto place = [&](int32_t v) {
      return static_cast<int32_t>(std::lower_bound(used.begin(), used.end(), v) - used.begin());
    };
    std::vector<LatticePoint> points;
    for (const int32_t v : used) points.push_back(region_.points()[v]);
    std::vector<RegionSegment> between;
    for (const DirectedEdge& s : segments) between.push_back({place(s.from), place(s.to)});
    RegionTriangulation mesh = TriangulateRegion(points, between);
    for (Triangle& t : mesh.triangles) t = {used[t[0]], used[t[1]], used[t[2]]};
    return mesh;
  }

  // Inserted in the region: vertices of the finest patch at the level's spacing, and along the rim what keeps the
  // surface as it is there.
  std::vector<int32_t> FreePoints(const std::vector<DirectedEdge>& segments) {
    const double rim = finest_patch_.rim_edge();
    VertexThinning thinning(rim > 0 ? std::max(1.0, edge_ / rim) : 1, edge_);
    free_first_ = static_cast<int32_t>(region_.points().size());
    for (const DirectedEdge& s : segments) {
      thinning.Take(region_.At(s.from), rim);
      AddBesideRim(s);
    }
    for (size_t i = 0; i < patch_.new_points.size(); ++i) {
      const Point2 p = patch_.new_points[i].head<2>();
      if (thinning.Take(p, finest_patch_.EdgeAt(i))) AddFree(p, static_cast<int32_t>(i));
    }
    std::vector<int32_t> points(free_.size());
    std::iota(points.begin(), points.end(), free_first_);
    return points;
  }

  void AddFree(const Point2& p, int32_t source) {
    region_.Add(p);
    free_.push_back(source);
  }

  // Water is level up to its rim: two vertices beside each edge of the rim.
  void AddBesideRim(const DirectedEdge& s) {
    const Point2 a = region_.At(s.from), b = region_.At(s.to), along = b - a;
    const int32_t nearest = nearest_.Of((a + b) / 2);
    if (nearest < 0 || !finest_patch_.IsLevelAt(static_cast<size_t>(nearest)) || along.norm() == 0) return;
    const Point2 inward = kStripOfRim * edge_ * Point2(-along.y(), along.x()).normalized();
    for (const Point2& end : {a, b}) AddFree(end + inward, nearest);
  }

  // Components that lie on the finest patch for the most part.
  std::vector<bool> WantedComponents(const RegionTriangulation& mesh) {
    const RegionTriangulation inside = Triangulated(footprint_, {});
    std::vector<Triangle> footprint = inside.triangles;
    std::vector<double> on(mesh.component_count, 0), all(mesh.component_count, 0);
    Eigen::AlignedBox2d extent;
    const auto box_of = [&](int32_t i) {
      Eigen::AlignedBox2d box;
      for (const int32_t v : footprint[i]) box.extend(region_.At(v));
      return box;
    };
    for (int32_t i = 0; i < std::ssize(footprint); ++i) extent.extend(box_of(i));
    if (footprint.empty()) return std::vector<bool>(mesh.component_count, false);
    const double step = std::max(extent.sizes().maxCoeff() / std::sqrt(static_cast<double>(footprint.size())), 1e-3);
    const BinGrid grid(extent, step, static_cast<int32_t>(footprint.size()), box_of);
    for (size_t t = 0; t < mesh.triangles.size(); ++t) {
      const Triangle& triangle = mesh.triangles[t];
      const Point2 a = region_.At(triangle[0]), b = region_.At(triangle[1]), c = region_.At(triangle[2]);
      const Point2 u = b - a, v = c - a;
      const double area = u.x() * v.y() - u.y() * v.x();
      all[mesh.component[t]] += area;
      if (Covers(grid, footprint, (a + b + c) / 3)) on[mesh.component[t]] += area;
    }
    std::vector<bool> wanted;
    for (int32_t i = 0; i < mesh.component_count; ++i) wanted.push_back(on[i] > 0.5 * all[i]);
    return wanted;
  }

  bool Covers(const BinGrid& grid, std::span<const Triangle> triangles, const Point2& p) const {
    for (const int32_t i : grid.In(Eigen::AlignedBox2d(p))) {
      const Triangle& t = triangles[i];
      bool inside = true;
      for (int k = 0; k < 3 && inside; ++k) {
        const Point2 a = region_.At(t[k]), d = region_.At(t[(k + 1) % 3]) - a, e = p - a;
        inside = d.x() * e.y() - d.y() * e.x() >= 0;
      }
      if (inside) return true;
    }
    return false;
  }

  // The number of a point of the region among the level's vertices and the new ones.
  int32_t NumberOf(int32_t v) {
    if (IsLevelVertex(v)) return level_outline_.vertex[v];
    const auto [at, fresh] = number_.emplace(v, static_cast<int32_t>(level_.points.size() + result_.new_points.size()));
    if (!fresh) return at->second;
    const int32_t nearest = v >= free_first_ ? free_[v - free_first_] : nearest_.Of(region_.At(v));
    Point3 p = nearest >= 0 ? patch_.new_points[nearest] : HeightOfRim(v);
    p.head<2>() = region_.At(v);
    if (IsPatchVertex(v)) p = patch_outline_.positions[v - patch_first_];
    result_.new_points.push_back(p);
    result_.like.push_back(-1);
    source_.push_back(nearest);
    return at->second;
  }

  bool IsPatchVertex(int32_t v) const {
    return v >= patch_first_ && v < patch_first_ + static_cast<int32_t>(patch_outline_.positions.size());
  }

  // The place of a point with the height of the nearest vertex on the patch's rim: for a patch without new vertices.
  Point3 HeightOfRim(int32_t v) const {
    const Point2 p = region_.At(v);
    const int32_t nearest = NearestPosition(patch_outline_.positions).Of(p);
    return {p.x(), p.y(), patch_outline_.positions[nearest].z()};
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

  const TriMesh& level_;
  const FilePatch& patch_;
  const FinestPatch finest_patch_;
  const PatchPlaces places_;
  const double edge_;  // of the level beside the patch, metres
  const SurfaceOutline level_outline_, finest_outline_, patch_outline_;
  LevelRegion region_;
  const NearestPosition nearest_;
  std::vector<DirectedEdge> footprint_;
  int32_t patch_first_ = 0, free_first_ = 0;  // numbers of points of the region
  std::vector<int32_t> free_;                 // new points of the patch
  std::unordered_map<int32_t, int32_t> number_;
  std::vector<int32_t> source_;  // the new point of the patch that a new point of the level is from; -1: none
  FilePatch result_;
};

}  // namespace

FilePatch FillLevel(const TriMesh& level, const TriMesh& finest, const FilePatch& patch) {
  if (patch.triangles.empty() || level.triangles.empty()) return {};
  return LevelFiller(level, finest, patch).Run();
}

}  // namespace tilemend
